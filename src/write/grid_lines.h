// SPDX-License-Identifier: GPL-3.0-or-later
// Iso-lines of the domain, cut at the triangles and joined across them.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "write/piecewise_map.h"

namespace c1mesh {

/// A straight piece inside one triangle.
struct LinePiece {
  int triangle = -1;
  Barycentric from, to;
};

/// A maximal run of pieces along u = value (axis 0) or v = value (axis 1), in growing order of the
/// other coordinate; each piece starts where the one before it ends.
struct IsoLine {
  int axis = 0;
  double value = 0;
  std::vector<LinePiece> pieces;
};

/// Lines at equal distances over the domain's bounding box, the same along both sides; half a step
/// away from the box, or as much as the shorter side leaves.
struct Grid {
  Point first = Point::Zero();  ///< the first line's coordinate on each axis
  double step = 0;              ///< 0: there is no grid
  std::array<int, 2> lines{0, 0};
  Point low = Point::Zero(), high = Point::Zero();  ///< the box
  double line(int axis, int k) const { return first[axis] + k * step; }
  /// The square from line k to line k + 1 that holds a coordinate; -1 before the first line.
  int square(int axis, double value) const {
    return static_cast<int>(std::floor((value - first[axis]) / step));
  }
};

/// `count` lines over the longer side.
Grid grid_of(const Result& result, int count);

/// `count` evenly spaced lines over the longer side of the domain's bounding box, the same spacing
/// along the other side; half a spacing away from the box.
std::vector<IsoLine> iso_lines(const Result& result, int count);

}  // namespace c1mesh
