// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace c1mesh {

NearestPoint::NearestPoint(std::vector<Point> points) : points_(std::move(points)) {
  arrange(0, static_cast<int>(points_.size()), 0);
}

double NearestPoint::distance(const Point& p) const {
  double least = std::numeric_limits<double>::infinity();
  search(0, static_cast<int>(points_.size()), 0, p, least);
  return least;
}

void NearestPoint::arrange(int first, int last, int axis) {
  if (last - first < 2) return;
  const int middle = first + (last - first) / 2;
  std::nth_element(points_.begin() + first, points_.begin() + middle, points_.begin() + last,
                   [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
  arrange(first, middle, 1 - axis);
  arrange(middle + 1, last, 1 - axis);
}

void NearestPoint::search(int first, int last, int axis, const Point& p, double& least) const {
  if (first >= last) return;
  const int middle = first + (last - first) / 2;
  least = std::min(least, (points_[middle] - p).norm());
  const double beyond = p[axis] - points_[middle][axis];
  const bool low = beyond < 0;
  low ? search(first, middle, 1 - axis, p, least) : search(middle + 1, last, 1 - axis, p, least);
  if (std::abs(beyond) <= least)
    low ? search(middle + 1, last, 1 - axis, p, least) : search(first, middle, 1 - axis, p, least);
}

}  // namespace c1mesh
