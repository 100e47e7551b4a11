// SPDX-License-Identifier: GPL-3.0-or-later
// The length that relative tolerances refer to.
#pragma once

#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// The larger side of the points' bounding box. Precondition: there is at least one.
inline double extent_of(const std::vector<Point>& points) {
  Point low = points.front(), high = low;
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

}  // namespace c1mesh
