// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "check/box_pairs.h"
#include "check/stages.h"
#include "check/winding.h"

namespace c1mesh::detail {
namespace {

Cone cone(double axis_degrees, double half_degrees) {
  const double a = axis_degrees * std::numbers::pi / 180, h = half_degrees * std::numbers::pi / 180;
  return {Point(std::cos(a), std::sin(a)), -h, h};
}

TEST(Cones, DisjointUpToWholeTurns) {
  EXPECT_TRUE(disjoint(cone(0, 10), cone(30, 10)));
  EXPECT_FALSE(disjoint(cone(0, 20), cone(30, 20)));
  EXPECT_TRUE(disjoint(cone(170, 5), cone(-170, 5)));
  EXPECT_FALSE(disjoint(cone(170, 15), cone(-170, 15)));
  EXPECT_TRUE(disjoint(cone(0, 80), cone(180, 80)));
  EXPECT_FALSE(disjoint(cone(0, 95), cone(180, 10)));  // not convex
}

TEST(Pieces, HalvesShareTheirMiddleAndKeepTheEnds) {
  const Poles2 poles = {{0.1, 0.2}, {0.9, -0.3}, {1.7, 0.8}, {0.3, 1.1}, {2, 2}};
  Poles2 first, second;
  halve(poles, first, second);
  ASSERT_EQ(first.size(), poles.size());
  ASSERT_EQ(second.size(), poles.size());
  EXPECT_EQ(first.front(), poles.front());
  EXPECT_EQ(second.back(), poles.back());
  EXPECT_EQ(first.back(), second.front());
  // The middle by the binomial formula.
  const Point middle = (poles[0] + 4 * poles[1] + 6 * poles[2] + 4 * poles[3] + poles[4]) / 16;
  EXPECT_LT((first.back() - middle).norm(), 1e-15);
}

TEST(Boxes, PairsAreThoseOfTheQuadraticSearch) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 1), size(0, 0.1);
  std::vector<Box> boxes;
  for (int i = 0; i < 400; ++i) {
    const Point p(place(random), place(random));
    boxes.push_back({p, p + Point(size(random), size(random))});
  }
  boxes.push_back(boxes[7]);
  std::vector<std::pair<int, int>> expected, found;
  for (int i = 0; i < 401; ++i)
    for (int j = i + 1; j < 401; ++j)
      if ((boxes[i].low.array() <= boxes[j].high.array()).all() &&
          (boxes[j].low.array() <= boxes[i].high.array()).all())
        expected.push_back({i, j});
  EXPECT_TRUE(overlapping_pairs(boxes, 1'000'000, found));
  EXPECT_EQ(found, expected);
  EXPECT_FALSE(overlapping_pairs(boxes, 10, found));
}

// Area of the region between y = 0 and y = x(1-x) is 1/6, between it and degree-raised copies too.
TEST(Areas, ParabolaInClosedForm) {
  for (int degree = 2; degree <= 6; ++degree) {
    // x(1-x) in Bernstein form of degree n: coefficient i (n-i) / (n (n-1)).
    BezierCurve top;
    for (int i = degree; i >= 0; --i)
      top.poles.emplace_back(double(i) / degree,
                             double(i) * (degree - i) / (degree * (degree - 1)));
    Arrangement arrangement;
    arrangement.curves = {BezierCurve{{{0, 0}, {1, 0}}}, top};
    EXPECT_NEAR(signed_area({{0, false}, {1, false}}, arrangement), 1.0 / 6, 1e-15) << degree;
    EXPECT_NEAR(signed_area({{1, true}, {0, true}}, arrangement), -1.0 / 6, 1e-15) << degree;
  }
}

}  // namespace
}  // namespace c1mesh::detail
