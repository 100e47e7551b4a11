// SPDX-License-Identifier: GPL-3.0-or-later
// What a run tells who watches it, and that watching changes nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::example;

struct Traced {
  Outcome outcome;
  std::vector<TraceRecord> records;
};

Traced traced(const Shape& shape, const Options& options = {}) {
  Traced out;
  out.outcome = parametrize(shape, options, {},
                            [&](const TraceRecord& record) { out.records.push_back(record); });
  return out;
}

std::set<std::string> stages(const std::vector<TraceRecord>& records) {
  std::set<std::string> out;
  for (const TraceRecord& r : records) out.insert(r.stage);
  return out;
}

TEST(Trace, OfARunChangesNoByteOfItsResult) {
  for (const char* name : {"puzzle", "annulus", "letter"}) {
    const Shape shape = example(name);
    const Traced run = traced(shape);
    EXPECT_FALSE(run.records.empty()) << name;
    EXPECT_EQ(format_result(run.outcome.result), format_result(parametrize(shape).result)) << name;
  }
}

TEST(Trace, IsTheSameWhateverTheThreads) {
  Options one, more;
  one.threads = 1;
  more.threads = 3;
  const Shape shape = example("puzzle");
  const auto text = [&](const Options& options) {
    std::vector<TraceLine> lines;
    for (const TraceRecord& r : traced(shape, options).records) lines.push_back({"puzzle", r});
    return format_trace(lines);
  };
  EXPECT_EQ(text(one), text(more));
}

// 2 <= f(t) <= g(t) of every triangle, so 2 <= mean f <= max g.
TEST(Trace, CountsItsIterationsAndMeasuresWhatIsPossible) {
  for (const char* name : {"annulus", "puzzle", "blob"}) {
    const Traced run = traced(example(name));
    TraceRecord last;
    for (const TraceRecord& r : run.records) {
      const bool same = r.stage == last.stage && r.pass == last.pass;
      EXPECT_EQ(r.iteration, same ? last.iteration + 1 : 1) << name << " " << r.stage;
      EXPECT_GE(r.pass, last.pass) << name;
      EXPECT_LE(r.pass, last.pass + 1) << name;
      EXPECT_EQ(r.region, 0);
      EXPECT_GE(r.e_s, 0);
      EXPECT_GE(r.step, 0);
      EXPECT_LE(r.step, 1);
      EXPECT_GE(r.e_reg, 2 - 1e-12);
      EXPECT_GE(r.g, r.e_reg * (1 - 1e-12));
      last = r;
    }
  }
}

// The stages in which the map is made, in their order, within the first pass.
TEST(Trace, NamesTheStages) {
  const Traced run = traced(example("puzzle"));
  std::vector<std::string> order;
  for (const TraceRecord& r : run.records)
    if (r.pass == 1 && (order.empty() || order.back() != r.stage)) order.push_back(r.stage);
  const std::vector<std::string> expected = {"domain", "joint", "continuation", "exact"};
  ASSERT_GE(order.size(), expected.size());
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), order.begin()));
  // The blob lacks corners: where to put them is tried first.
  EXPECT_EQ(traced(example("blob")).records.front().stage, "placement");
}

// g is the same in every frame. The result's map is one of those recorded, and its E_s is rounding.
TEST(Trace, PassesThroughTheResult) {
  for (const char* name : {"annulus", "puzzle", "letter"}) {
    const Traced run = traced(example(name));
    const double g = run.outcome.result.metrics.mips_bound_max;
    const bool found =
        std::any_of(run.records.begin(), run.records.end(), [&](const TraceRecord& r) {
          return std::abs(r.g - g) < 1e-9 * g && r.e_s < 1e-9 &&
                 r.exceptional == run.outcome.result.metrics.exceptional;
        });
    EXPECT_TRUE(found) << name;
  }
}

// Over one continuation the penalty grows 1e5 times and E_s all but vanishes.
TEST(Trace, DeviationVanishesInTheExactStage) {
  const Traced run = traced(example("puzzle"));
  double joint = 0, exact = 1;
  for (const TraceRecord& r : run.records) {
    if (r.stage == "joint") joint = r.e_s;
    if (r.stage == "exact") exact = r.e_s;
  }
  EXPECT_GT(joint, 1e-6);
  EXPECT_LT(exact, 1e-10);
}

TEST(Trace, HasTheRegionsInTheirOrder) {
  Drawing drawing;
  for (const double x : {0.0, 3.0})
    for (int k = 0; k < 4; ++k) {
      const Point corner[4] = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1.5}};
      drawing.curves.push_back(
          {std::to_string(drawing.curves.size()), BezierCurve{{corner[k], corner[(k + 1) % 4]}}});
    }
  const Traced run = traced(make_shape(drawing));
  std::vector<int> regions;
  for (const TraceRecord& r : run.records)
    if (regions.empty() || regions.back() != r.region) regions.push_back(r.region);
  EXPECT_EQ(regions, (std::vector<int>{0, 1}));
}

// More effort is more iterations: p-norms and refinement come on top of what was before.
TEST(Trace, GrowsWithTheWork) {
  Options none;
  none.refine = 1;
  const Shape shape = example("puzzle");
  const Traced less = traced(shape, none), more = traced(shape);
  ASSERT_LT(less.records.size(), more.records.size());
  EXPECT_EQ(stages(less.records).count("refinement"), 0u);
  EXPECT_EQ(stages(more.records).count("refinement"), 1u);
  for (std::size_t i = 0; i < less.records.size(); ++i) {
    EXPECT_EQ(less.records[i].e_s, more.records[i].e_s);
    EXPECT_EQ(less.records[i].g, more.records[i].g);
  }
}

}  // namespace
}  // namespace c1mesh
