// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/warp_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bernstein/jacobian.h"

namespace c1mesh::meshing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLargestBaseAngle = kPi / 3;
// A base angle below this part of what the joint allows means that chord and tangent differ too
// much.
constexpr double kLeastPart = 0.25;

// Angle of pole i against the inner edge at an end; the pole must lie on the curve's side of it.
bool poles_below_inner_edges(const WarpSegment& s) {
  const Point left = s.apex - s.curve.start(), right = s.apex - s.curve.end();
  for (int i = 1; i < s.curve.degree(); ++i) {
    if (cross(s.curve.poles[i] - s.curve.start(), left) <= 0) return false;
    if (cross(right, s.curve.poles[i] - s.curve.end()) <= 0) return false;
  }
  return true;
}

}  // namespace

double angle_between(const Point& u, const Point& v) {
  return std::atan2(cross(u, v), u.dot(v));
}

Point start_direction(const BezierCurve& curve) {
  for (const Point& p : curve.poles)
    if (p != curve.start()) return p - curve.start();
  return Point::Zero();
}

Point end_direction(const BezierCurve& curve) {
  for (auto p = curve.poles.rbegin(); p != curve.poles.rend(); ++p)
    if (*p != curve.end()) return curve.end() - *p;
  return Point::Zero();
}

double interior_angle(const Point& in, const Point& out) {
  const double turn = angle_between(in, out);
  return kPi - turn;
}

bool is_straight(const BezierCurve& curve) {
  // Raising a line's degree in doubles moves its poles by a few units in the last place.
  constexpr double tolerance = 1e-15;
  const int n = curve.degree();
  for (int i = 1; i < n; ++i) {
    const Point even = curve.start() + (double(i) / n) * (curve.end() - curve.start());
    if ((curve.poles[i] - even).cwiseAbs().maxCoeff() > tolerance) return false;
  }
  return true;
}

std::vector<Point> warp_net(const WarpSegment& segment) {
  const int n = segment.curve.degree();
  std::vector<Point> net = segment.curve.poles;
  for (int j = 1; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i)
      net.push_back((double(n - i - j) * segment.curve.start() + double(i) * segment.curve.end() +
                     double(j) * segment.apex) /
                    double(n));
  return net;
}

bool place_apex(WarpSegment& s) {
  s.bound = std::numeric_limits<double>::infinity();
  const Point chord = s.curve.end() - s.curve.start();
  // The inner edges stay within their share of the joint's angle, measured from the tangent; on a
  // curve that bulges outwards the chord has used up part of it.
  const double bulge[2] = {angle_between(start_direction(s.curve), chord),
                           angle_between(chord, end_direction(s.curve))};
  double slope[2];
  s.base_angle = 0;
  for (int k = 0; k < 2; ++k) {
    const double allowed = s.share[k] * s.joint[k];
    const double angle = std::min(kLargestBaseAngle, allowed - bulge[k]);
    if (!(angle > kLeastPart * std::min(kLargestBaseAngle, allowed))) return false;
    slope[k] = std::tan(angle);
  }
  const double length = chord.norm();
  const double foot = slope[1] / (slope[0] + slope[1]);
  s.height = s.shrink * length * slope[0] * foot;
  s.base_angle = std::atan(s.shrink * std::max(slope[0], slope[1]));
  const Point normal(-chord.y() / length, chord.x() / length);
  s.apex = s.curve.start() + foot * chord + s.height * normal;
  if (!poles_below_inner_edges(s)) return false;
  s.bound = distortion_bound(JacobianTables::of(s.curve.degree()), warp_net(s), chord,
                             s.apex - s.curve.start());
  return std::isfinite(s.bound);
}

double outward_reach(const WarpSegment& s, int end) {
  const Point tangent = end == 0 ? start_direction(s.curve) : Point(-end_direction(s.curve));
  const Point& origin = end == 0 ? s.curve.start() : s.curve.end();
  double reach = 0;
  for (const Point& p : s.curve.poles) {
    if (p == origin) continue;
    // The outside is on the right when leaving the start, on the left when looking back from the
    // end.
    const double angle = angle_between(tangent, p - origin);
    reach = std::max(reach, end == 0 ? -angle : angle);
  }
  return reach;
}

std::vector<Point> hull_of(const WarpSegment& segment) {
  if (segment.straight) return {segment.curve.start(), segment.curve.end()};
  std::vector<Point> points = segment.curve.poles;
  points.push_back(segment.apex);
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  // Andrew's monotone chain: lower hull from left to right, upper hull back.
  std::vector<Point> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

namespace {

double gap_along(const Point& axis, const std::vector<Point>& a, const std::vector<Point>& b) {
  double top = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  for (const Point& p : a) top = std::max(top, axis.dot(p));
  for (const Point& p : b) bottom = std::min(bottom, axis.dot(p));
  return bottom - top;
}

// Looks along the outward normals of a, and along a itself if it is a mere line, which has no end
// faces.
bool separated_by_edge_of(const std::vector<Point>& a, const std::vector<Point>& b, double margin) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point edge = (a[(i + 1) % a.size()] - a[i]).normalized();
    if (gap_along(Point(edge.y(), -edge.x()), a, b) > margin) return true;
    if (a.size() == 2 && gap_along(edge, a, b) > margin) return true;
  }
  return false;
}

}  // namespace

bool separated(const std::vector<Point>& a, const std::vector<Point>& b, double margin) {
  return separated_by_edge_of(a, b, margin) || separated_by_edge_of(b, a, margin);
}

}  // namespace c1mesh::meshing
