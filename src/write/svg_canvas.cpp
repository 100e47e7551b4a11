// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

void PathData::curve(const std::vector<Point>& poles) {
  BezierCurve bezier{poles};
  if (bezier.degree() == 1) return line(poles[1]);
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

std::string path_element(const std::string& css_class, const PathData& data) {
  if (data.empty()) return "";
  return "<path class=\"" + css_class + "\" d=\"" + data.text() + "\"/>\n";
}

std::string scale_colour(double share) {
  static constexpr std::array<std::array<double, 3>, 6> stops{{{240, 246, 250},
                                                               {170, 212, 226},
                                                               {160, 206, 158},
                                                               {250, 220, 120},
                                                               {233, 136, 70},
                                                               {160, 28, 44}}};
  const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const auto first = std::min<std::size_t>(static_cast<std::size_t>(at), stops.size() - 2);
  const double rest = at - static_cast<double>(first);
  std::array<int, 3> rgb;
  for (int k = 0; k < 3; ++k)
    rgb[k] =
        static_cast<int>(std::lround((1 - rest) * stops[first][k] + rest * stops[first + 1][k]));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

}  // namespace c1mesh
