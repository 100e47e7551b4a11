// SPDX-License-Identifier: GPL-3.0-or-later
// From the SVG that this library writes to pixels: one walk over the elements.
#include "c1mesh/png.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <pugixml.hpp>
#include <stdexcept>

#include "raster/brush.h"
#include "raster/font.h"
#include "raster/path_reader.h"

namespace c1mesh {
namespace {

using Node = pugi::xml_node;

double number(const Node& node, const char* name, double otherwise = 0) {
  const pugi::xml_attribute attribute = node.attribute(name);
  return attribute ? number_of(attribute.value()) : otherwise;
}

void check_size(double width, double height) {
  if (!(width >= 1 && height >= 1)) throw std::invalid_argument("the picture has no size");
  if (std::max(width, height) > kLongestPngSide || width * height > kMostPngPixels)
    throw std::invalid_argument(
        fmt::format("a PNG picture of {:.0f} x {:.0f} pixels is too large: a side may have {:.0f} "
                    "pixels, the whole {:.0f} million. Choose a smaller --width, or write SVG",
                    width, height, kLongestPngSide, kMostPngPixels / 1e6));
}

class Painter {
 public:
  Painter(const Node& svg, bool transparent)
      : sheet_(svg.child("style").text().get()),
        root_(svg),
        brush_(side(svg, "width"), side(svg, "height"), transparent) {
    const auto box = pieces_of(svg.attribute("viewBox").value(), " ");
    if (box.size() != 4 || number_of(box[0]) != 0 || number_of(box[1]) != 0)
      throw std::invalid_argument("a picture must have a viewBox that begins at 0 0");
    width_ = number_of(box[2]);
    height_ = number_of(box[3]);
    cairo_scale(brush_.cairo(), side(svg, "width") / width_, side(svg, "height") / height_);
  }

  std::string paint() {
    const Look look;
    children(root_, look);
    return brush_.png();
  }

 private:
  static int side(const Node& svg, const char* name) {
    check_size(number(svg, "width"), number(svg, "height"));
    return static_cast<int>(std::lround(number(svg, name)));
  }

  void children(const Node& node, const Look& look) {
    const std::vector<std::string_view> classes = pieces_of(node.attribute("class").value(), " ");
    path_.push_back({node.name(), classes});
    for (const Node& child : node.children())
      if (child.type() == pugi::node_element) element(child, look);
    path_.pop_back();
  }

  // Attributes of the look give way to rules, and these to the attribute `style`.
  Look look_of(const Node& node, Look look) {
    for (const pugi::xml_attribute& attribute : node.attributes())
      set_property(look, attribute.name(), attribute.value());
    path_.push_back({node.name(), pieces_of(node.attribute("class").value(), " ")});
    sheet_.apply(look, path_);
    path_.pop_back();
    set_declarations(look, node.attribute("style").value());
    return look;
  }

  void element(const Node& node, const Look& inherited) {
    const std::string_view tag = node.name();
    if (tag == "style" || tag == "title" || tag == "clipPath") return;
    cairo_save(brush_.cairo());
    transform(node.attribute("transform").value());
    clip(node.attribute("clip-path").value());
    const Look look = look_of(node, inherited);
    if (tag == "g")
      children(node, look);
    else if (tag == "path")
      paint_path(brush_, node.attribute("d").value(), look);
    else if (tag == "rect")
      rectangle(node, look);
    else if (tag == "circle")
      circle(node, look);
    else if (tag == "text")
      text(node, look);
    else
      throw std::invalid_argument(fmt::format("a picture cannot have the element '{}'", tag));
    cairo_restore(brush_.cairo());
  }

  double length(const Node& node, const char* name, double whole) const {
    const std::string_view value = node.attribute(name).value();
    return value == "100%" ? whole : number(node, name);
  }

  void outline_rectangle(const Node& node) {
    cairo_rectangle(brush_.cairo(), number(node, "x"), number(node, "y"),
                    length(node, "width", width_), length(node, "height", height_));
  }

  void rectangle(const Node& node, const Look& look) {
    outline_rectangle(node);
    brush_.paint(look);
  }

  void circle(const Node& node, const Look& look) {
    cairo_new_sub_path(brush_.cairo());
    cairo_arc(brush_.cairo(), number(node, "cx"), number(node, "cy"), number(node, "r"), 0,
              2 * std::numbers::pi);
    cairo_close_path(brush_.cairo());
    brush_.paint(look);
  }

