// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of every kind: degrees, straight sides, a single curve, holes and islands, far away,
// sharp.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "c1mesh/generate.h"
#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::components;
using testing_pipeline::concentric;
using testing_pipeline::data;
using testing_pipeline::euler_characteristic;
using testing_pipeline::example;
using testing_pipeline::expect_valid_and_c1;
using testing_pipeline::polygon;

class Degrees : public testing::TestWithParam<int> {};

TEST_P(Degrees, OfTheResultAreThoseAsked) {
  Options options;
  options.degree = GetParam();
  const Outcome outcome = parametrize(example("blob"), options);
  expect_valid_and_c1(outcome);
  EXPECT_EQ(outcome.result.degree, GetParam());
  const std::size_t net = (GetParam() + 1) * (GetParam() + 2) / 2;
  for (const auto& ids : outcome.result.triangle_control_points) EXPECT_EQ(ids.size(), net);
  // A smooth loop needs a triangle's three corners, of whatever degree the map is.
  EXPECT_EQ(outcome.result.metrics.exceptional, 3);
}

INSTANTIATE_TEST_SUITE_P(All, Degrees, testing::Values(4, 5));

TEST(Degrees, AreRaisedToTheHighestOfTheInput) {
  const Shape shape = data("nasty/degree4.json");
  const Outcome outcome = parametrize(shape);
  expect_valid_and_c1(outcome);
  EXPECT_EQ(shape.highest_degree(), 4);
  EXPECT_EQ(outcome.result.degree, 4);
}

// Ring, ring in its hole, disc in the hole of that: every loop is smooth and needs three
// exceptional vertices of its own.
TEST(Islands, InHolesAreRegionsOfOneResult) {
  const Shape shape = concentric({5, 4, 3, 2, 1});
  ASSERT_EQ(shape.regions.size(), 3u);
  const Outcome outcome = parametrize(shape);
  expect_valid_and_c1(outcome);
  EXPECT_EQ(components(outcome.result), 3);
  EXPECT_EQ(euler_characteristic(outcome.result), 3 - 2);
  EXPECT_EQ(outcome.result.metrics.exceptional, 5 * 3);
  EXPECT_EQ(outcome.result.metrics.exceptional_minimum, 5 * 3);
}

// A rectangle over a rectangle of the same proportions is an identity up to scale: MIPS 2.
TEST(StraightSides, RectangleNeedsNoDistortion) {
  const Outcome outcome = parametrize(polygon({{0, 0}, {3, 0}, {3, 1}, {0, 1}}));
  expect_valid_and_c1(outcome);
  EXPECT_EQ(outcome.result.metrics.exceptional, 0);
  EXPECT_LT(outcome.result.metrics.mips_bound_max, 2.5);
}

TEST(StraightSides, UnitSquareOfLines) {
  const Outcome outcome = parametrize(data("nasty/degree1-square.json"));
  expect_valid_and_c1(outcome);
  EXPECT_EQ(outcome.result.metrics.exceptional, 0);
}

// Its convex corners of 1, 89.5 and 89.5 degrees are those of a domain triangle.
TEST(StraightSides, TriangleWithACornerOfOneDegree) {
  const double half = std::numbers::pi / 360;
  const Outcome outcome = parametrize(
      polygon({{0, 0}, {std::cos(half), -std::sin(half)}, {std::cos(half), std::sin(half)}}));
  expect_valid_and_c1(outcome);
  EXPECT_EQ(outcome.result.metrics.exceptional, 0);
}

// One convex corner of the three a loop needs.
TEST(OneCurve, DropHasTwoExceptionalVertices) {
  const Outcome outcome = parametrize(data("nasty/one-curve-drop.json"));
  expect_valid_and_c1(outcome);
  EXPECT_EQ(outcome.result.curves.size(), 1u);
  EXPECT_EQ(outcome.result.metrics.exceptional, 2);
}

// Coordinates near 1e9 are multiples of 2^-23 = 1.2e-7, so that conformance holds to that and no
// better; C1 to that times the weights (g0, g1, g2) that extrapolate across an edge, for which
// verify allows edge by edge. The certificate is about the doubles as they are.
TEST(FarAway, ShapeOfSizeThreeAtABillion) {
  const Shape shape = data("nasty/offset-1e9.json");
  const Outcome outcome = parametrize(shape);
  EXPECT_TRUE(outcome.report.valid()) << report_text(outcome.report);
  const double spacing = std::ldexp(1.0, -23) / shape.frame.extent();
  EXPECT_LE(outcome.report.metrics.d_ei.max, 32 * spacing);
  EXPECT_LE(outcome.report.metrics.conformance_max, 2 * spacing);
}

class RandomShapes : public testing::TestWithParam<int> {};

TEST_P(RandomShapes, AreDone) {
  const Drawing drawing = generate('A', 5, 1).at(GetParam());
  const Outcome outcome = parametrize(make_shape(drawing));
  expect_valid_and_c1(outcome);
  EXPECT_TRUE(outcome.within_bounds) << drawing.name;
  EXPECT_EQ(components(outcome.result), 1);
  EXPECT_EQ(euler_characteristic(outcome.result), 1);
}

INSTANTIATE_TEST_SUITE_P(SetA, RandomShapes, testing::Range(0, 5));

}  // namespace
}  // namespace c1mesh
