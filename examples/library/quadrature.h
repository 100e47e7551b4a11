// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss points of an interval and of a triangle.
#pragma once

#include <c1mesh/barycentric.h>

#include <cmath>
#include <numbers>
#include <vector>

struct LinePoint {
  double at, weight;  ///< in [0, 1]; the weights' sum is 1
};

/// `count` points, exact for polynomials of degree 2 count - 1: the roots of Legendre's polynomial.
inline std::vector<LinePoint> gauss_line(int count) {
  std::vector<LinePoint> points;
  for (int k = 0; k < count; ++k) {
    double x = std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5)), slope = 1;
    for (int step = 0; step < 50; ++step) {
      double before = 1, value = x;  // P_0, P_1
      for (int m = 2; m <= count; ++m) {
        const double next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    points.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return points;
}

struct TrianglePoint {
  c1mesh::Barycentric at;
  double weight;  ///< the weights' sum is 1/2, the area of the unit triangle
};

/// Exact for polynomials of total degree 2 count - 2: the square's points, one side of it collapsed
/// to a corner.
inline std::vector<TrianglePoint> gauss_triangle(int count) {
  std::vector<TrianglePoint> points;
  for (const LinePoint& p : gauss_line(count))
    for (const LinePoint& q : gauss_line(count)) {
      const double s = p.at, t = q.at * (1 - p.at);
      points.push_back({c1mesh::Barycentric(1 - s - t, s, t), p.weight * q.weight * (1 - p.at)});
    }
  return points;
}
