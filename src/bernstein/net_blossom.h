// SPDX-License-Identifier: GPL-3.0-or-later
// Exact pieces of a Bezier triangle by its blossom (polar form).
#pragma once

#include <vector>

#include "bernstein/jacobian.h"
#include "c1mesh/barycentric.h"

namespace c1mesh {

/// Index of p_ij in a net of degree n.
inline int net_index(int n, int i, int j) {
  return j * (n + 1) - j * (j - 1) / 2 + i;
}

/// One de Casteljau step, in place: the net of degree n becomes the one of degree n - 1 of the map
/// with one argument of its blossom fixed. What is left of the longer net lies behind it.
void reduce_net(Net& net, int n, const Barycentric& argument);

/// The blossom of the net of degree n at n arguments: one de Casteljau step per argument. Linear in
/// each argument, independent of their order, and at n times the same argument the map itself.
Point blossom(Net net, int degree, const std::vector<Barycentric>& arguments);

/// The map at a point.
Point evaluate(const Net& net, int degree, const Barycentric& where);

/// The net of the map restricted to the triangle with corners a, b, c (in the net's barycentric
/// coordinates): p_ij = blossom(a^(n-i-j), b^i, c^j).
Net restrict_net(const Net& net, int degree, const Barycentric& a, const Barycentric& b,
                 const Barycentric& c);

/// The n + 1 control points of the map along the straight line from a to b.
std::vector<Point> restrict_net_to_line(const Net& net, int degree, const Barycentric& a,
                                        const Barycentric& b);

}  // namespace c1mesh
