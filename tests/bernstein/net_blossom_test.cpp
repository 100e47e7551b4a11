// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/net_blossom.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

namespace c1mesh {
namespace {

using Weights = std::array<mpq_class, 3>;

mpq_class power(const mpq_class& base, int exponent) {
  mpq_class out = 1;
  for (; exponent > 0; --exponent) out *= base;
  return out;
}

mpq_class multinomial(int n, int i, int j) {
  mpq_class out = 1;
  for (int k = 1; k <= n; ++k) out *= k;
  for (int part : {i, j, n - i - j})
    for (int k = 1; k <= part; ++k) out /= k;
  return out;
}

// One coordinate of the map from its definition: sum of p_ij B_ij, in rationals.
mpq_class value(const Net& net, int n, const Weights& w, int axis) {
  mpq_class sum = 0;
  std::size_t at = 0;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i, ++at)
      sum += mpq_class(net[at][axis]) * multinomial(n, i, j) * power(w[0], n - i - j) *
             power(w[1], i) * power(w[2], j);
  return sum;
}

class SubNet : public testing::TestWithParam<int> {};

// Integer nets and dyadic corners leave no rounding in doubles, so the sub-net must be the exact
// one: its map equals the whole's at as many points as decide a polynomial of degree n.
TEST_P(SubNet, IsExactInRationals) {
  const int n = GetParam();
  std::mt19937 random(static_cast<unsigned>(n));
  Net net;
  for (int k = 0; k < (n + 1) * (n + 2) / 2; ++k)
    net.emplace_back(int(random() % 64) - 32, int(random() % 64) - 32);
  const Barycentric a(0.5, 0.25, 0.25), b(0, 0.75, 0.25), c(0.125, 0.125, 0.75);
  const Net part = restrict_net(net, n, a, b, c);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) {
      const Weights inside = {mpq_class(n - i - j) / n, mpq_class(i) / n, mpq_class(j) / n};
      Weights outside;
      for (int k = 0; k < 3; ++k)
        outside[k] =
            inside[0] * mpq_class(a[k]) + inside[1] * mpq_class(b[k]) + inside[2] * mpq_class(c[k]);
      for (int axis = 0; axis < 2; ++axis)
        EXPECT_EQ(value(part, n, inside, axis), value(net, n, outside, axis));
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, SubNet, testing::Values(1, 2, 3, 4, 5));

}  // namespace
}  // namespace c1mesh
