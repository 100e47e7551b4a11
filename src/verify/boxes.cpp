// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/boxes.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace c1mesh::verification {
namespace {

using Handled = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Box*>;

std::vector<Handled> handled_of(const std::vector<Box>& boxes) {
  std::vector<Handled> out;
  for (const Box& box : boxes) {
    Handled h(&box);
    std::array<double, 2> low = box.low, high = box.high;
    h.extend(low.data());
    h.extend(high.data());
    out.push_back(h);
  }
  return out;
}

}  // namespace

Box box_of(const std::vector<Point>& points) {
  Box box{{points[0].x(), points[0].y()}, {points[0].x(), points[0].y()}};
  for (const Point& p : points)
    for (int k = 0; k < 2; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  return box;
}

std::vector<std::pair<int, int>> meeting_pairs(const std::vector<Box>& boxes) {
  std::vector<Handled> handled = handled_of(boxes);
  std::vector<std::pair<int, int>> pairs;
  if (boxes.size() < 2) return pairs;
  CGAL::box_self_intersection_d(handled.begin(), handled.end(),
                                [&](const Handled& a, const Handled& b) {
                                  const int i = static_cast<int>(a.handle() - boxes.data());
                                  const int j = static_cast<int>(b.handle() - boxes.data());
                                  pairs.emplace_back(std::min(i, j), std::max(i, j));
                                });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<std::pair<int, int>> containing_pairs(const std::vector<Point>& points,
                                                  const std::vector<Box>& boxes) {
  std::vector<Box> small;
  for (const Point& p : points) small.push_back({{p.x(), p.y()}, {p.x(), p.y()}});
  std::vector<Handled> first = handled_of(small), second = handled_of(boxes);
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_intersection_d(first.begin(), first.end(), second.begin(), second.end(),
                           [&](const Handled& a, const Handled& b) {
                             pairs.emplace_back(static_cast<int>(a.handle() - small.data()),
                                                static_cast<int>(b.handle() - boxes.data()));
                           });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace c1mesh::verification
