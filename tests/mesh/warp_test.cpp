// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "bernstein/net_blossom.h"
#include "mesh/box_pairs.h"
#include "mesh/shapes.h"
#include "mesh/warp_layer.h"

namespace c1mesh::meshing {
namespace {

using namespace test;

TEST(WarpSegment, InteriorAngles) {
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(interior_angle({1, 0}, {0, 1}), pi / 2, 1e-15);       // left turn: convex
  EXPECT_NEAR(interior_angle({1, 0}, {0, -1}), 3 * pi / 2, 1e-15);  // right turn: reflex
  EXPECT_NEAR(interior_angle({1, 0}, {2, 0}), pi, 1e-15);
}

TEST(WarpSegment, DirectionsSkipCoincidingPoles) {
  const BezierCurve curve{{Point(0, 0), Point(0, 0), Point(1, 1), Point(1, 1)}};
  EXPECT_EQ(start_direction(curve), Point(1, 1));
  EXPECT_EQ(end_direction(curve), Point(1, 1));
}

TEST(WarpSegment, SeparationOfSquares) {
  const std::vector<Point> a{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, b{{3, 0}, {4, 0}, {4, 1}, {3, 1}};
  EXPECT_TRUE(separated(a, b, 1.999));
  EXPECT_FALSE(separated(a, b, 2));
  EXPECT_FALSE(separated(a, {{0.5, 0.5}, {2, 2}}, 0));
  EXPECT_TRUE(separated({{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}, 0.999));  // on one line
}

TEST(BoxPairs, AgreeWithBruteForce) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Box> boxes;
  std::vector<int> active;
  for (int i = 0; i < 200; ++i) {
    const Point low(unit(random), unit(random));
    boxes.emplace_back(low, Point(low + 0.1 * Point(unit(random), unit(random))));
    if (i % 3 == 0) active.push_back(i);
  }
  std::vector<std::pair<int, int>> expected;
  for (int i = 0; i < 200; ++i)
    for (int j = i + 1; j < 200; ++j)
      if ((i % 3 == 0 || j % 3 == 0) && boxes[i].intersects(boxes[j])) expected.emplace_back(i, j);
  auto found = meeting_pairs(boxes, active);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

// Points of the straight and of the curved warp triangle.
std::vector<Point> samples(const WarpSegment& s) {
  std::vector<Point> points;
  const std::vector<Point> net = warp_net(s);
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10 - i; ++j) {
      const Barycentric w(1 - 0.1 * (i + j), 0.1 * i, 0.1 * j);
      points.push_back(w[0] * s.curve.start() + w[1] * s.curve.end() + w[2] * s.apex);
      points.push_back(evaluate(net, s.curve.degree(), w));
    }
  return points;
}

bool holds(const std::vector<Point>& hull, const Point& p, double slack) {
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (cross(hull[(i + 1) % hull.size()] - hull[i], p - hull[i]) < -slack) return false;
  return true;
}

TEST(WarpLayer, HullsHoldBothTrianglesAndAreDisjoint) {
  MeshReport report;
  const MeshInput input = input_of({blob(9, 0.5, 8), backwards(circle({0.5, 0.5}, 0.08))});
  const auto layer =
      build_warp_layer(walks_of(input), input.degree, 10, usual_thrift(), 100000, report);
  ASSERT_TRUE(layer);
  std::vector<const WarpSegment*> all;
  for (const auto& loop : *layer) {
    EXPECT_GE(loop.size(), 3u);
    for (const WarpSegment& s : loop) all.push_back(&s);
  }
  EXPECT_EQ(report.warp_triangles, static_cast<int>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto hull = hull_of(*all[i]);
    EXPECT_LE(all[i]->bound, 10);
    for (const Point& p : samples(*all[i])) EXPECT_TRUE(holds(hull, p, 1e-15));
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const bool joined = all[i]->curve.end() == all[j]->curve.start() ||
                          all[j]->curve.end() == all[i]->curve.start();
      if (!joined) {
        EXPECT_TRUE(separated(hull, hull_of(*all[j]), 0)) << i << " " << j;
        continue;
      }
      for (const Point& p : samples(*all[j])) {
        const bool joint = p == all[i]->curve.start() || p == all[i]->curve.end();
        EXPECT_TRUE(joint || !holds(hull, p, -1e-12)) << i << " " << j;
      }
    }
  }
}

TEST(WarpLayer, GivesUpAtItsLimit) {
  MeshReport report;
  const MeshInput input = input_of({spiral(3)});
  EXPECT_FALSE(build_warp_layer(walks_of(input), input.degree, 10, usual_thrift(), 20, report));
}

TEST(WarpLayer, StrictThriftNeedsFewerTriangles) {
  MeshReport usual, strict;
  const MeshInput input = input_of({circle({0.5, 0.5}, 0.5), backwards(circle({0.5, 0.5}, 0.49))});
  ASSERT_TRUE(build_warp_layer(walks_of(input), input.degree, 10, usual_thrift(), 100000, usual));
  ASSERT_TRUE(build_warp_layer(walks_of(input), input.degree, 10, strict_thrift(), 100000, strict));
  EXPECT_LT(strict.warp_triangles, usual.warp_triangles);
}

}  // namespace
}  // namespace c1mesh::meshing
