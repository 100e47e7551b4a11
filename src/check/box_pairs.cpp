// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/box_pairs.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace c1mesh::detail {
namespace {

struct TooMany {};

}  // namespace

Box box_of(const std::vector<Point>& points, double margin) {
  Box box{points.front(), points.front()};
  for (const Point& p : points) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

bool overlapping_pairs(const std::vector<Box>& boxes, std::size_t most,
                       std::vector<std::pair<int, int>>& pairs) {
  using Entry = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;
  std::vector<Entry> entries;
  entries.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    entries.emplace_back(
        CGAL::Bbox_2(boxes[i].low.x(), boxes[i].low.y(), boxes[i].high.x(), boxes[i].high.y()),
        static_cast<int>(i));
  pairs.clear();
  try {
    CGAL::box_self_intersection_d(entries.begin(), entries.end(),
                                  [&](const Entry& a, const Entry& b) {
                                    if (pairs.size() >= most) throw TooMany();
                                    pairs.push_back(std::minmax(a.info(), b.info()));
                                  });
  } catch (const TooMany&) {
    return false;
  }
  // The library's order is its own affair.
  std::sort(pairs.begin(), pairs.end());
  return true;
}

}  // namespace c1mesh::detail
