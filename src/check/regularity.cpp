// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives that vanish, and joints that turn by 180 degrees.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bernstein/curve.h"
#include "check/stages.h"

namespace c1mesh::detail {
namespace {

// A derivative below this, relative to the longest control-polygon leg, counts as vanishing.
constexpr double kLeastSpeed = 1e-9;
// Interior angles closer than this to 0 or 360 degrees are cusps.
constexpr double kLeastAngle = 1e-4 * std::numbers::pi / 180;
constexpr int kDeepest = 60;

double longest(const Poles2& hodograph) {
  double out = 0;
  for (const Point& p : hodograph) out = std::max(out, p.norm());
  return out;
}

// Is every vector of the hodograph's hull longer than `least`? Sufficient: all reach further than
// that along their mean direction.
bool clear_of_zero(const Poles2& hodograph, double least) {
  Point mean = Point::Zero();
  for (const Point& p : hodograph) mean += p;
  const double length = mean.norm();
  if (length == 0) return false;
  for (const Point& p : hodograph)
    if (p.dot(mean) <= least * length) return false;
  return true;
}

// The parameter of a derivative shorter than `least`; negative if there is none.
double find_rest(const Poles2& hodograph, double t0, double t1, double least, int depth) {
  if (clear_of_zero(hodograph, least)) return -1;
  if (hodograph.front().norm() <= least) return t0;
  if (hodograph.back().norm() <= least) return t1;
  const double middle = t0 + (t1 - t0) / 2;
  if (depth >= kDeepest) return middle;
  Poles2 first, second;
  halve(hodograph, first, second);
  const double t = find_rest(first, t0, middle, least, depth + 1);
  return t >= 0 ? t : find_rest(second, middle, t1, least, depth + 1);
}

// Unit tangent at an end, pointing away from it along the curve.
Point leaving(const Arrangement& arrangement, const CurveEnd& end) {
  const auto& poles = arrangement.curves[end.curve].poles;
  const std::size_t n = poles.size();
  return end.at_end ? arrangement.difference(poles[n - 2], poles[n - 1])
                    : arrangement.difference(poles[1], poles[0]);
}

}  // namespace

std::vector<char> check_derivatives(Arrangement& arrangement) {
  std::vector<char> regular(arrangement.curves.size(), 1);
  for (int i = 0; i < arrangement.size(); ++i) {
    const BezierCurve& curve = arrangement.curves[i];
    Poles2 hodograph;
    for (int k = 0; k < curve.degree(); ++k)
      hodograph.push_back(arrangement.difference(curve.poles[k + 1], curve.poles[k]));
    const double t = find_rest(hodograph, 0, 1, kLeastSpeed * longest(hodograph), 0);
    if (t < 0) continue;
    regular[i] = 0;
    const bool at_end = t == 0 || t == 1;
    const Point where = evaluate(curve, t);
    arrangement.report(
        DefectKind::vanishing_derivative, {i}, {where},
        at_end ? fmt::format("the derivative vanishes at the {} (t = {}): a handle has no length",
                             t == 0 ? "start" : "end", t)
               : fmt::format("the derivative vanishes inside (t = {:.6g}): the curve has a cusp or "
                             "runs back on itself",
                             t),
        at_end ? "pull the handle out of its end point" : "draw it without the cusp");
  }
  return regular;
}

std::vector<char> check_joints(Arrangement& arrangement, const Nodes& nodes,
                               const std::vector<char>& regular) {
  std::vector<char> cusp(nodes.ends.size(), 0);
  for (std::size_t k = 0; k < nodes.ends.size(); ++k) {
    const auto& ends = nodes.ends[k];
    // Loops that touch are reported as such.
    if (nodes.boundary[k].size() > 2) continue;
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        if (!regular[ends[i].curve] || !regular[ends[j].curve]) continue;
        const Point a = leaving(arrangement, ends[i]), b = leaving(arrangement, ends[j]);
        const double angle = std::abs(std::atan2(cross(a, b), a.dot(b)));
        if (angle >= kLeastAngle) continue;
        cusp[k] = 1;
        const BezierCurve& curve = arrangement.curves[ends[i].curve];
        std::vector<int> about = {ends[i].curve};
        if (ends[j].curve != ends[i].curve) about.push_back(ends[j].curve);
        arrangement.report(
            DefectKind::cusp, about, {ends[i].at_end ? curve.end() : curve.start()},
            fmt::format("{} (angle {:.2g} degrees)",
                        ends.size() == 2 ? "the boundary turns back at a joint"
                                         : "two curves leave a point in one direction",
                        angle * 180 / std::numbers::pi),
            "open the angle by moving a handle or the point");
      }
  }
  return cusp;
}

}  // namespace c1mesh::detail
