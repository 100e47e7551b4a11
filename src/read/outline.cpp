// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/float_traps.h"

namespace c1mesh::detail {
namespace {

constexpr double kPi = std::numbers::pi;

// An ellipse as the image of the unit circle, and the angles its arc runs over (signed).
struct EllipticArc {
  Affine from_circle;
  double first = 0, sweep = 0;
};

double angle_of(const Point& p) {
  return std::atan2(p.y(), p.x());
}

// SVG 2, implementation notes B.2.4 and B.2.5: from end points to centre and angles.
EllipticArc centre_form(const Point& from, Point radii, double rotation_degrees, bool large,
                        bool sweep, const Point& to) {
  const Eigen::Matrix2d turn = rotation(rotation_degrees).linear;
  const Point half = turn.transpose() * ((from - to) / 2);
  const double excess = std::hypot(half.x() / radii.x(), half.y() / radii.y());
  if (excess > 1) radii *= excess;
  // In the frame where the ellipse is the unit circle the chord runs from u to -u.
  const Point u(half.x() / radii.x(), half.y() / radii.y());
  const double across = std::sqrt(std::max(0.0, 1 / u.squaredNorm() - 1));
  const Point centre = (large != sweep ? 1 : -1) * across * Point(u.y(), -u.x());
  EllipticArc arc;
  arc.from_circle.linear = turn * radii.asDiagonal();
  arc.from_circle.shift = arc.from_circle.linear * centre + (from + to) / 2;
  arc.first = angle_of(u - centre);
  arc.sweep = angle_of(-u - centre) - arc.first;
  if (sweep && arc.sweep < 0) arc.sweep += 2 * kPi;
  if (!sweep && arc.sweep > 0) arc.sweep -= 2 * kPi;
  return arc;
}

}  // namespace

double unit_arc_error(double angle) {
  // With a = angle/4 the squared radius at s is 1 + 16 s^2 (1-s)^2 (1-2s)^2 sin^6(a) / cos^2(a);
  // the polynomial is largest where s (1-s) = 1/6, with 1/108.
  const double s = std::sin(angle / 4), c = std::cos(angle / 4);
  const double x = 4.0 / 27 * std::pow(s, 6) / (c * c);
  return x / (1 + std::sqrt(1 + x));
}

void Pen::move_to(const Point& p) {
  end_subpath(false);
  start_ = at_ = p;
}

void Pen::line_to(const Point& p) {
  curve_to({p});
}

void Pen::curve_to(std::vector<Point> rest) {
  BezierCurve curve{{at_}};
  curve.poles.insert(curve.poles.end(), rest.begin(), rest.end());
  at_ = curve.end();
  current_.push_back(std::move(curve));
}

void Pen::arc_to(Point radii, double rotation_degrees, bool large, bool sweep, const Point& end) {
  if (end == at_) return;
  radii = radii.cwiseAbs();
  if (radii.minCoeff() == 0) return line_to(end);
  const FloatTrapsOff unlike;  // radii, or coordinates near overflow
  const EllipticArc arc = centre_form(at_, radii, rotation_degrees, large, sweep, end);
  // At most 90 degrees each; the slack keeps a quarter turn that rounding made longer in one piece.
  const double quarters = std::ceil(std::abs(arc.sweep) / (kPi / 2) - 1e-9);
  // Radii too unlike for doubles make the sweep NaN; the control points are then not finite, which
  // the check tells.
  const int pieces = quarters >= 1 ? static_cast<int>(quarters) : 1;
  const double step = arc.sweep / pieces, handle = 4.0 / 3 * std::tan(step / 4);
  for (int i = 0; i < pieces; ++i) {
    const double a = arc.first + i * step, b = arc.first + (i + 1) * step;
    const Point p(std::cos(a), std::sin(a)), q(std::cos(b), std::sin(b));
    const Point p1 = p + handle * Point(-p.y(), p.x()), q1 = q - handle * Point(-q.y(), q.x());
    curve_to(
        {arc.from_circle(p1), arc.from_circle(q1), i + 1 == pieces ? end : arc.from_circle(q)});
  }
  ++out_.arcs;
  out_.arc_error = std::max(out_.arc_error, unit_arc_error(step) * arc.from_circle.stretch());
}

void Pen::close() {
  if (at_ != start_) line_to(start_);
  end_subpath(true);
  at_ = start_;
}

Outline Pen::finish() {
  end_subpath(false);
  return std::move(out_);
}

void Pen::end_subpath(bool closed_by_author) {
  if (current_.empty()) return;
  out_.closing_line.push_back(at_ != start_ && !closed_by_author);
  if (at_ != start_) line_to(start_);
  if (out_.closing_line.back()) ++out_.closed_by_line;
  out_.subpaths.push_back(std::move(current_));
  current_.clear();
}

}  // namespace c1mesh::detail
