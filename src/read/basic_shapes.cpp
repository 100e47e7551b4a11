// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/basic_shapes.h"

#include <algorithm>

#include "read/path_data.h"
#include "read/scanner.h"

namespace c1mesh::detail {
namespace {

double length_or_zero(const pugi::xml_node& element, const char* attribute) {
  return length(element, attribute).value_or(0);
}

double unit_factor(std::string_view unit, const Scanner& in) {
  if (unit.empty() || unit == "px") return 1;
  if (unit == "in") return 96;
  if (unit == "cm") return 96 / 2.54;
  if (unit == "mm") return 96 / 25.4;
  if (unit == "pt") return 96.0 / 72;
  if (unit == "pc") return 16;
  throw SyntaxError("lengths in '" + std::string(unit) + "' depend on where the drawing is shown",
                    in.position());
}

// Four quarter arcs through the exact extreme points.
Outline ellipse(const Point& centre, double rx, double ry) {
  if (rx <= 0 || ry <= 0) return {};
  const Point x(rx, 0), y(0, ry);
  Pen pen;
  pen.move_to(centre + x);
  for (const Point& corner :
       {Point(centre + y), Point(centre - x), Point(centre - y), Point(centre + x)})
    pen.arc_to({rx, ry}, 0, false, true, corner);
  pen.close();
  return pen.finish();
}

Outline circle(const pugi::xml_node& element) {
  const double r = length_or_zero(element, "r");
  return ellipse({length_or_zero(element, "cx"), length_or_zero(element, "cy")}, r, r);
}

Outline ellipse(const pugi::xml_node& element) {
  const auto rx = length(element, "rx"), ry = length(element, "ry");
  return ellipse({length_or_zero(element, "cx"), length_or_zero(element, "cy")},
                 rx ? *rx : ry.value_or(0), ry ? *ry : rx.value_or(0));
}

void line_unless_there(Pen& pen, const Point& p) {
  if (pen.at() != p) pen.line_to(p);
}

Outline rect(const pugi::xml_node& element) {
  const double x = length_or_zero(element, "x"), y = length_or_zero(element, "y");
  const double w = length_or_zero(element, "width"), h = length_or_zero(element, "height");
  if (w <= 0 || h <= 0) return {};
  // SVG 2, 10.2: a radius that is not given is the other one; none exceeds half the side.
  const auto given_x = length(element, "rx"), given_y = length(element, "ry");
  const double rx = std::clamp(given_x ? *given_x : given_y.value_or(0), 0.0, w / 2);
  const double ry = std::clamp(given_y ? *given_y : given_x.value_or(0), 0.0, h / 2);
  const double right = x + w, bottom = y + h;
  Pen pen;
  const auto corner = [&](const Point& end) {
    if (rx > 0 && ry > 0) pen.arc_to({rx, ry}, 0, false, true, end);
  };
  const bool round = rx > 0 && ry > 0;
  const double ix = round ? rx : 0, iy = round ? ry : 0;
  pen.move_to({x + ix, y});
  line_unless_there(pen, {right - ix, y});
  corner({right, y + iy});
  line_unless_there(pen, {right, bottom - iy});
  corner({right - ix, bottom});
  line_unless_there(pen, {x + ix, bottom});
  corner({x, bottom - iy});
  line_unless_there(pen, {x, y + iy});
  corner({x + ix, y});
  pen.close();
  return pen.finish();
}

Outline polygon(const pugi::xml_node& element, bool closed) {
  const std::vector<Point> points = parse_points(element.attribute("points").value());
  Pen pen;
  for (std::size_t i = 0; i < points.size(); ++i)
    i == 0 ? pen.move_to(points[i]) : pen.line_to(points[i]);
  if (closed && points.size() > 1) pen.close();
  return pen.finish();
}

}  // namespace

std::string_view local_name(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::optional<double> length(const pugi::xml_node& element, const char* attribute) {
  const std::string_view text = element.attribute(attribute).value();
  Scanner in(text);
  in.skip_space();
  if (in.at_end() || text == "auto") return std::nullopt;
  const double value = in.number();
  if (in.peek() == '%') unit_factor("%", in);
  const double factor = unit_factor(in.word(), in);
  in.skip_space();
  if (!in.at_end()) in.fail("expected the end of a length");
  return value * factor;
}

std::optional<Outline> outline_of(const pugi::xml_node& element) {
  const std::string_view tag = local_name(element);
  if (tag == "path") return parse_path(element.attribute("d").value());
  if (tag == "rect") return rect(element);
  if (tag == "circle") return circle(element);
  if (tag == "ellipse") return ellipse(element);
  if (tag == "polygon") return polygon(element, true);
  if (tag == "polyline") return polygon(element, false);
  return std::nullopt;
}

}  // namespace c1mesh::detail
