// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/nearest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace c1mesh {
namespace {

TEST(NearestPoint, IsThatOfAllPoints) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-1, 1);
  for (const int count : {1, 2, 3, 17, 400}) {
    std::vector<Point> points;
    // Many share a coordinate, and some are the same.
    for (int i = 0; i < count; ++i)
      points.emplace_back(std::round(8 * place(random)) / 8, place(random));
    points.push_back(points[0]);
    const NearestPoint nearest(points);
    for (int k = 0; k < 200; ++k) {
      const Point p(place(random), place(random));
      double least = INFINITY;
      for (const Point& q : points) least = std::min(least, (q - p).norm());
      EXPECT_EQ(nearest.distance(p), least);
    }
    EXPECT_EQ(nearest.distance(points.back()), 0);
  }
  EXPECT_EQ(NearestPoint({}).distance(Point(0, 0)), INFINITY);
}

}  // namespace
}  // namespace c1mesh
