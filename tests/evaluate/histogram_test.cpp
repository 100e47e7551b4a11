// SPDX-License-Identifier: GPL-3.0-or-later
// Histograms and axes: every value in its bin, none lost.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "evaluate/axes.h"

namespace c1mesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// 10^(-18) to 10^2, dense and irregular.
std::vector<double> spread_sample() {
  std::vector<double> out;
  for (int k = 0; k < 1000; ++k) out.push_back(std::pow(10.0, -18 + 20 * std::fmod(k * 0.618, 1)));
  return out;
}

TEST(LogHistogram, EveryValueLiesBetweenTheEndsOfItsBin) {
  for (const double x : spread_sample()) {
    const LogHistogram h = log_histogram({x});
    ASSERT_EQ(h.counts, std::vector<std::size_t>{1});
    const double quarter = 1.0 / LogHistogram::per_decade;
    EXPECT_LE(std::pow(10, h.first * quarter), x * (1 + 1e-12));
    EXPECT_GT(std::pow(10, (h.first + 1) * quarter), x * (1 - 1e-12));
  }
}

TEST(LogHistogram, PowersOfTenStartABin) {
  for (int power = -20; power <= 5; ++power) {
    const LogHistogram h = log_histogram({std::pow(10.0, power)});
    EXPECT_EQ(h.first, power * LogHistogram::per_decade) << power;
  }
}

TEST(LogHistogram, CountsZerosAndInfinitiesApart) {
  const LogHistogram h = log_histogram({0, 2e-6, kInfinity, 0, 3e-6, 2e-3, 0});
  EXPECT_EQ(h.zeros, 3u);
  EXPECT_EQ(h.infinite, 1u);
  EXPECT_EQ(h.total(), 7u);
  EXPECT_EQ(h.first, -23);  // 10^-5.75 = 1.78e-6
  ASSERT_EQ(h.counts.size(), 13u);
  EXPECT_EQ(h.counts.front(), 2u);
  EXPECT_EQ(h.counts.back(), 1u);
  EXPECT_EQ(log_histogram({}).total(), 0u);
}

TEST(Distribution, OfOneToHundred) {
  std::vector<double> sample;
  for (int k = 100; k >= 1; --k) sample.push_back(k);
  const Distribution d = distribution_of(sample);
  EXPECT_EQ(d.count, 100u);
  EXPECT_EQ(d.min, 1);
  EXPECT_EQ(d.spread.median, 50);
  EXPECT_EQ(d.spread.p99, 99);
  EXPECT_EQ(d.spread.max, 100);
  EXPECT_EQ(d.histogram.total(), 100u);
  EXPECT_EQ(distribution_of({}).count, 0u);
}

class AxisOfWidth : public testing::TestWithParam<double> {};

TEST_P(AxisOfWidth, LogAxisLosesNothing) {
  std::vector<double> mixed = spread_sample();
  mixed.insert(mixed.end(), {0, 0, 0, kInfinity});
  const LogHistogram all = log_histogram(mixed), zeros = log_histogram({0, 0}),
                     few = log_histogram({1e-3, 1e5}), none = log_histogram({});
  const charts::LogAxis axis({&all, &zeros, &few, &none}, GetParam());
  for (const LogHistogram* h : {&all, &zeros, &few, &none}) {
    const std::vector<double> counts = axis.counts(*h);
    EXPECT_EQ(counts.size(), axis.axis().bins.size());
    EXPECT_EQ(sum(counts), static_cast<double>(h->total()));
  }
  EXPECT_EQ(axis.counts(all).front(), 3);  // the bin of 0
  EXPECT_EQ(axis.axis().ticks.front().name, "0");
  EXPECT_EQ(axis.counts(all).back(), 1);  // the bin of infinity
}

TEST_P(AxisOfWidth, BinsFollowOneAnotherWithinTheWidth) {
  const LogHistogram h = log_histogram({0, 1e-17, 3e-4, kInfinity});
  const charts::LogAxis logarithmic({&h}, GetParam());
  const ValueCounts values = {{-1, 3}, {0, 4}, {500, 1}};
  const charts::WholeAxis whole({&values}, GetParam());
  const charts::ShareAxis share(0.57, GetParam());
  for (const charts::Axis* axis : {&logarithmic.axis(), &whole.axis(), &share.axis()}) {
    double reached = 0;
    for (const charts::Bin& bin : axis->bins) {
      EXPECT_GE(bin.left, reached - 1e-9);
      EXPECT_GT(bin.right, bin.left);
      reached = bin.right;
    }
    EXPECT_NEAR(reached, GetParam(), 1e-9);
    for (const charts::Tick& tick : axis->ticks) {
      EXPECT_GE(tick.at, 0);
      EXPECT_LE(tick.at, GetParam() + 1e-9);
    }
  }
  EXPECT_EQ(sum(whole.counts(values)), 8);
}

// 0.57 and its like are no doubles; each belongs to the bin that starts there all the same.
TEST_P(AxisOfWidth, SharesStandInTheBinTheyStart) {
  std::vector<double> sample;
  for (int k = 80; k <= 100; ++k) sample.push_back(k / 100.0);
  const std::vector<double> counts = charts::ShareAxis(0.8, GetParam()).counts(sample);
  ASSERT_EQ(counts.size(), 20u);
  for (std::size_t k = 0; k + 1 < counts.size(); ++k) EXPECT_EQ(counts[k], 1) << k;
  EXPECT_EQ(counts.back(), 2);  // 0.99 and 1
}

INSTANTIATE_TEST_SUITE_P(Widths, AxisOfWidth, testing::Values(150.0, 160.0, 367.0, 520.0));

}  // namespace
}  // namespace c1mesh
