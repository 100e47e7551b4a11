// SPDX-License-Identifier: GPL-3.0-or-later
// Iso-lines of the domain, cut at the triangles and joined across them.
#pragma once

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

/// `count` evenly spaced lines over the longer side of the domain's bounding box, the same spacing
/// along the other side; half a spacing away from the box.
std::vector<IsoLine> iso_lines(const Result& result, int count);

}  // namespace c1mesh
