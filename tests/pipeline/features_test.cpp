// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes with feature curves and interfaces, from the drawing to the verified result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::euler_characteristic;
using testing_pipeline::expect_valid_and_c1;

using Poles = std::vector<Point>;

struct Input {
  const char* name;
  std::vector<Poles> boundary, features;  // features marked only if `mark`
  int exceptional;                        // as few as possible, counted by hand
  int faces;                              // into which the features divide the shape
  int holes = 0;
  bool mark = false;
};

void PrintTo(const Input& input, std::ostream* out) {
  *out << input.name;
}

std::vector<Poles> lines(const std::vector<Point>& corners) {
  std::vector<Poles> out;
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return out;
}

// Four cubics near a circle; every joint smooth in exact arithmetic.
std::vector<Poles> circle(double r, const Point& centre = Point(0, 0)) {
  std::vector<Poles> out;
  Point from(r, 0);
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Point to(-from.y(), from.x());
    out.push_back(
        {centre + from, centre + from + 0.5625 * to, centre + to + 0.5625 * from, centre + to});
    from = to;
  }
  return out;
}

std::vector<Poles> operator+(std::vector<Poles> a, const std::vector<Poles>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Input> inputs() {
  const auto square = lines({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const Poles shared = {{5, 0}, {7, 3}, {3, 7}, {5, 10}};
  const Poles back(shared.rbegin(), shared.rend());
  const Poles bridge = {{2, 0}, {3, 0.5}, {4, -0.5}, {5, 0}};
  return {
      {"SquareWithDiagonal", square, {{{0, 0}, {10, 10}}}, 2, 2},
      // Beside the two branch points each half of the disc needs a third corner.
      {"DiscWithChord", circle(5), {{{5, 0}, {-5, 0}}}, 2 + 2, 2},
      // Its ends are a little beside the circle, away from its joints.
      {"DiscWithChordBetweenJoints", circle(5), {{{-3.01, -4.02}, {4.02, 3.01}}}, 2 + 2, 2},
      {"DiscWithDanglingCurve", circle(5), {{{5, 0}, {3, 1}, {1, -2}, {-1, 0}}}, 3, 1},
      {"DiscWithFreeCurve", circle(5), {{{2, 0}, {1, 1.5}, {-1, -1.5}, {-2, 0}}}, 3, 1},
      {"DiscWithClosedFeature", circle(5), circle(2, {0.25, 0.125}), 3 + 3, 2, 0, true},
      {"TwoPartsWithAnInterface",
       std::vector<Poles>{{{5, 10}, {0, 10}}, {{0, 10}, {0, 0}}, {{0, 0}, {5, 0}}, shared} +
           std::vector<Poles>{{{5, 0}, {10, 0}}, {{10, 0}, {10, 10}}, {{10, 10}, {5, 10}}, back},
       {},
       2,
       2},
      {"BranchInADisc",
       circle(5),
       {{{0, 0}, {1, 0.5}, {2, -0.5}, {3, 0.25}},
        {{0, 0}, {-0.75, 0.75}, {-1, 1}, {-1.5, 2.5}},
        {{0, 0}, {-0.5, -1}, {-1.5, -1}, {-1.5, -2.5}}},
       3 + 1,
       1},
      {"FromHoleToRim", circle(5) + circle(2), {bridge}, 3 + 3, 1, 1},
      {"TwoFromHoleToRim",
       circle(5) + circle(2),
       {bridge, {{-2, 0}, {-3, 0.5}, {-4, -0.5}, {-5, 0}}},
       3 + 3,
       2,
       1,
       true},
      {"CrossInASquare", square, {{{2, 2}, {8, 8}}, {{2, 8}, {4, 8}, {6, 1}, {8, 2}}}, 1, 1},
      {"CornersOfFeatures", square, lines({{3, 3}, {7, 3}, {5, 7}}), 0, 2, 0, true},
      // Joints that turn by less than the corner angle: mild ones.
      {"MildJoint",
       circle(5),
       {{{3, 0}, {2, 1}, {1, 1.2}, {0, 1}}, {{0, 1}, {-1, 0.78}, {-2, 0}, {-3, 0.5}}},
       3,
       1},
  };
}

Shape shape_of(const Input& input) {
  Drawing drawing;
  drawing.name = input.name;
  for (const Poles& poles : input.boundary)
    drawing.curves.push_back({std::to_string(drawing.curves.size()), {poles}});
  for (const Poles& poles : input.features)
    drawing.curves.push_back({std::to_string(drawing.curves.size()), {poles}, input.mark});
  return make_shape(drawing);
}

// Pieces of the mesh that no feature edge separates.
int faces(const Result& result) {
  std::set<std::pair<int, int>> features;
  for (const CurveEdge& e : result.feature_edges) features.insert(std::minmax({e.a, e.b}));
  std::map<std::pair<int, int>, std::vector<int>> beside;
  std::vector<int> root(result.triangles.size());
  for (int t = 0; t < static_cast<int>(root.size()); ++t) {
    root[t] = t;
    for (int k = 0; k < 3; ++k)
      beside[std::minmax({result.triangles[t][k], result.triangles[t][(k + 1) % 3]})].push_back(t);
  }
  const auto find = [&](int t) {
    while (root[t] != t) t = root[t] = root[root[t]];
    return t;
  };
  for (const auto& [edge, triangles] : beside)
    if (triangles.size() == 2 && !features.count(edge))
      root[find(triangles[0])] = find(triangles[1]);
  int count = 0;
  for (int t = 0; t < static_cast<int>(root.size()); ++t) count += find(t) == t;
  return count;
}

class FeatureRuns : public testing::TestWithParam<Input> {};

TEST_P(FeatureRuns, AreC1ButAcrossFeatures) {
  const Input& input = GetParam();
  const Shape shape = shape_of(input);
  ASSERT_EQ(shape.regions.size(), 1u);
  EXPECT_EQ(static_cast<int>(shape.regions[0].holes.size()), input.holes);
  const Outcome outcome = parametrize(shape);
  expect_valid_and_c1(outcome);
  EXPECT_TRUE(outcome.within_bounds);
  const Result& result = outcome.result;
  EXPECT_EQ(result.metrics.exceptional, input.exceptional);
  EXPECT_EQ(result.metrics.exceptional_minimum, input.exceptional);
  EXPECT_EQ(faces(result), input.faces);
  EXPECT_EQ(euler_characteristic(result), 1 - input.holes);
  // No edge is relaxed but features and what ends in an exceptional vertex.
  std::set<int> exceptional(result.exceptional_vertices.begin(), result.exceptional_vertices.end());
  std::set<std::pair<int, int>> features;
  for (const CurveEdge& e : result.feature_edges) features.insert(std::minmax({e.a, e.b}));
  EXPECT_FALSE(features.empty());
  std::size_t relaxed_features = 0;
  for (const auto& e : result.relaxed_edges) {
    const bool feature = features.count(std::minmax({e[0], e[1]})) > 0;
    relaxed_features += feature;
    EXPECT_TRUE(feature || exceptional.count(e[0]) || exceptional.count(e[1]));
  }
  EXPECT_EQ(relaxed_features, features.size());
}

TEST_P(FeatureRuns, AreCertifiedFromTheirFile) {
  const Input& input = GetParam();
  const Shape shape = shape_of(input);
  const std::string text = format_result(parametrize(shape).result);
  const VerifyReport report = verify(parse_result(text, input.name), shape);
  EXPECT_TRUE(report.valid()) << report_text(report);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FeatureRuns, testing::ValuesIn(inputs()),
                         [](const auto& test) { return std::string(test.param.name); });

// Two parts, a hole tied to their interface, a ring, a branching line.
TEST(FeatureRuns, TheExampleNeedsNoMoreThanTheMinimum) {
  const Shape shape = testing_pipeline::shape_at(C1MESH_EXAMPLES "/interfaces.json");
  ASSERT_EQ(shape.regions.size(), 1u);
  EXPECT_EQ(shape.regions[0].holes.size(), 1u);
  const Outcome outcome = parametrize(shape);
  expect_valid_and_c1(outcome);
  EXPECT_TRUE(outcome.within_bounds);
  // Six branch points, three corners of the ring, two more of the hole; the outer loop's corners
  // and branch points suffice.
  EXPECT_EQ(outcome.result.metrics.exceptional_minimum, 6 + 3 + 2);
  EXPECT_EQ(outcome.result.metrics.surplus, 0);
  EXPECT_EQ(faces(outcome.result), 3);
}

// C1 is asked along a feature's sides, not across: the gradient jumps somewhere.
TEST(FeatureRuns, TheGradientMayJumpAcrossAnInterface) {
  Outcome outcome = parametrize(shape_of(inputs()[6]));
  ASSERT_TRUE(outcome.report.valid());
  Result all = outcome.result;
  std::set<std::pair<int, int>> features;
  for (const CurveEdge& e : all.feature_edges) features.insert(std::minmax({e.a, e.b}));
  std::erase_if(all.relaxed_edges, [&](const auto& e) {
    return features.count(std::minmax({e[0], e[1]})) > 0;
  });
  all.feature_edges.clear();
  const VerifyReport report = verify(all);
  EXPECT_FALSE(report.valid());
  EXPECT_GT(report.metrics.d_ei.max, 1e-6);
}

}  // namespace
}  // namespace c1mesh
