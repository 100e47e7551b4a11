// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of a result's mesh with what a picture tells about them.
#pragma once

#include <array>
#include <vector>

#include "c1mesh/result.h"
#include "write/piecewise_map.h"

namespace c1mesh {

enum class EdgeKind { smooth = 0, boundary = 1, feature = 2, relaxed = 3 };

struct DrawnEdge {
  int a = -1, b = -1;
  /// The triangles on the left of a -> b and of b -> a, and their corner where the edge starts;
  /// triangle[1] is -1 on the boundary.
  std::array<int, 2> triangle{-1, -1}, corner{-1, -1};
  EdgeKind kind = EdgeKind::smooth;
  double c1_deviation = 0;  ///< largest d_ei of both orientations, relative to the extent
};

/// In order of first appearance, triangle by triangle.
std::vector<DrawnEdge> edges_of(const PiecewiseMap& map);

/// Larger side of the bounding box of the control points.
double extent_of(const Result& result);

/// Which connected piece (over shared edges) each triangle belongs to, numbered from 0.
std::vector<int> regions_of(const Result& result, const std::vector<DrawnEdge>& edges);

}  // namespace c1mesh
