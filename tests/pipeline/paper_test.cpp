// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's method, from the drawing to the verified result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::components;
using testing_pipeline::example;
using testing_pipeline::kConforming;

Options paper_options() {
  Options options;
  options.method = Method::paper;
  return options;
}

// Boundary vertices at which C1 is kept and the shape is smooth: the domain is straight there.
double largest_bend_of_flat_vertices(const Result& result) {
  const std::set<int> exceptional(result.exceptional_vertices.begin(),
                                  result.exceptional_vertices.end());
  std::map<int, bool> corner;
  for (const BoundaryVertex& v : result.boundary_vertices) corner[v.vertex] = v.corner;
  std::map<int, int> before, after;
  for (const CurveEdge& e : result.boundary_edges) {
    after[e.a] = e.b;
    before[e.b] = e.a;
  }
  double worst = 0;
  int flat = 0;
  for (const auto& [v, next] : after) {
    if (exceptional.contains(v) || corner.at(v)) continue;
    ++flat;
    const auto& p = result.domain_vertices;
    const Point in = p[v] - p[before.at(v)], out = p[next] - p[v];
    worst = std::max(worst, std::abs(std::atan2(cross(in, out), in.dot(out))));
  }
  EXPECT_GT(flat, 0);
  return worst;
}

// Regular and conforming is certified; C1 is what the bound says.
void expect_paper_result(const Outcome& outcome, const Options& options) {
  EXPECT_TRUE(outcome.report.valid()) << report_text(outcome.report);
  EXPECT_TRUE(outcome.report.regular());
  EXPECT_TRUE(outcome.report.conforming());
  const Metrics& m = outcome.report.metrics;
  EXPECT_LE(m.d_ei.max, c1_asked(options));
  EXPECT_GT(m.d_ei.max, 0) << "an optimisation does not end exactly in C1";
  EXPECT_LE(m.conformance_max, kConforming);
  EXPECT_LE(m.mips_bound_max, distortion_asked(options));
  EXPECT_TRUE(outcome.within_bounds);
  EXPECT_FALSE(outcome.time_limit_hit);
}

struct Case {
  const char* name;
  int surplus;  // exceptional vertices beyond the minimum, at most
};

class PaperExample : public testing::TestWithParam<Case> {};

