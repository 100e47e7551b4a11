// SPDX-License-Identifier: GPL-3.0-or-later
// The distance to the nearest of many points, in logarithmic time.
#pragma once

#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

class NearestPoint {
 public:
  explicit NearestPoint(std::vector<Point> points);
  /// |p - q| for the nearest point q, as that expression rounds; infinite if there are no points.
  double distance(const Point& p) const;

 private:
  void arrange(int first, int last, int axis);
  void search(int first, int last, int axis, const Point& p, double& least) const;

  std::vector<Point> points_;  // a tree of medians: the middle of a range splits the rest of it
};

}  // namespace c1mesh
