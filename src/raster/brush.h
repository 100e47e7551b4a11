// SPDX-License-Identifier: GPL-3.0-or-later
// Paints paths on a surface of pixels, by cairo.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "raster/look.h"

namespace c1mesh {

class Brush {
 public:
  /// A surface of so many pixels, white or, if `transparent`, empty. Throws std::bad_alloc.
  Brush(int width, int height, bool transparent);

  /// cairo's drawing state, for building the current path and for transformations.
  cairo_t* cairo() const { return cairo_.get(); }
  /// Paints the current path as `look` says, and forgets it.
  void paint(const Look& look);
  /// The same as SVG's stroke and fill would do with a path too long to be painted at once: what is
  /// there of it is painted, if that cannot be told from painting all at once.
  void paint_part(const Look& look);
  /// The surface as bytes of a PNG file. Throws std::bad_alloc.
  std::string png() const;

 private:
  void fill(const Look& look);
  void stroke(const Look& look);
  void check() const;

  struct Release {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  std::unique_ptr<cairo_surface_t, Release> surface_;
  std::unique_ptr<cairo_t, Release> cairo_;
};

}  // namespace c1mesh
