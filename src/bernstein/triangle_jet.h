// SPDX-License-Identifier: GPL-3.0-or-later
// Value, first and second derivatives of a Bezier triangle.
#pragma once

#include <array>

#include "bernstein/net_blossom.h"

namespace c1mesh {

/// Over the unit triangle: barycentric coordinates (1 - s - t, s, t).
struct TriangleJet {
  Point value = Point::Zero();
  std::array<Point, 2> first;   ///< d/ds, d/dt
  std::array<Point, 3> second;  ///< d²/ds², d²/dsdt, d²/dt²
};

/// Of the net of degree n >= 1, by de Casteljau's steps down to degree 2; zero second derivatives
/// for n = 1. `at` need not lie inside.
TriangleJet jet_of(Net net, int n, const Barycentric& at);

}  // namespace c1mesh
