// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/float_traps.h"

namespace c1mesh::verification {
namespace {

/// The poles of the first part of the curve, 0 -> t.
std::vector<Vec<Rational>> first_part(std::vector<Vec<Rational>> poles, const Rational& t) {
  std::vector<Vec<Rational>> out;
  for (std::size_t last = poles.size() - 1;; --last) {
    out.push_back(poles[0]);
    if (last == 0) return out;
    for (std::size_t i = 0; i < last; ++i)
      for (int k = 0; k < 2; ++k) poles[i][k] += t * (poles[i + 1][k] - poles[i][k]);
  }
}

std::vector<Vec<Rational>> raise_once(const std::vector<Vec<Rational>>& poles) {
  const std::size_t n = poles.size() - 1;
  std::vector<Vec<Rational>> out{poles.front()};
  for (std::size_t i = 1; i <= n; ++i) {
    const Rational share =
        Rational(static_cast<unsigned long>(i)) / static_cast<unsigned long>(n + 1);
    Vec<Rational> p;
    for (int k = 0; k < 2; ++k) p[k] = share * poles[i - 1][k] + (1 - share) * poles[i][k];
    out.push_back(p);
  }
  out.push_back(poles.back());
  return out;
}

bool within_box(const Point& a, const Point& b, const Point& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

}  // namespace

Vec<Rational> exact(const Point& p) {
  return {Rational(p.x()), Rational(p.y())};
}

Rational exact_area(const Vec<Rational>& a, const Vec<Rational>& b, const Vec<Rational>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

int orientation(const Point& a, const Point& b, const Point& c) {
  const FloatTrapsOff overflow;  // is seen below; rationals have none
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  // Each product carries at most three rounding errors and the difference one more: 4 u of the sum
  // of magnitudes bounds them all; twice that leaves room for the bound's own rounding. Underflow
  // breaks the relative bound, so tiny products go the exact way.
  const double magnitude = std::abs(left) + std::abs(right);
  const double bound = 4 * std::numeric_limits<double>::epsilon() * magnitude;
  const bool safe = std::abs(left) > 1e-280 && std::abs(right) > 1e-280 && std::isfinite(magnitude);
  if (safe && left - right > bound) return 1;
  if (safe && left - right < -bound) return -1;
  return sgn(exact_area(exact(a), exact(b), exact(c)));
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int abc = orientation(a, b, c), abd = orientation(a, b, d);
  const int cda = orientation(c, d, a), cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && within_box(a, b, c)) || (abd == 0 && within_box(a, b, d)) ||
         (cda == 0 && within_box(c, d, a)) || (cdb == 0 && within_box(c, d, b));
}

bool spokes_overlap(const Point& p, const Point& a, const Point& b) {
  if (orientation(p, a, b) != 0) return false;
  // On one line: they overlap unless a and b lie on opposite sides of p, told by any coordinate
  // that moves.
  const bool x_moves = a.x() != p.x();
  const int k = x_moves ? 0 : 1;
  return (a[k] > p[k]) == (b[k] > p[k]);
}

std::vector<Vec<Rational>> exact_restriction(const BezierCurve& curve, double t0, double t1,
                                             int degree) {
  std::vector<Vec<Rational>> poles;
  for (const Point& p : curve.poles) poles.push_back(exact(p));
  const bool backward = t0 > t1;
  const Rational low(std::min(t0, t1)), high(std::max(t0, t1));
  if (high != 1) poles = first_part(poles, high);
  if (low != 0) {
    // The part low -> high of the curve is the part 0 -> 1 - low/high of the reversed first part.
    std::reverse(poles.begin(), poles.end());
    poles = first_part(poles, 1 - low / high);
    std::reverse(poles.begin(), poles.end());
  }
  if (backward) std::reverse(poles.begin(), poles.end());
  while (static_cast<int>(poles.size()) <= degree) poles = raise_once(poles);
  return poles;
}

}  // namespace c1mesh::verification
