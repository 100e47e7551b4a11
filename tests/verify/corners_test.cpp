// SPDX-License-Identifier: GPL-3.0-or-later
// Counting corners, exceptional vertices and flat vertices on shapes where the counts are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "c1mesh/verify.h"
#include "result/example_results.h"
#include "verify/checks.h"

namespace c1mesh {
namespace {

constexpr double kPi = std::numbers::pi;

/// A ring between two closed polygons of `count` points each, turned by `twist` against each other.
std::vector<std::array<int, 3>> ring_triangles(int count) {
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < count; ++k) {
    const int next = (k + 1) % count;
    triangles.push_back({k, next, count + next});
    triangles.push_back({k, count + next, count + k});
  }
  return triangles;
}

std::vector<Point> ring_points(int count) {
  std::vector<Point> points;
  for (const double radius : {2.0, 1.0})
    for (int k = 0; k < count; ++k)
      points.emplace_back(radius * std::cos(2 * kPi * k / count),
                          radius * std::sin(2 * kPi * k / count));
  return points;
}

// A square ring: outer corners are convex, the hole's are reflex seen from the interior.
TEST(Corners, SquareRingNeedsNoExceptionalVertex) {
  const Result result =
      example::polynomial_result(3, example::identity(), ring_points(4), ring_triangles(4));
  const VerifyReport report = verify(result);
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_EQ(report.metrics.exceptional_minimum, 0);
  EXPECT_EQ(report.metrics.exceptional_minimum_paper, 0);
}

// 72 sides turn by 5 degrees: smooth under the default corner angle of 8, so both loops lack all
// three corners; with a corner angle of 4 degrees all are corners.
TEST(Corners, CornerAngleOfTheRunDecides) {
  Result result =
      example::polynomial_result(3, example::identity(), ring_points(72), ring_triangles(72));
  for (BoundaryVertex& v : result.boundary_vertices) v.corner = false;
  VerifyReport report = verify(result);
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_EQ(report.metrics.exceptional_minimum, 6);
  EXPECT_EQ(report.metrics.surplus, -6);
  EXPECT_EQ(report.metrics.flatness_ratio, 1);  // every mild joint turns as the shape does
  result.exceptional_vertices = {0, 10, 20};
  EXPECT_NEAR(verify(result).metrics.flatness_ratio, 141.0 / 144, 1e-15);
  result.parameters = {{"corner_angle", 4.0}};
  report = verify(result);
  EXPECT_FALSE(report.valid());  // listed smooth
  EXPECT_EQ(report.metrics.exceptional_minimum, 0);
  for (BoundaryVertex& v : result.boundary_vertices) v.corner = true;
  EXPECT_TRUE(verify(result).valid()) << report_text(verify(result));
}

// A square with two opposite corners bent smooth: two corners left, so one exceptional vertex.
TEST(Corners, TwoCornersLeaveOneExceptionalVertex) {
  Result lens = example::square();
  // The handles at (1, 0) and (0, 1) are moved onto one line each.
  const auto handle = [&](const Point& near, const Point& far, const Point& value) {
    for (BezierCurve& c : lens.curves) {
      if (c.start() == near && c.end() == far) c.poles[1] = value;
      if (c.end() == near && c.start() == far) c.poles[2] = value;
    }
  };
  const double h = 0.1;
  handle({1, 0}, {0, 0}, Point(1 - h, -h));
  handle({1, 0}, {1, 1}, Point(1 + h, h));
  handle({0, 1}, {1, 1}, Point(h, 1 + h));
  handle({0, 1}, {0, 0}, Point(-h, 1 - h));
  for (const CurveEdge& e : lens.boundary_edges)
    for (std::size_t t = 0; t < lens.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (lens.triangles[t][k] == e.a && lens.triangles[t][(k + 1) % 3] == e.b)
          for (int s = 0; s <= 3; ++s) {
            const int i = k == 0 ? s : k == 1 ? 3 - s : 0, j = k == 0 ? 0 : k == 1 ? s : 3 - s;
            lens.control_points[lens.triangle_control_points[t][j * 4 - j * (j - 1) / 2 + i]] =
                lens.curves[e.curve].poles[s];
          }
  for (BoundaryVertex& v : lens.boundary_vertices) v.corner = v.vertex == 0 || v.vertex == 2;
  const VerifyReport report = verify(lens);
  EXPECT_TRUE(report.conforming()) << report_text(report);
  for (const VerifyItem& item : report.items)
    if (item.name == "boundary vertices" || item.name == "boundary simple") {
      EXPECT_EQ(item.verdict, Verdict::valid) << item.message;
    }
  EXPECT_EQ(report.metrics.exceptional_minimum, 1);
  EXPECT_EQ(report.metrics.exceptional_minimum_paper, 1);
  EXPECT_EQ(report.metrics.flatness_ratio, 0);  // the domain square turns at both smooth vertices
}

TEST(Corners, DartHasAReflexCornerThatDoesNotCount) {
  // Convex at 0, 1 and 3, reflex at 2.
  const Result dart = example::polynomial_result(
      3, example::identity(), {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, {{0, 1, 2}, {0, 2, 3}});
  const VerifyReport report = verify(dart);
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_EQ(report.metrics.exceptional_minimum, 0);
  EXPECT_EQ(report.metrics.exceptional_minimum_paper, 0);
}

TEST(Spreads, NearestRank) {
  const Spread odd = verification::spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(odd.median, 3);
  EXPECT_EQ(odd.p99, 5);
  EXPECT_EQ(odd.max, 5);
  std::vector<double> many;
  for (int k = 200; k > 0; --k) many.push_back(k);
  EXPECT_EQ(verification::spread_of(many).median, 100);
  EXPECT_EQ(verification::spread_of(many).p99, 198);
  EXPECT_EQ(verification::spread_of({}).max, 0);
}

}  // namespace
}  // namespace c1mesh
