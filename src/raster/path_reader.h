// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "raster/brush.h"

namespace c1mesh {

/// Paints the `d` of a path: M, L, C, H, V, Z, m, l, h and v, which is all that our pictures have. Long
/// paths are painted in parts, so that memory stays bounded. Throws std::invalid_argument for
/// anything else.
void paint_path(Brush& brush, std::string_view data, const Look& look);

}  // namespace c1mesh
