// SPDX-License-Identifier: GPL-3.0-or-later
// What a result must not depend on: place, scale by a power of two, threads, the run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "c1mesh/generate.h"
#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::example;
using testing_pipeline::expect_valid_and_c1;

// p -> 2^exponent (p + offset), exact for coordinates that are small multiples of 2^-6.
struct Motion {
  Point offset = Point::Zero();
  int exponent = 0;

  Point operator()(const Point& p) const {
    const Point moved = p + offset;
    return {std::ldexp(moved.x(), exponent), std::ldexp(moved.y(), exponent)};
  }
};

Drawing moved(Drawing drawing, const Motion& motion) {
  for (InputCurve& curve : drawing.curves)
    for (Point& p : curve.curve.poles) p = motion(p);
  return drawing;
}

Drawing random_drawing() {
  return generate('A', 1, 11).front();
}

const Outcome& outcome_in_place() {
  static const Outcome outcome = parametrize(make_shape(random_drawing()));
  return outcome;
}

// Domain and connectivity bit for bit.
void expect_same_map(const Result& result, const Result& base) {
  EXPECT_EQ(result.domain_vertices, base.domain_vertices);
  EXPECT_EQ(result.triangles, base.triangles);
  EXPECT_EQ(result.triangle_control_points, base.triangle_control_points);
  EXPECT_EQ(result.exceptional_vertices, base.exceptional_vertices);
  EXPECT_EQ(result.relaxed_edges, base.relaxed_edges);
  ASSERT_EQ(result.control_points.size(), base.control_points.size());
}

double largest(const std::vector<Point>& points) {
  double most = 0;
  for (const Point& p : points) most = std::max(most, p.cwiseAbs().maxCoeff());
  return most;
}

class PowersOfTwo : public testing::TestWithParam<int> {};

// Scaling by a power of two changes no mantissa, so nothing may change but exponents.
TEST_P(PowersOfTwo, ScaleTheControlPointsAndNothingElse) {
  const Motion motion{Point::Zero(), GetParam()};
  const Outcome outcome = parametrize(make_shape(moved(random_drawing(), motion)));
  const Result &result = outcome.result, &base = outcome_in_place().result;
  expect_same_map(result, base);
  for (std::size_t i = 0; i < base.control_points.size(); ++i)
    EXPECT_EQ(result.control_points[i], motion(base.control_points[i])) << i;
  expect_valid_and_c1(outcome);
}

INSTANTIATE_TEST_SUITE_P(All, PowersOfTwo, testing::Values(-40, 1, 60));

class Translations : public testing::TestWithParam<std::array<int, 2>> {};

// The shape in its frame is the same bit for bit; only the last rounding, to the place of the
// result, differs: by half a unit in the last place of the larger of the two coordinates, each.
TEST_P(Translations, MoveTheControlPointsAndNothingElse) {
  const Motion motion{Point(GetParam()[0], GetParam()[1]), 0};
  const Outcome outcome = parametrize(make_shape(moved(random_drawing(), motion)));
  const Result &result = outcome.result, &base = outcome_in_place().result;
  expect_same_map(result, base);
  const double unit = std::numeric_limits<double>::epsilon() *
                      std::max(largest(result.control_points), largest(base.control_points));
  for (std::size_t i = 0; i < base.control_points.size(); ++i) {
    const Point back = result.control_points[i] - motion.offset;
    EXPECT_LE((back - base.control_points[i]).cwiseAbs().maxCoeff(), unit) << i;
  }
  EXPECT_TRUE(outcome.report.valid()) << report_text(outcome.report);
}

INSTANTIATE_TEST_SUITE_P(All, Translations,
                         testing::Values(std::array{1, 0}, std::array{-512, 4096},
                                         std::array{1000000, -3000000}));

TEST(Determinism, BytesDependNeitherOnThreadsNorOnTheRun) {
  const Shape shape = example("annulus");
  std::string first;
  for (const int threads : {1, 2, 4, 4}) {
    Options options;
    options.threads = threads;
    const std::string text = format_result(parametrize(shape, options).result);
    if (first.empty()) first = text;
    EXPECT_TRUE(text == first) << threads << " threads";
  }
}

// The order of the curves in the file says nothing about the shape; the result stays as good.
TEST(Determinism, OrderAndDirectionOfTheCurvesDoNotChangeWhatIsAchieved) {
  Drawing drawing = random_drawing();
  std::reverse(drawing.curves.begin(), drawing.curves.end());
  for (InputCurve& curve : drawing.curves)
    std::reverse(curve.curve.poles.begin(), curve.curve.poles.end());
  const Outcome outcome = parametrize(make_shape(drawing));
  expect_valid_and_c1(outcome);
  EXPECT_EQ(outcome.result.metrics.exceptional, outcome_in_place().result.metrics.exceptional);
}

// A written result read again is the same result, down to the last bit of each measure.
TEST(Written, ResultReadAgainPassesTheSameVerification) {
  const std::string path = testing::TempDir() + "/c1mesh_read_again.c1.json";
  const Outcome& outcome = outcome_in_place();
  const std::string text = format_result(outcome.result);
  write_file(path, text);
  const Result again = read_result(path);
  std::remove(path.c_str());
  EXPECT_EQ(again.control_points, outcome.result.control_points);
  EXPECT_EQ(again.domain_vertices, outcome.result.domain_vertices);
  EXPECT_TRUE(format_result(again) == text);
  const VerifyReport report = verify(again, make_shape(random_drawing()));
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_EQ(report_text(report), report_text(outcome.report));
  EXPECT_EQ(report.metrics.d_ei.max, outcome.report.metrics.d_ei.max);
  EXPECT_EQ(report.metrics.mips_bound_max, outcome.report.metrics.mips_bound_max);
  EXPECT_EQ(report.metrics.min_det_coefficient, outcome.report.metrics.min_det_coefficient);
}

}  // namespace
}  // namespace c1mesh
