// SPDX-License-Identifier: GPL-3.0-or-later
// Bezier to Lagrange: monomials, whose control points and values are both known.
#include "bernstein/interpolation.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

namespace c1mesh {
namespace {

mpq_class falling(int x, int count) {
  mpq_class out = 1;
  for (int k = 0; k < count; ++k) out *= x - k;
  return out;
}

mpq_class power(const mpq_class& x, int exponent) {
  mpq_class out = 1;
  for (int k = 0; k < exponent; ++k) out *= x;
  return out;
}

// x^a y^b over the unit triangle, degree n: p_ij = (i)_a (j)_b / (n)_(a+b) in falling factorials.
Poles<mpq_class> monomial(int n, int a, int b) {
  Poles<mpq_class> net;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) {
      const mpq_class value = falling(i, a) * falling(j, b) / falling(n, a + b);
      net.push_back({value, value * 3 - 1});
    }
  return net;
}

class Lattice : public testing::TestWithParam<int> {};

TEST_P(Lattice, ReproducesEveryMonomialInRationals) {
  const int n = GetParam();
  const mpq_class scale = power(n, n);
  for (int a = 0; a <= n; a += 1 + n / 8)  // all of low degree, some of high
    for (int b = 0; a + b <= n; b += 1 + n / 6) {
      const Poles<mpq_class> net = monomial(n, a, b);
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n - j; ++i) {
          const auto value = scaled_lattice_value(net, n, i, j);
          const mpq_class x = mpq_class(i) / n, y = mpq_class(j) / n;
          const mpq_class expected = power(x, a) * power(y, b);
          ASSERT_EQ(value[0], scale * expected) << a << " " << b << " at " << i << " " << j;
          ASSERT_EQ(value[1], scale * (expected * 3 - 1));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Lattice, testing::Values(1, 2, 3, 4, 5, 7, 10, 15));

// p = (x, y) of a quadratic, by hand: the middle of an edge is (p0 + 2 p1 + p2) / 4.
TEST(Interpolation, OfAQuadraticByHand) {
  const Net net = {{0, 0}, {1, 4}, {8, 0}, {2, 1}, {5, 5}, {0, 8}};
  EXPECT_EQ(lattice_value_exactly(net, 2, 0, 0), Point(0, 0));
  EXPECT_EQ(lattice_value_exactly(net, 2, 2, 0), Point(8, 0));
  EXPECT_EQ(lattice_value_exactly(net, 2, 0, 2), Point(0, 8));
  EXPECT_EQ(lattice_value_exactly(net, 2, 1, 0), Point(2.5, 2));
  EXPECT_EQ(lattice_value_exactly(net, 2, 0, 1), Point(1, 2.5));
  EXPECT_EQ(lattice_value_exactly(net, 2, 1, 1), Point(4.5, 4.5));
}

// Rounded once, to nearest: no double is nearer to the exact value.
TEST(Interpolation, RoundsToTheNearestDouble) {
  const int n = 4;
  Net net;
  Poles<mpq_class> exact;
  for (int k = 0; k < 15; ++k) {
    net.emplace_back(std::sin(1 + 7.0 * k) * 1e3, std::cos(2 + 5.0 * k) / 3);
    exact.push_back({mpq_class(net.back().x()), mpq_class(net.back().y())});
  }
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) {
      const Point found = lattice_value_exactly(net, n, i, j);
      const auto value = scaled_lattice_value(exact, n, i, j);
      for (int axis = 0; axis < 2; ++axis) {
        const mpq_class true_value = value[axis] / 256;  // 4^4
        const mpq_class error = abs(mpq_class(found[axis]) - true_value);
        for (const double to : {-HUGE_VAL, HUGE_VAL})
          EXPECT_LE(error, abs(mpq_class(std::nextafter(found[axis], to)) - true_value));
      }
    }
}

// Two triangles that share an edge give its nodes the same bits: they depend on the edge alone.
TEST(Interpolation, OfAnEdgeDependsOnTheEdgeAlone) {
  const int n = 3;
  Net left, right;
  for (int k = 0; k < 10; ++k) {
    left.emplace_back(std::sin(k) / 3, std::cos(3 * k) * 1e5);
    right.emplace_back(std::sin(20 + k), std::cos(k));
  }
  // The edge from (0, 0) to (n, 0) of one is that from (0, 0) to (0, n) of the other, then against
  // it.
  const int row[] = {0, 1, 2, 3}, column[] = {0, 4, 7, 9};
  for (int k = 0; k <= n; ++k) right[column[k]] = left[row[k]];
  for (int k = 0; k <= n; ++k)
    EXPECT_EQ(lattice_value_exactly(left, n, k, 0), lattice_value_exactly(right, n, 0, k));
  for (int k = 0; k <= n; ++k) right[column[n - k]] = left[row[k]];
  for (int k = 0; k <= n; ++k)
    EXPECT_EQ(lattice_value_exactly(left, n, k, 0), lattice_value_exactly(right, n, 0, n - k));
}

TEST(Interpolation, KeepsCornersBitForBit) {
  const Net net = {{0.1, -0.0}, {7, 7}, {1e300, 1e-300}, {5, 5}, {3, 3}, {-0.3, 1.0 / 3}};
  EXPECT_TRUE(std::signbit(lattice_value_exactly(net, 2, 0, 0).y()));
  EXPECT_EQ(lattice_value_exactly(net, 2, 2, 0), net[2]);
  EXPECT_EQ(lattice_value_exactly(net, 2, 0, 2), net[5]);
}

}  // namespace
}  // namespace c1mesh
