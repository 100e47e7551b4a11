// SPDX-License-Identifier: GPL-3.0-or-later
// Which boxes meet which: the near-linear filter before the exact tests.
#pragma once

#include <Eigen/Geometry>
#include <utility>
#include <vector>

namespace c1mesh::meshing {

using Box = Eigen::AlignedBox2d;

/// All pairs (i, j), i < j, whose closed boxes meet and of which at least one is in `active`, each
/// once, in no promised order.
std::vector<std::pair<int, int>> meeting_pairs(const std::vector<Box>& boxes,
                                               const std::vector<int>& active);

}  // namespace c1mesh::meshing
