// SPDX-License-Identifier: GPL-3.0-or-later
// The curve of exceptional vertices against g: every point a certified map, the rules of its end.
#include "c1mesh/trade_off.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "c1mesh/error.h"
#include "pipeline/runs.h"

namespace c1mesh {
namespace {

using testing_pipeline::concentric;
using testing_pipeline::example;
using testing_pipeline::kExactlyC1;
using testing_pipeline::polygon;

constexpr int kMost = 12;
constexpr double kFall = 0.95;

void expect_certified(const TradeOff& curve) {
  for (const TradeOffPoint& p : curve.points) {
    EXPECT_TRUE(p.regular) << p.asked;
    EXPECT_TRUE(p.c1) << p.asked;
    EXPECT_LE(p.d_ei_max, kExactlyC1) << p.asked;
    EXPECT_GE(p.g_median, 2 - 1e-12) << p.asked;  // |J|^2 / det J >= 2
    EXPECT_GE(p.g, p.g_median) << p.asked;
    EXPECT_EQ(p.surplus, p.exceptional - curve.minimum) << p.asked;
    EXPECT_LE(p.asked, curve.minimum + kMost);
  }
}

// By the definition, from all pairs; of equal points the first one stands for all.
void expect_dominated_as_defined(const TradeOff& curve) {
  for (const TradeOffPoint& a : curve.points) {
    const bool beaten =
        std::any_of(curve.points.begin(), curve.points.end(), [&](const TradeOffPoint& b) {
          const bool no_worse = b.exceptional <= a.exceptional && b.g <= a.g;
          const bool better = b.exceptional < a.exceptional || b.g < a.g;
          return no_worse && (better || b.asked < a.asked);
        });
    EXPECT_EQ(a.dominated, beaten) << a.asked;
  }
}

TEST(TradeOff, OfTheBlobRisesInVerticesFromTheMinimum) {
  const TradeOff curve = trade_off(example("blob"));
  EXPECT_EQ(curve.minimum, 3);  // a smooth loop's polygon has three corners
  ASSERT_GE(curve.points.size(), 3u);
  EXPECT_EQ(curve.points.front().exceptional, 3);
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    EXPECT_GT(curve.points[i].exceptional, curve.points[i - 1].exceptional);
  // A triangle is a poor domain for a round shape.
  EXPECT_LT(curve.points.back().g, 0.5 * curve.points.front().g);
  expect_certified(curve);
  expect_dominated_as_defined(curve);
}

TEST(TradeOff, PointsAreThoseOfRunsThatAskForAsManyAndDoNotRefine) {
  for (const char* name : {"blob", "letter"}) {
    const TradeOff curve = trade_off(example(name));
    for (const TradeOffPoint& p : curve.points) {
      Options options;
      options.exceptional = p.asked;
      options.refine = 1;
      const Metrics m = parametrize(example(name), options).result.metrics;
      EXPECT_EQ(m.exceptional, p.exceptional) << name;
      EXPECT_EQ(m.mips_bound_max, p.g) << name;
      EXPECT_EQ(m.triangles, p.triangles) << name;
      EXPECT_EQ(m.triangles, curve.points.front().triangles) << name;
    }
  }
}

// The search does not go on where two vertices in a row bought less than 5 %.
TEST(TradeOff, EndsWhereGStopsFalling) {
  for (const char* name : {"blob", "letter"}) {
    const TradeOff curve = trade_off(example(name));
    ASSERT_NE(curve.end, TradeOffEnd::time_limit);
    double lowest = curve.points.front().g;
    int idle = 0;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      EXPECT_LT(idle, 2) << name << " went on at " << curve.points[i].asked;
      idle = curve.points[i].g < kFall * lowest ? 0 : idle + 1;
      lowest = std::min(lowest, curve.points[i].g);
    }
    expect_certified(curve);
    expect_dominated_as_defined(curve);
  }
}

// A square is its own domain: the identity has g = 2, nothing is left to fall.
TEST(TradeOff, OfASquareIsFlat) {
  const TradeOff curve = trade_off(polygon({Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)}));
  EXPECT_EQ(curve.minimum, 0);
  EXPECT_EQ(curve.end, TradeOffEnd::flat);
  ASSERT_FALSE(curve.points.empty());
  EXPECT_NEAR(curve.points.front().g, 2, 1e-9);
  expect_certified(curve);
  expect_dominated_as_defined(curve);
}

// A disc within an annulus: the sum over both regions, each with its own minimum.
TEST(TradeOff, OfSeveralRegionsCountsThemTogether) {
  const TradeOff curve = trade_off(concentric({3, 2, 1}));
  EXPECT_EQ(curve.minimum, 9);
  ASSERT_GE(curve.points.size(), 2u);
  EXPECT_EQ(curve.points.front().exceptional, 9);
  const int counted = curve.points.back().exceptional;
  EXPECT_GT(counted, 9);
  EXPECT_LT(curve.points.back().g, curve.points.front().g);
  expect_certified(curve);
  expect_dominated_as_defined(curve);
}

TEST(TradeOff, BytesDoNotDependOnTheNumberOfThreads) {
  Options one, two;
  one.threads = 1;
  two.threads = 2;
  const TradeOff a = trade_off(example("letter"), one), b = trade_off(example("letter"), two);
  EXPECT_EQ(format_trade_off(a), format_trade_off(b));
  EXPECT_EQ(draw_trade_off(a), draw_trade_off(b));
}

TEST(TradeOff, StopsWhenToldTo) {
  EXPECT_THROW(trade_off(example("blob"), {}, [](const std::string&, double) { return false; }),
               Interrupted);
  Options options;
  options.time_limit = 1e-9;
  const TradeOff curve = trade_off(example("blob"), options);
  EXPECT_EQ(curve.end, TradeOffEnd::time_limit);
  EXPECT_TRUE(curve.points.empty());
  Options wrong;
  wrong.alpha = 0;
  EXPECT_THROW(trade_off(example("blob"), wrong), std::invalid_argument);
}

}  // namespace
}  // namespace c1mesh
