// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/window_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace c1mesh {
namespace {

TEST(WindowSums, OneWeightIsATentThatGoesAroundTheEnd) {
  for (const std::size_t few : {0, 1000}) {
    const auto sums = window_sums({9.5}, {2}, {0, 0.5, 1.5, 8.5, 9.5}, 2, 10, few);
    const std::vector<double> expected = {1.5, 1, 0, 1, 2};
    ASSERT_EQ(sums.size(), expected.size());
    for (std::size_t k = 0; k < sums.size(); ++k) EXPECT_NEAR(sums[k], expected[k], 1e-14) << k;
  }
}

TEST(WindowSums, RunningSumsAgreeWithTheSumsOfTerms) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 7), size(-1, 1);
  std::vector<double> at(300), weight(300);
  for (double& x : at) x = place(random);
  for (double& w : weight) w = size(random);
  std::sort(at.begin(), at.end());
  for (const double window : {0.05, 0.6, 3.5}) {
    const auto terms = window_sums(at, weight, at, window, 7);
    const auto running = window_sums(at, weight, at, window, 7, 0);
    for (std::size_t k = 0; k < at.size(); ++k) EXPECT_NEAR(terms[k], running[k], 1e-10) << k;
  }
}

}  // namespace
}  // namespace c1mesh
