// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/triangle_jet.h"

#include <gtest/gtest.h>

#include <random>

namespace c1mesh {
namespace {

Net random_net(int n, unsigned seed) {
  std::mt19937 chance(seed);
  const auto number = [&] { return static_cast<double>(chance()) / 4294967296.0 - 0.5; };
  Net net;
  for (int k = 0; k < (n + 1) * (n + 2) / 2; ++k) {
    const double x = number();
    net.emplace_back(x, number());
  }
  return net;
}

Barycentric at(double s, double t) {
  return {1 - s - t, s, t};
}

class Jets : public testing::TestWithParam<int> {};

TEST_P(Jets, ValueIsTheBlossomWithEqualArguments) {
  const int n = GetParam();
  const Net net = random_net(n, 1);
  for (const Barycentric& w : {at(0.2, 0.5), at(1, 0), at(-0.3, 0.4)})
    EXPECT_LT((jet_of(net, n, w).value - evaluate(net, n, w)).norm(), 1e-14);
}

// Central differences of value and first derivatives.
TEST_P(Jets, DerivativesMatchDifferences) {
  const int n = GetParam();
  const Net net = random_net(n, 2);
  const double h = 1e-5;
  for (const auto& [s, t] : {std::pair(0.2, 0.5), std::pair(0.0, 0.0), std::pair(0.7, 0.3)}) {
    const TriangleJet jet = jet_of(net, n, at(s, t));
    const TriangleJet right = jet_of(net, n, at(s + h, t)), left = jet_of(net, n, at(s - h, t)),
                      up = jet_of(net, n, at(s, t + h)), down = jet_of(net, n, at(s, t - h));
    const auto difference = [&](const Point& a, const Point& b) -> Point {
      return (a - b) / (2 * h);
    };
    EXPECT_LT((difference(right.value, left.value) - jet.first[0]).norm(), 1e-7);
    EXPECT_LT((difference(up.value, down.value) - jet.first[1]).norm(), 1e-7);
    EXPECT_LT((difference(right.first[0], left.first[0]) - jet.second[0]).norm(), 1e-6);
    EXPECT_LT((difference(right.first[1], left.first[1]) - jet.second[1]).norm(), 1e-6);
    EXPECT_LT((difference(up.first[0], down.first[0]) - jet.second[1]).norm(), 1e-6);
    EXPECT_LT((difference(up.first[1], down.first[1]) - jet.second[2]).norm(), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Jets, testing::Values(1, 2, 3, 4, 5, 6, 9));

}  // namespace
}  // namespace c1mesh
