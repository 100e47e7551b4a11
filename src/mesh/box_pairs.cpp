// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/box_pairs.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace c1mesh::meshing {
namespace {

using IndexedBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;

IndexedBox indexed(const Box& box, int index) {
  double low[2] = {box.min().x(), box.min().y()}, high[2] = {box.max().x(), box.max().y()};
  return IndexedBox(low, high, index);
}

}  // namespace

std::vector<std::pair<int, int>> meeting_pairs(const std::vector<Box>& boxes,
                                               const std::vector<int>& active) {
  std::vector<IndexedBox> all, some;
  std::vector<char> is_active(boxes.size(), 0);
  for (std::size_t i = 0; i < boxes.size(); ++i) all.push_back(indexed(boxes[i], int(i)));
  for (int i : active) some.push_back(indexed(boxes[i], i)), is_active[i] = 1;
  std::vector<std::pair<int, int>> pairs;
  // A pair of two active boxes is found from both sides: the lower one's counts.
  CGAL::box_intersection_d(some.begin(), some.end(), all.begin(), all.end(),
                           [&](const IndexedBox& a, const IndexedBox& b) {
                             const int i = a.info(), j = b.info();
                             if (i < j || (i > j && !is_active[j]))
                               pairs.emplace_back(std::min(i, j), std::max(i, j));
                           });
  return pairs;
}

}  // namespace c1mesh::meshing