TEST_P(PaperExample, IsNearlyC1ButForFewExceptionalVertices) {
  const Options options = paper_options();
  const Outcome outcome = parametrize(example(GetParam().name), options);
  expect_paper_result(outcome, options);
  EXPECT_LE(outcome.report.metrics.surplus, GetParam().surplus);
  EXPECT_LE(largest_bend_of_flat_vertices(outcome.result), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Small, PaperExample,
                         testing::Values(Case{"blob", 2}, Case{"letter", 2}, Case{"puzzle", 2},
                                         Case{"annulus", 2}),
                         [](const auto& test) { return std::string(test.param.name); });

Shape interfaces() {
  return testing_pipeline::shape_at(C1MESH_EXAMPLES "/interfaces.json");
}

// C1 is not asked across features; at both ends of such an edge the others may ask for it.
TEST(Paper, FeaturesAreKeptAndNotSmoothed) {
  const Options options = paper_options();
  const Outcome outcome = parametrize(interfaces(), options);
  expect_paper_result(outcome, options);
  EXPECT_LE(outcome.report.metrics.surplus, 2);
  ASSERT_FALSE(outcome.result.feature_edges.empty());
  std::set<std::pair<int, int>> relaxed;
  for (const auto& e : outcome.result.relaxed_edges) relaxed.insert(std::minmax(e[0], e[1]));
  for (const CurveEdge& e : outcome.result.feature_edges)
    EXPECT_TRUE(relaxed.contains(std::minmax(e.a, e.b)));
}

// Section 5.5: both phases once more lower the deviation; the bound of the second pass starts at
// what the first has left.
TEST(Paper, RepetitionLowersTheDeviation) {
  Options options = paper_options();
  options.paper.iterations[0] = 100;
  options.paper.iterations[1] = 30;
  const Outcome once = parametrize(example("blob"), options);
  ASSERT_GT(once.report.metrics.d_ei.max, 1e-7);
  options.repeat = 2;
  int passes = 0;
  const Outcome twice = parametrize(example("blob"), options, {}, [&](const TraceRecord& r) {
    passes = std::max(passes, r.pass);
  });
  EXPECT_EQ(passes, 2);
  expect_paper_result(twice, options);
  EXPECT_LE(largest_bend_of_flat_vertices(twice.result), 1e-12);
  EXPECT_LT(twice.report.metrics.d_ei.max, 0.01 * once.report.metrics.d_ei.max);
}

TEST(Paper, ProjectionMakesItExactlyC1AndMovesTheBoundary) {
  Options options = paper_options();
  options.paper.iterations[0] = 150;
  options.paper.iterations[1] = 30;
  const Outcome plain = parametrize(example("blob"), options);
  options.project = true;
  const Outcome outcome = parametrize(example("blob"), options);
  EXPECT_TRUE(outcome.report.valid()) << report_text(outcome.report);
  EXPECT_TRUE(outcome.report.regular());
  const Metrics& m = outcome.report.metrics;
  EXPECT_LE(m.d_ei.max, 1e-11);
  EXPECT_GT(m.conformance_max, 1e-10);
  EXPECT_LE(m.conformance_max, 1e-4);
  EXPECT_EQ(outcome.result.domain_vertices, plain.result.domain_vertices);
  EXPECT_EQ(outcome.result.exceptional_vertices, plain.result.exceptional_vertices);
  EXPECT_NE(outcome.result.control_points, plain.result.control_points);
}

TEST(Paper, NoOverlapIsKept) {
  Options options = paper_options();
  options.no_overlap = true;
  options.paper.iterations[0] = 30;
  options.paper.iterations[1] = 10;
  const Outcome outcome = parametrize(example("letter"), options);
  EXPECT_TRUE(outcome.report.regular());
  EXPECT_TRUE(outcome.report.conforming());
  EXPECT_FALSE(outcome.report.metrics.domain_overlaps);
}

// Whenever it comes, what is there is regular, straight between its corners and conforming.
TEST(Paper, TimeLimitLeavesARegularResult) {
  for (const double seconds : {1e-9, 0.15}) {
    Options options = paper_options();
    options.paper.iterations[0] = options.paper.iterations[1] = 100000;
    options.paper.smoothing[1] = 1e-14;
    options.repeat = 100;
    options.time_limit = seconds;
    const Outcome outcome = parametrize(example("annulus"), options);
    EXPECT_TRUE(outcome.time_limit_hit);
    EXPECT_TRUE(outcome.report.regular()) << report_text(outcome.report);
    EXPECT_TRUE(outcome.report.conforming());
    EXPECT_LE(largest_bend_of_flat_vertices(outcome.result), 1e-12);
  }
}

// Before the last stage nothing is claimed: every vertex of the boundary is exceptional, every
// inner edge relaxed.
TEST(Paper, EarlierStagesClaimNothing) {
  std::vector<Point> domains[2];
  for (const PaperStage stage : {PaperStage::initial, PaperStage::phase_one}) {
    Options options = paper_options();
    options.paper.last_stage = stage;
    options.paper.iterations[0] = 20;
    int told = 0;
    const Outcome outcome = parametrize(example("blob"), options, {}, [&](const TraceRecord& r) {
      ++told;
      EXPECT_EQ(r.stage, "phase one");
      EXPECT_EQ(r.exceptional, -1);
    });
    EXPECT_EQ(told > 0, stage == PaperStage::phase_one);
    EXPECT_TRUE(outcome.report.regular());
    EXPECT_TRUE(outcome.report.conforming());
    EXPECT_TRUE(outcome.report.c1()) << "nothing is asked";
    EXPECT_FALSE(outcome.within_bounds);
    EXPECT_TRUE(outcome.gave_up);
    EXPECT_EQ(outcome.report.samples.d_ei.size(), 0u);
    std::set<std::pair<int, int>> inner;
    for (const auto& t : outcome.result.triangles)
      for (int c = 0; c < 3; ++c) inner.insert(std::minmax({t[c], t[(c + 1) % 3]}));
    for (const CurveEdge& e : outcome.result.boundary_edges) inner.erase(std::minmax({e.a, e.b}));
    EXPECT_EQ(outcome.result.relaxed_edges.size(), inner.size());
    domains[stage == PaperStage::phase_one] = outcome.result.domain_vertices;
  }
  EXPECT_NE(domains[0], domains[1]);
}

TEST(Paper, BytesDoNotDependOnTheNumberOfThreads) {
  std::string text[2];
  for (const int threads : {1, 2}) {
    Options options = paper_options();
    options.threads = threads;
    options.paper.iterations[0] = 25;
    options.paper.iterations[1] = 10;
    Result result = parametrize(example("annulus"), options).result;
    result.metrics.seconds.clear();
    std::erase_if(result.parameters, [](const auto& p) { return p.first == "threads"; });
    text[threads - 1] = format_result(result);
  }
  EXPECT_EQ(text[0], text[1]);
}

// The barrier's smooth bound exceeds g by up to K^(2/p); where alpha leaves no room for that, the
// phases have to make room themselves, in repetitions too.
TEST(Paper, TightBoundsAreNoTrap) {
  Options options = paper_options();
  options.alpha = options.paper.alpha_lift = 1;
  options.mips_bound = 3;
  options.repeat = 2;
  options.paper.iterations[0] = options.paper.iterations[1] = 15;
  for (const char* name : {"blob", "annulus"}) {
    const Outcome outcome = parametrize(example(name), options);
    EXPECT_TRUE(outcome.report.regular()) << name;
    EXPECT_TRUE(outcome.report.conforming()) << name;
    EXPECT_TRUE(std::isfinite(outcome.report.metrics.mips_bound_max)) << name;
  }
}

TEST(Paper, BadOptionsAreRefused) {
  const Shape shape = testing_pipeline::polygon({{0, 0}, {1, 0}, {0, 1}});
  const auto refused = [&](auto change) {
    Options options = paper_options();
    change(options);
    EXPECT_THROW(parametrize(shape, options), std::invalid_argument);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  refused([](Options& o) { o.repeat = 0; });
  refused([](Options& o) { o.c1_bound = -1; });
  refused([](Options& o) { o.c1_bound = kNan; });
  refused([](Options& o) { o.paper.extent = 0; });
  refused([](Options& o) { o.paper.extent = kNan; });
  refused([](Options& o) { o.paper.regularisation[1] = -1; });
  refused([](Options& o) { o.paper.hard_penalty[0] = kNan; });
  refused([](Options& o) { o.paper.barrier = 0; });
  refused([](Options& o) { o.paper.alpha_lift = 0.5; });
  refused([](Options& o) { o.paper.smoothing[1] = 0; });
  refused([](Options& o) { o.paper.iterations[0] = 0; });
}

}  // namespace
}  // namespace c1mesh
