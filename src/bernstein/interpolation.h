// SPDX-License-Identifier: GPL-3.0-or-later
// Bezier triangles as Lagrange ones: the values at the lattice points (i/n, j/n).
#pragma once

#include <array>
#include <vector>

#include "bernstein/curve.h"
#include "bernstein/jacobian.h"
#include "c1mesh/types.h"

namespace c1mesh {

/// n^n times the value at (i/n, j/n) of the Bezier triangle of degree n with this net (net order:
/// for j: for i): the sum of n! / (a! b! c!) i^a j^b k^c p_ab with c = n-a-b, k = n-i-j, whose
/// weights are integers. Points on an edge depend on that edge's control points alone.
template <class Number>
std::array<Number, 2> scaled_lattice_value(const Poles<Number>& net, int n, int i, int j) {
  const int k = n - i - j;
  std::array<Number, 2> sum{Number(0), Number(0)};
  std::size_t at = 0;
  Number row(1);  // C(n, b) j^b
  for (int b = 0; b <= n; ++b) {
    Number weight = row;  // C(n, b) C(n-b, a) i^a j^b, without k^c
    for (int a = 0; a <= n - b; ++a, ++at) {
      const int c = n - a - b;
      // 0^0 = 1: a point on an edge takes from the row of that edge only.
      if (weight != Number(0) && (k > 0 || c == 0)) {
        Number full = weight;
        for (int s = 0; s < c; ++s) full *= Number(k);
        for (int axis = 0; axis < 2; ++axis) sum[axis] += full * net[at][axis];
      }
      weight = weight * Number(c) * Number(i) / Number(a + 1);
    }
    row = row * Number(n - b) * Number(j) / Number(b + 1);
  }
  return sum;
}

/// The value at (i/n, j/n), in exact rational arithmetic and rounded once. At the corners the
/// control point bit for bit. Preconditions: i, j >= 0, i + j <= n, net of (n+1)(n+2)/2 points.
Point lattice_value_exactly(const Net& net, int n, int i, int j);

}  // namespace c1mesh
