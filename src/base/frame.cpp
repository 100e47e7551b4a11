// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "c1mesh/shape.h"

namespace c1mesh {

Point Frame::normalise(const Point& p) const {
  const Point d = p - origin;
  return {std::ldexp(d.x(), -exponent), std::ldexp(d.y(), -exponent)};
}

Point Frame::restore(const Point& p) const {
  return {std::ldexp(p.x(), exponent) + origin.x(), std::ldexp(p.y(), exponent) + origin.y()};
}

double Frame::extent() const {
  return std::ldexp(1.0, exponent);
}

int Shape::highest_degree() const {
  int degree = 0;
  for (const BezierCurve& curve : curves) degree = std::max(degree, curve.degree());
  return degree;
}

}  // namespace c1mesh
