// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/box_tree.h"

#include <algorithm>
#include <numeric>

namespace c1mesh {
namespace {

constexpr int kLeaf = 4;  // boxes of a leaf at most

bool contains(const Box& box, const Point& p) {
  return p.x() >= box.low.x() && p.x() <= box.high.x() && p.y() >= box.low.y() &&
         p.y() <= box.high.y();
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (boxes.empty()) return;
  build(boxes, 0, static_cast<int>(boxes.size()));
  for (const int i : items_) item_boxes_.push_back(boxes[i]);
}

// Halves the boxes by their centres along the longer side of what they cover; ties by index, so
// that the tree depends on the boxes alone.
int BoxTree::build(const std::vector<Box>& boxes, int first, int count) {
  const int id = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Box all = boxes[items_[first]];
  for (int k = first; k < first + count; ++k) {
    all.low = all.low.cwiseMin(boxes[items_[k]].low);
    all.high = all.high.cwiseMax(boxes[items_[k]].high);
  }
  nodes_[id].box = all;
  if (count <= kLeaf) {
    nodes_[id].first = first;
    nodes_[id].count = count;
    return id;
  }
  const int axis = all.high.x() - all.low.x() >= all.high.y() - all.low.y() ? 0 : 1;
  const auto centre = [&](int i) { return boxes[i].low[axis] / 2 + boxes[i].high[axis] / 2; };
  const int half = count / 2;
  std::nth_element(
      items_.begin() + first, items_.begin() + first + half, items_.begin() + first + count,
      [&](int a, int b) { return centre(a) != centre(b) ? centre(a) < centre(b) : a < b; });
  const int left = build(boxes, first, half);
  const int right = build(boxes, first + half, count - half);
  nodes_[id].left = left;
  nodes_[id].right = right;
  return id;
}

std::vector<int> BoxTree::containing(const Point& p) const {
  std::vector<int> found, open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    if (!contains(node.box, p)) continue;
    if (node.count == 0) {
      open.push_back(node.left);
      open.push_back(node.right);
    }
    for (int k = node.first; k < node.first + node.count; ++k)
      if (contains(item_boxes_[k], p)) found.push_back(items_[k]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace c1mesh
