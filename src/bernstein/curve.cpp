// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/curve.h"

#include <gmpxx.h>

#include <algorithm>

#include "bernstein/rounding.h"

namespace c1mesh {

Poles<double> poles_of(const BezierCurve& curve) {
  Poles<double> poles;
  for (const Point& p : curve.poles) poles.push_back({p.x(), p.y()});
  return poles;
}

BezierCurve curve_of(const Poles<double>& poles) {
  BezierCurve curve;
  for (const auto& p : poles) curve.poles.emplace_back(p[0], p[1]);
  return curve;
}

Point evaluate(const BezierCurve& curve, double t) {
  std::vector<Point> p = curve.poles;
  for (std::size_t last = p.size() - 1; last > 0; --last)
    for (std::size_t i = 0; i < last; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  return p[0];
}

Point derivative(const BezierCurve& curve, double t) {
  const int n = curve.degree();
  if (n == 0) return Point::Zero();
  BezierCurve hodograph;
  for (int i = 0; i < n; ++i) hodograph.poles.push_back(n * (curve.poles[i + 1] - curve.poles[i]));
  return evaluate(hodograph, t);
}

BezierCurve restrict_curve(const BezierCurve& curve, double t0, double t1) {
  return curve_of(restrict_poles(poles_of(curve), t0, t1));
}

BezierCurve elevate(const BezierCurve& curve, int degree) {
  Poles<double> poles = poles_of(curve);
  while (static_cast<int>(poles.size()) <= degree) poles = elevate_poles(poles);
  return curve_of(poles);
}

BezierCurve reversed(const BezierCurve& curve) {
  BezierCurve out = curve;
  std::reverse(out.poles.begin(), out.poles.end());
  return out;
}

BezierCurve restrict_exactly(const BezierCurve& curve, double t0, double t1, int degree) {
  Poles<mpq_class> poles;
  for (const Point& p : curve.poles) poles.push_back({mpq_class(p.x()), mpq_class(p.y())});
  poles = restrict_poles(poles, mpq_class(t0), mpq_class(t1));
  while (static_cast<int>(poles.size()) <= degree) poles = elevate_poles(poles);
  BezierCurve out;
  for (const auto& p : poles) out.poles.emplace_back(round_to_double(p[0]), round_to_double(p[1]));
  return out;
}

}  // namespace c1mesh