  // Text, then tspans that follow it, each with its own size, moved by dx and dy.
  void text(const Node& node, const Look& look) {
    struct Run {
      std::string words;
      Look look;
      double dx = 0, dy = 0;
    };
    std::vector<Run> runs;
    double width = 0;
    for (const Node& child : node.children()) {
      if (child.type() == pugi::node_pcdata)
        runs.push_back({child.value(), look});
      else if (std::string_view(child.name()) == "tspan")
        runs.push_back(
            {child.text().get(), look_of(child, look), number(child, "dx"), number(child, "dy")});
      else
        continue;
      width += runs.back().dx +
               text_width(runs.back().words, runs.back().look.bold) * runs.back().look.font_size;
    }
    double x = number(node, "x"), y = number(node, "y");
    if (look.anchor != Anchor::start) x -= look.anchor == Anchor::middle ? width / 2 : width;
    for (const Run& run : runs) {
      x += run.dx;
      y += run.dy;
      outline_text(run.words, x, y, run.look);
      brush_.paint(run.look);
      x += text_width(run.words, run.look.bold) * run.look.font_size;
    }
  }

  void outline_text(const std::string& words, double x, double y, const Look& look) {
    cairo_t* cairo = brush_.cairo();
    const double size = look.font_size;
    const auto right = [&](const Point& p) { return x + size * p.x(); };
    const auto down = [&](const Point& p) { return y - size * p.y(); };
    for (const GlyphStep& step : text_outline(words, look.bold)) {
      if (step.kind == 'm') {
        cairo_close_path(cairo);
        cairo_move_to(cairo, right(step.to), down(step.to));
      } else if (step.kind == 'l') {
        cairo_line_to(cairo, right(step.to), down(step.to));
      } else {
        cairo_curve_to(cairo, right(step.first), down(step.first), right(step.second),
                       down(step.second), right(step.to), down(step.to));
      }
    }
    cairo_close_path(cairo);
  }

  // A sequence of translate(x y), scale(s) and rotate(degrees x y).
  void transform(std::string_view value) {
    for (const std::string_view part : pieces_of(value, ")")) {
      const std::size_t open = part.find('(');
      const std::string_view name = part.substr(0, open);
      std::vector<double> by;
      if (open != std::string_view::npos)
        for (const auto argument : pieces_of(part.substr(open + 1), " ,"))
          by.push_back(number_of(argument));
      by.resize(3);
      if (name == "translate") {
        cairo_translate(brush_.cairo(), by[0], by[1]);
      } else if (name == "scale") {
        cairo_scale(brush_.cairo(), by[0], by[0]);
      } else if (name == "rotate") {
        cairo_translate(brush_.cairo(), by[1], by[2]);
        cairo_rotate(brush_.cairo(), by[0] * std::numbers::pi / 180);
        cairo_translate(brush_.cairo(), -by[1], -by[2]);
      } else {
        throw std::invalid_argument(fmt::format("a picture cannot be moved by '{}'", part));
      }
    }
  }

  // url(#id) of a rectangle, which stands anywhere before.
  void clip(std::string_view value) {
    if (value.empty()) return;
    const std::string query =
        fmt::format("//clipPath[@id='{}']", value.substr(5, value.size() - 6));
    const Node found = root_.select_node(query.c_str()).node();
    if (!found) throw std::invalid_argument(fmt::format("a picture has no clip path '{}'", value));
    outline_rectangle(found.child("rect"));
    cairo_clip(brush_.cairo());
  }

  StyleSheet sheet_;
  Node root_;
  Brush brush_;
  double width_ = 0, height_ = 0;
  std::vector<Tagged> path_;
};

}  // namespace

std::string png_of(const std::string& svg, const PngOptions& options) {
  pugi::xml_document document;
  const unsigned kept = pugi::parse_default | pugi::parse_ws_pcdata_single;
  const auto parsed = document.load_buffer(svg.data(), svg.size(), kept, pugi::encoding_utf8);
  if (!parsed) throw std::invalid_argument(fmt::format("no picture: {}", parsed.description()));
  return Painter(document.child("svg"), options.transparent).paint();
}

}  // namespace c1mesh
