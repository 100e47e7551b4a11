// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of every kind: degrees, straight sides, a single curve, holes and islands, far away,
// sharp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

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

// The largest 1 + |g0| + |g1| + |g2| over the interior edges where C1 is asked: what errors of the
// four control points of a C1 condition are multiplied by (docs/format.md).
double largest_gain(const Result& result) {
  std::map<std::array<int, 2>, int> opposite;  // directed edge -> the triangle's third vertex
  for (const auto& t : result.triangles)
    for (int c = 0; c < 3; ++c) opposite[{t[c], t[(c + 1) % 3]}] = t[(c + 2) % 3];
  std::set<std::array<int, 2>> relaxed;
  for (const auto& e : result.relaxed_edges)
    relaxed.insert({std::min(e[0], e[1]), std::max(e[0], e[1])});
  const auto& at = result.domain_vertices;
  double gain = 0;
  for (const auto& [edge, far] : opposite) {
    const auto [a, b] = edge;
    const auto other = opposite.find({b, a});
    if (other == opposite.end() || relaxed.count({std::min(a, b), std::max(a, b)})) continue;
    const Point u = at[b] - at[a], v = at[far] - at[a], w = at[other->second] - at[a];
    const double g1 = cross(w, v) / cross(u, v), g2 = cross(u, w) / cross(u, v);
    gain = std::max(gain, 1 + std::abs(1 - g1 - g2) + std::abs(g1) + std::abs(g2));
  }
  return gain;
}

// Coordinates near 1e9 are multiples of 2^-23 = 1.2e-7, so that conformance holds to that and no
// better, and C1 to what the rounding of the control points leaves: half a spacing each way.
TEST(FarAway, ShapeOfSizeThreeAtABillion) {
  const Outcome outcome = parametrize(data("nasty/offset-1e9.json"));
  EXPECT_TRUE(outcome.report.valid()) << report_text(outcome.report);
  const double spacing = std::ldexp(1.0, -23) / 4;  // the larger side is between 4 and 5
  EXPECT_LE(outcome.report.metrics.conformance_max, 2 * spacing);
  EXPECT_LE(outcome.report.metrics.d_ei.max,
            std::numbers::sqrt2 / 2 * spacing * largest_gain(outcome.result));
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

// A comb's teeth end side by side; the arrow's hole folds easily.
TEST(NoOverlap, HoldsWhereAskedAndIsSaid) {
  Options options;
  options.no_overlap = true;
  std::vector<Point> comb = {{0, 0}, {9, 0}};
  for (int tooth = 4; tooth >= 0; --tooth) {
    if (tooth < 4) comb.emplace_back(2 * tooth + 1, 1);
    comb.emplace_back(2 * tooth + 1, 6);
    comb.emplace_back(2 * tooth, 6);
    if (tooth > 0) comb.emplace_back(2 * tooth, 1);
  }
  for (const Shape& shape :
       {polygon(comb), concentric({1, 0.4}), data("corpus/M_ion_archive_p1.json")}) {
    const Outcome outcome = parametrize(shape, options);
    expect_valid_and_c1(outcome);
    EXPECT_FALSE(outcome.result.metrics.domain_overlaps);
    EXPECT_TRUE(outcome.within_bounds);
    EXPECT_EQ(outcome.result.parameters.back().first, "no_overlap");
  }
}

}  // namespace
}  // namespace c1mesh
