// SPDX-License-Identifier: GPL-3.0-or-later
// Many loops.
#include <cmath>

#include "generate/families.h"

namespace c1mesh::generate_detail {
namespace {

Curves square(const Point& centre, double half, bool counter_clockwise) {
  std::vector<Point> points;
  for (int k = 0; k < 4; ++k)
    points.push_back(centre + half * std::sqrt(2.0) *
                                  unit_at(counter_clockwise ? 45 + 90.0 * k : 45 - 90.0 * k));
  return polygon(points);
}

// A square of side 2 with holes row by row on the coarsest grid that has room for them.
template <typename Hole>
Curves with_holes(int holes, const Hole& hole) {
  Curves all = square({0, 0}, 1, true);
  int side = 1;
  while (side * side < holes) ++side;
  for (int k = 0; k < holes; ++k)
    append(all, hole(Point((2 * (k % side) + 1.0) / side - 1, (2 * (k / side) + 1.0) / side - 1),
                     1.0 / side));
  return all;
}

}  // namespace

Curves plate(double holes, Random&) {
  return with_holes(static_cast<int>(holes), [](const Point& centre, double half_cell) {
    return circle(centre, 0.6 * half_cell, false);
  });
}

Curves grate(double holes, Random&) {
  return with_holes(static_cast<int>(holes), [](const Point& centre, double half_cell) {
    return square(centre, 0.6 * half_cell, false);
  });
}

// Outer loops and holes in turn: with 2k loops there are k rings.
Curves rings(double loops, Random&) {
  Curves all;
  double size = 1;  // radius, or half a side
  for (int k = 0; k < loops; ++k) {
    append(all, k % 2 == 0 ? circle({0, 0}, size, true) : square({0, 0}, size, false));
    size *= k % 2 == 0 ? 0.6 : 0.85;
  }
  return all;
}

}  // namespace c1mesh::generate_detail
