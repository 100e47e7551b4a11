// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bernstein/curve.h"

namespace c1mesh {
namespace {

/// A number with at most three decimals and no trailing zeros.
std::string pixels(double x) {
  std::string out = fmt::format("{:.3f}", x);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string pair(const Point& p) {
  return pixels(p.x()) + "," + pixels(p.y());
}

}  // namespace

Box box_of(const std::vector<Point>& points) {
  Box box;
  if (points.empty()) return box;
  box.low = box.high = points[0];
  for (const Point& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Panel::Panel(const Point& low, const Point& high, double left, double top, double width,
             double height)
    : centre_(left + width / 2, top + height / 2), middle_(0.5 * (low + high)) {
  const Point size = (high - low).cwiseMax(Point::Constant(1e-300));
  scale_ = std::min(width / size.x(), height / size.y());
  size_ = scale_ * size;
}

Point Panel::place(const Point& p) const {
  const Point d = scale_ * (p - middle_);
  return {centre_.x() + d.x(), centre_.y() - d.y()};
}

void PathData::move(const Point& p) {
  text_ += fmt::format("M{}", pair(panel_.place(p)));
}
void PathData::line(const Point& p) {
  text_ += fmt::format("L{}", pair(panel_.place(p)));
}

void PathData::cubic(const Point& b, const Point& c, const Point& d) {
  text_ +=
      fmt::format("C{} {} {}", pair(panel_.place(b)), pair(panel_.place(c)), pair(panel_.place(d)));
}

// Less than a pixel: no one sees that it is curved.
bool PathData::is_tiny(const std::vector<Point>& poles) const {
  constexpr double kTiny = 0.75;
  const Box box = box_of(poles);
  return (box.high - box.low).maxCoeff() * panel_.scale() < kTiny;
}

void PathData::curve(const std::vector<Point>& poles) {
  BezierCurve bezier{poles};
  if (bezier.degree() == 1 || is_tiny(poles)) return line(poles.back());
  if (bezier.degree() <= 3) {
    bezier = elevate(bezier, 3);
    return cubic(bezier.poles[1], bezier.poles[2], bezier.poles[3]);
  }
  constexpr int kParts = 4;
  for (int part = 0; part < kParts; ++part) {
    const double a = double(part) / kParts, b = double(part + 1) / kParts, third = (b - a) / 3;
    const Point start = evaluate(bezier, a), end = evaluate(bezier, b);
    cubic(start + third * derivative(bezier, a), end - third * derivative(bezier, b), end);
  }
}

std::string path_element(const std::string& css_class, const PathData& data,
                         const std::string& style) {
  if (data.empty()) return "";
  const std::string attribute = style.empty() ? "" : " style=\"" + style + "\"";
  return "<path class=\"" + css_class + "\"" + attribute + " d=\"" + data.text() + "\"/>\n";
}

}  // namespace c1mesh
