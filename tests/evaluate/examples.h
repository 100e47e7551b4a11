// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made results whose measures are known in closed form.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "result/example_results.h"

namespace c1mesh::example {

inline int control_id(const Result& r, int t, int i, int j) {
  return r.triangle_control_points[t][j * (r.degree + 1) - j * (j - 1) / 2 + i];
}

/// The identity of the unit square, the inner control point of its lower triangle moved by h along
/// x: one of the three equations of the diagonal is off by h.
inline Result bent_square(double h) {
  Result result = square();
  result.control_points[control_id(result, 0, 1, 1)].x() += h;
  return result;
}

/// A polygon of 72 sides around its centre, which turns by 5 degrees, less than the corner angle,
/// but for a notch: vertex 0 is pulled inward, a reflex corner between two convex ones.
inline Result notched() {
  constexpr int kSides = 72;
  std::vector<Point> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2 * std::numbers::pi * k / kSides, radius = k == 0 ? 0.98 : 1;
    vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    triangles.push_back({k, (k + 1) % kSides, kSides});
  }
  vertices.emplace_back(0, 0);
  Result result = polynomial_result(3, identity(), vertices, triangles);
  for (BoundaryVertex& v : result.boundary_vertices)
    v.corner = v.vertex <= 1 || v.vertex == kSides - 1;
  return result;
}

}  // namespace c1mesh::example
