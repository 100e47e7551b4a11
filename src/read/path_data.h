// SPDX-License-Identifier: GPL-3.0-or-later
// SVG path data (the `d` attribute) and point lists.
#pragma once

#include <string_view>

#include "read/outline.h"

namespace c1mesh::detail {

/// All of M L H V C S Q T A Z, absolute and relative, in their compact spelling. Unlike a browser,
/// which draws up to the first error, any error is refused: half a shape is a wrong shape.
/// Throws SyntaxError. Degrees are kept: lines 1, quadratics 2, cubics and arcs 3.
Outline parse_path(std::string_view text);

/// The `points` attribute of polygon and polyline. Throws SyntaxError.
std::vector<Point> parse_points(std::string_view text);

}  // namespace c1mesh::detail
