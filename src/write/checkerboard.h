// SPDX-License-Identifier: GPL-3.0-or-later
// The domain's grid as a checkerboard, and its image on the shape.
#pragma once

#include "write/grid_lines.h"
#include "write/svg_canvas.h"

namespace c1mesh {

/// The dark squares between the lines of the grid, triangle by triangle: on the domain as polygons,
/// on the shape (`domain` false) bounded by the images of their sides, exactly up to degree 3.
/// Everything runs counter-clockwise, so one path filled by the nonzero rule has no seams.
void add_dark_squares(PathData& path, const PiecewiseMap& map, const Grid& grid, bool domain);

}  // namespace c1mesh
