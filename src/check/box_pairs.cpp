// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/box_pairs.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace c1mesh::detail {
namespace {

using Entry = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;

struct TooMany {};

Entry entry_of(const Box& box, std::size_t index) {
  return {CGAL::Bbox_2(box.low.x(), box.low.y(), box.high.x(), box.high.y()),
          static_cast<int>(index)};
}

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
  std::vector<Entry> entries;
  entries.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) entries.push_back(entry_of(boxes[i], i));
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

std::vector<std::vector<int>> boxes_around(const std::vector<Point>& points,
                                           const std::vector<Box>& boxes) {
  std::vector<Entry> small, large;
  for (std::size_t i = 0; i < points.size(); ++i)
    small.push_back(entry_of({points[i], points[i]}, i));
  for (std::size_t i = 0; i < boxes.size(); ++i) large.push_back(entry_of(boxes[i], i));
  std::vector<std::vector<int>> out(points.size());
  CGAL::box_intersection_d(
      small.begin(), small.end(), large.begin(), large.end(),
      [&](const Entry& a, const Entry& b) { out[a.info()].push_back(b.info()); });
  for (auto& around : out) std::sort(around.begin(), around.end());
  return out;
}

}  // namespace c1mesh::detail
