// SPDX-License-Identifier: GPL-3.0-or-later
// Which of many boxes overlap.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh::detail {

struct Box {
  Point low, high;
};

/// The smallest box around the points, grown by `margin` on all sides.
Box box_of(const std::vector<Point>& points, double margin);

/// All pairs (a < b, sorted) of boxes that overlap or touch, in O(n log^2 n + pairs). False if
/// there are more than `most`; `pairs` is then incomplete.
bool overlapping_pairs(const std::vector<Box>& boxes, std::size_t most,
                       std::vector<std::pair<int, int>>& pairs);

/// Per point the boxes that contain it, by increasing number; near-linear in what goes in and out.
std::vector<std::vector<int>> boxes_around(const std::vector<Point>& points,
                                           const std::vector<Box>& boxes);

}  // namespace c1mesh::detail
