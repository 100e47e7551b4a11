// SPDX-License-Identifier: GPL-3.0-or-later
// Which of many boxes meet, in near-linear time.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh::verification {

struct Box {
  std::array<double, 2> low, high;
};

Box box_of(const std::vector<Point>& points);

/// All pairs i < j of closed boxes that have a point in common, in increasing order.
std::vector<std::pair<int, int>> meeting_pairs(const std::vector<Box>& boxes);

/// All pairs (i, j) with points[i] in the closed boxes[j], in increasing order.
std::vector<std::pair<int, int>> containing_pairs(const std::vector<Point>& points,
                                                  const std::vector<Box>& boxes);

}  // namespace c1mesh::verification
