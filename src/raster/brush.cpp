// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/brush.h"

#include <new>
#include <stdexcept>

namespace c1mesh {
namespace {

void set_source(cairo_t* cairo, const Paint& paint) {
  cairo_set_source_rgba(cairo, paint.rgb[0], paint.rgb[1], paint.rgb[2], paint.opacity);
}

cairo_status_t append(void* out, const unsigned char* data, unsigned int size) {
  try {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

void check_status(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

}  // namespace

Brush::Brush(int width, int height, bool transparent)
    : surface_(cairo_image_surface_create(transparent ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
                                          width, height)),
      cairo_(cairo_create(surface_.get())) {
  check_status(cairo_surface_status(surface_.get()));
  check();
  constexpr double kFlatness = 0.02;  // pixels between a curve and the chords that are painted
  cairo_set_tolerance(cairo(), kFlatness);
  if (transparent) return;
  cairo_set_source_rgb(cairo(), 1, 1, 1);
  cairo_paint(cairo());
}

void Brush::check() const {
  check_status(cairo_status(cairo()));
}

void Brush::fill(const Look& look) {
  if (look.fill.none) return;
  set_source(cairo(), look.fill);
  cairo_set_fill_rule(cairo(), look.even_odd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
  cairo_fill_preserve(cairo());
}

void Brush::stroke(const Look& look) {
  if (look.stroke.none || !(look.stroke_width > 0)) return;
  set_source(cairo(), look.stroke);
  cairo_set_line_width(cairo(), look.stroke_width);
  cairo_set_line_cap(cairo(), look.round_caps ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(cairo(), look.round_joins ? CAIRO_LINE_JOIN_ROUND : CAIRO_LINE_JOIN_MITER);
  cairo_set_dash(cairo(), look.dashes.data(), static_cast<int>(look.dashes.size()), 0);
  cairo_stroke_preserve(cairo());
}

void Brush::paint(const Look& look) {
  if (look.stroke_first) {
    stroke(look);
    fill(look);
  } else {
    fill(look);
    stroke(look);
  }
  cairo_new_path(cairo());
  check();
}

void Brush::paint_part(const Look& look) {
  const bool overlaps = look.even_odd && !look.fill.none;
  const bool both = !look.fill.none && !look.stroke.none;
  const bool alike = look.fill.rgb == look.stroke.rgb && look.fill.opacity == 1 &&
                     look.stroke.opacity == 1;  // then no part shows what is over what
  if (!overlaps && (!both || alike)) paint(look);
}

std::string Brush::png() const {
  std::string out;
  check_status(cairo_surface_write_to_png_stream(surface_.get(), append, &out));
  return out;
}

}  // namespace c1mesh
