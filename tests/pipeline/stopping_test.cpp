// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are stopped, and options that make no sense.
#include <gtest/gtest.h>

#include <limits>

#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::example;
using testing_pipeline::kConforming;

// Too little time for anything still gives a certified map, which may give up C1 but says where.
TEST(TimeLimit, LeavesAValidResult) {
  for (const char* name : {"blob", "annulus", "spiral"}) {
    Options options;
    options.time_limit = 1e-9;
    const Outcome outcome = parametrize(example(name), options);
    EXPECT_TRUE(outcome.time_limit_hit) << name;
    EXPECT_TRUE(outcome.report.valid()) << name << "\n" << report_text(outcome.report);
    EXPECT_LE(outcome.report.metrics.conformance_max, kConforming) << name;
    EXPECT_FALSE(outcome.remedies.empty()) << name;
  }
}

TEST(TimeLimit, IsNotHitByAShortRun) {
  Options options;
  options.time_limit = 1e6;
  EXPECT_FALSE(parametrize(example("blob"), options).time_limit_hit);
}

// Wherever it comes, from the first call to one late in the run.
TEST(Cancellation, ThrowsInterrupted) {
  int calls = 0;
  parametrize(example("blob"), {}, [&](const std::string&, double) { return ++calls, true; });
  ASSERT_GT(calls, 4);
  // The last call only tells that all is done.
  for (const int stop : {1, 2, calls / 2, calls - 1}) {
    int call = 0;
    EXPECT_THROW(
        parametrize(example("blob"), {}, [&](const std::string&, double) { return ++call < stop; }),
        Interrupted)
        << stop << " of " << calls;
    EXPECT_EQ(call, stop) << "called again after it said no";
  }
}

TEST(Progress, RunsFromZeroToOneWithoutGoingBack) {
  double last = 0;
  parametrize(example("annulus"), {}, [&](const std::string& stage, double fraction) {
    EXPECT_FALSE(stage.empty());
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1);
}

TEST(BadOptions, AreRefused) {
  const Shape shape = example("blob");
  const auto refused = [&](auto change) {
    Options options;
    change(options);
    EXPECT_THROW(parametrize(shape, options), std::invalid_argument);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  refused([](Options& o) { o.degree = 2; });
  refused([](Options& o) { o.degree = 21; });
  refused([](Options& o) { o.alpha = 0.5; });
  refused([](Options& o) { o.alpha = kNan; });
  refused([](Options& o) { o.mips_bound = 2; });
  refused([](Options& o) { o.mips_bound = kNan; });
  refused([](Options& o) { o.refine = 0.5; });
  refused([](Options& o) { o.refine = -1; });
  refused([](Options& o) { o.refine = kNan; });
  refused([](Options& o) { o.refine = std::numeric_limits<double>::infinity(); });
  refused([](Options& o) { o.corner_angle = -1; });
  refused([](Options& o) { o.corner_angle = 181; });
}

}  // namespace
}  // namespace c1mesh
