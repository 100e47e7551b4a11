// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of curved triangles as other programs want them: their order, and where they lie.
#pragma once

#include <array>
#include <vector>

#include "write/piecewise_map.h"

namespace c1mesh {

/// The (i, j) of the points of a triangle of degree n in the order of VTK and of Gmsh: the corners,
/// the insides of the edges 01, 12 and 20, each in running direction, then the inside as a triangle
/// of degree n-3.
std::vector<std::array<int, 2>> recursive_order(int n);

/// Control point ids of triangle t in that order.
std::vector<int> triangle_nodes(const PiecewiseMap& map, int t);

/// Control point ids of triangle t's edge from corner k to k+1: the ends, then the inside.
std::vector<int> edge_nodes(const PiecewiseMap& map, int t, int k);

/// By control point id, where the point with this place in its triangle's lattice lies on the
/// shape: the interpolation nodes of the same map as Lagrange elements. Exact, rounded once.
/// Ids that no triangle uses keep their control point.
std::vector<Point> interpolation_nodes(const PiecewiseMap& map);

/// By control point id, where it sits in the domain: the straight triangle's lattice has p_ij at
/// ((n-i-j) a + i b + j c) / n. These are Bernstein coefficients of the coordinates u and v as well
/// as their values at the interpolation nodes.
std::vector<Point> domain_net(const PiecewiseMap& map);

/// By control point id, whether a triangle uses it.
std::vector<char> used_nodes(const Result& result);

}  // namespace c1mesh
