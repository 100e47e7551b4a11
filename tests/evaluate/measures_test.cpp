// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of one shape against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "c1mesh/evaluate.h"
#include "examples.h"

namespace c1mesh {
namespace {

std::size_t larger_than(const std::vector<double>& sample, double bound) {
  return static_cast<std::size_t>(
      std::count_if(sample.begin(), sample.end(), [bound](double x) { return x > bound; }));
}

// Moving p_11 of (0,0), (1,0), (1,1) by h along x adds 6 h l0 l1 l2 to x, with l1 = x - y the
// coordinate that vanishes on the diagonal. So x has the gradient (1 + c, -c) on that side, c = 6 h
// s (1-s), and (1, 0) on the other; s = 4/9 and 5/9 are the sampled points with the largest c.
TEST(Measures, AKnownDeviation) {
  constexpr double h = 0x1p-6;
  const ShapeEvaluation shape = evaluate(example::bent_square(h));
  ASSERT_TRUE(shape.evaluated) << shape.fault;
  ASSERT_EQ(shape.samples.d_ei.size(), 3u);
  EXPECT_NEAR(shape.metrics.d_ei.max, h, 1e-15);
  EXPECT_EQ(larger_than(shape.samples.d_ei, 1e-15), 1u);
  const double c = 6 * h * 20 / 81, length = std::hypot(1 + c, c);
  ASSERT_EQ(shape.samples.gradient_angle_deg.size(), 1u);
  EXPECT_NEAR(shape.samples.gradient_angle_deg[0], std::atan2(c, 1 + c) * 180 / std::numbers::pi,
              1e-12);
  ASSERT_EQ(shape.samples.gradient_magnitude.size(), 1u);
  EXPECT_NEAR(shape.samples.gradient_magnitude[0], (length - 1) / length, 1e-14);
  EXPECT_TRUE(shape.regular);
  EXPECT_TRUE(shape.conforming);
  EXPECT_FALSE(shape.c1);
  EXPECT_FALSE(shape.valid);
}

// As `c1mesh verify` does: a result is certified to the bounds that it claims.
TEST(Measures, TheBoundsOfTheResultDecide) {
  Result result = example::bent_square(0x1p-6);
  result.parameters = {{"c1_bound", 0.1}};
  EXPECT_TRUE(evaluate(result).c1);
  result.parameters = {{"c1_bound", 0.01}};
  EXPECT_FALSE(evaluate(result).c1);
}

TEST(Measures, OfAC1Map) {
  const ShapeEvaluation shape = evaluate(example::grid(4, 3, example::cubic_map()));
  EXPECT_TRUE(shape.valid);
  EXPECT_EQ(shape.metrics.triangles, 32);
  EXPECT_EQ(shape.samples.d_ei.size(), 3u * 40);  // 3 * 32 sides, 16 of them on the boundary
  EXPECT_LT(shape.metrics.d_ei.max, 4e-16);
  EXPECT_EQ(shape.samples.conformance.size(), 3u * 16);
  EXPECT_EQ(larger_than(shape.samples.conformance, 0), 0u);
}

// A projection moves control points of the boundary: the distance counts, relative to the extent.
TEST(Measures, AMovedBoundary) {
  const example::Polynomial fourfold = {{1, 0, Point(4, 0)}, {0, 1, Point(0, 4)}};
  Result result = example::square(3, fourfold);
  result.control_points[example::control_id(result, 0, 1, 0)] += Point(-0x3p-20, 0x4p-20);
  const ShapeEvaluation shape = evaluate(result);
  ASSERT_EQ(shape.samples.conformance.size(), 12u);  // four sides, three each
  EXPECT_EQ(larger_than(shape.samples.conformance, 0), 1u);
  EXPECT_NEAR(shape.metrics.conformance_max, 0x5p-22, 1e-17);  // |(3, 4)| = 5, extent 4
  EXPECT_FALSE(shape.conforming);
  EXPECT_TRUE(shape.regular);
}

// A vertex lies on two curves: it is one control point, and its larger distance counts.
TEST(Measures, AMovedCornerIsOneControlPoint) {
  Result result = example::square();
  result.control_points[example::control_id(result, 0, 0, 0)] -= Point(0x1p-10, 0);
  const ShapeEvaluation shape = evaluate(result);
  ASSERT_EQ(shape.samples.conformance.size(), 12u);
  EXPECT_EQ(larger_than(shape.samples.conformance, 0), 1u);
  EXPECT_NEAR(shape.metrics.conformance_max, 0x1p-10, 1e-17);
}

// Two convex corners and a reflex one: all three by the paper's count, two by the true one.
TEST(Measures, AReflexCornerTellsTheTwoMinimaApart) {
  Result result = example::notched();
  result.exceptional_vertices = {20};
  const ShapeEvaluation shape = evaluate(result);
  EXPECT_TRUE(shape.valid);
  EXPECT_EQ(shape.metrics.exceptional_minimum, 1);
  EXPECT_EQ(shape.metrics.surplus, 0);
  EXPECT_EQ(shape.metrics.exceptional_minimum_paper, 0);
  EXPECT_EQ(shape.surplus_paper(), 1);
}

TEST(Measures, AFlippedTriangleIsNotRegularAndGIsInfinite) {
  Result result = example::square();
  result.control_points[example::control_id(result, 0, 1, 1)] += Point(-3, 3);
  const ShapeEvaluation shape = evaluate(result);
  EXPECT_TRUE(shape.evaluated);
  EXPECT_FALSE(shape.regular);
  EXPECT_TRUE(std::isinf(shape.metrics.mips_bound_max));
}

TEST(Measures, WithoutStructureNothingIsMeasured) {
  Result result = example::square();
  result.triangle_control_points[0].pop_back();
  const ShapeEvaluation shape = evaluate(result);
  EXPECT_FALSE(shape.evaluated);
  EXPECT_TRUE(shape.unreadable);
  EXPECT_NE(shape.fault, "");
}

TEST(Series, PoolsSamplesAndKeepsTheLargestOfEachShape) {
  std::vector<ShapeEvaluation> shapes;
  for (int k = 3; k >= 1; --k) {
    shapes.push_back(evaluate(example::bent_square(std::ldexp(1, -10 * k))));
    shapes.back().name = "s" + std::to_string(k);
  }
  shapes.push_back(evaluate(example::notched()));
  shapes.back().name = "n";
  const Series series = make_series("S", shapes);
  EXPECT_EQ(series.shapes.front().name, "n");
  EXPECT_EQ(series.shapes.back().name, "s3");
  const SeriesSummary& s = series.summary;
  EXPECT_EQ(s.d_ei.all.count, 3u * 3 + 3u * 72);  // the notched one has 72 inner edges
  EXPECT_EQ(s.d_ei.largest.count, 4u);
  EXPECT_NEAR(s.d_ei.largest.spread.max, 0x1p-10, 1e-15);
  EXPECT_EQ(s.d_ei.all.histogram.total(), s.d_ei.all.count);
  EXPECT_EQ(s.c1, 1u);
  EXPECT_EQ(s.regular, 4u);
  EXPECT_EQ(s.exceptional, (ValueCounts{{0, 4}}));
  EXPECT_EQ(s.surplus, (ValueCounts{{-1, 1}, {0, 3}}));
  EXPECT_EQ(s.surplus_paper, (ValueCounts{{0, 4}}));
}

}  // namespace
}  // namespace c1mesh
