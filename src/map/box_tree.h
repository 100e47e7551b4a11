// SPDX-License-Identifier: GPL-3.0-or-later
// Which of many boxes contain a point.
#pragma once

#include <vector>

#include "c1mesh/map.h"

namespace c1mesh {

/// A balanced tree over boxes. Nothing changes after construction.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Indices of the closed boxes that contain p, in increasing order.
  std::vector<int> containing(const Point& p) const;

 private:
  struct Node {
    Box box;
    int first = 0, count = 0;  ///< of `items_`, for a leaf; count 0: an inner node
    int left = -1, right = -1;
  };

  int build(const std::vector<Box>& boxes, int first, int count);

  std::vector<Node> nodes_;
  std::vector<int> items_;
  std::vector<Box> item_boxes_;  ///< in the order of `items_`
};

}  // namespace c1mesh
