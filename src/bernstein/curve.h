// SPDX-License-Identifier: GPL-3.0-or-later
// De Casteljau algebra of Bezier curves. Every function is a template over the number type, so that
// doubles do the work and exact rationals check it.
#pragma once

#include <array>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// A control polygon over any number type: poles[i] = {x, y}.
template <class Number>
using Poles = std::vector<std::array<Number, 2>>;

/// The blossom (polar form) of the curve at (arguments[0], …, arguments[n-1]): one de Casteljau
/// step per argument. Preconditions: arguments.size() == poles.size() - 1.
template <class Number>
std::array<Number, 2> blossom(Poles<Number> poles, const std::vector<Number>& arguments) {
  std::size_t last = poles.size() - 1;
  for (const Number& t : arguments) {
    for (std::size_t i = 0; i < last; ++i)
      for (int k = 0; k < 2; ++k) poles[i][k] = (Number(1) - t) * poles[i][k] + t * poles[i + 1][k];
    --last;
  }
  return poles[0];
}

/// The control polygon of the curve restricted to a -> b (a > b reverses it): pole i is the blossom
/// at n-i times a and i times b. Exact where Number is.
template <class Number>
Poles<Number> restrict_poles(const Poles<Number>& poles, const Number& a, const Number& b) {
  const std::size_t n = poles.size() - 1;
  Poles<Number> out;
  for (std::size_t i = 0; i <= n; ++i) {
    std::vector<Number> arguments(n, a);
    for (std::size_t k = 0; k < i; ++k) arguments[k] = b;
    out.push_back(blossom(poles, arguments));
  }
  return out;
}

/// The same curve with degree one higher.
template <class Number>
Poles<Number> elevate_poles(const Poles<Number>& poles) {
  const int n = static_cast<int>(poles.size()) - 1;
  Poles<Number> out(poles.size() + 1);
  out.front() = poles.front();
  out.back() = poles.back();
  for (int i = 1; i <= n; ++i)
    for (int k = 0; k < 2; ++k)
      out[i][k] = (Number(i) * poles[i - 1][k] + Number(n + 1 - i) * poles[i][k]) / Number(n + 1);
  return out;
}

Poles<double> poles_of(const BezierCurve& curve);
BezierCurve curve_of(const Poles<double>& poles);

Point evaluate(const BezierCurve& curve, double t);
/// The derivative with respect to t.
Point derivative(const BezierCurve& curve, double t);
BezierCurve restrict_curve(const BezierCurve& curve, double t0, double t1);
/// Raised to `degree`; the end points stay bit for bit. Precondition: degree >= curve.degree().
BezierCurve elevate(const BezierCurve& curve, int degree);
BezierCurve reversed(const BezierCurve& curve);

/// The control points of `curve` restricted to t0 -> t1 and raised to `degree`, computed in exact
/// rational arithmetic and rounded once: what a boundary edge of a result must hold.
BezierCurve restrict_exactly(const BezierCurve& curve, double t0, double t1, int degree);

}  // namespace c1mesh
