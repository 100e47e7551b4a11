// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/curve.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

namespace c1mesh {
namespace {

Poles<mpq_class> rational_cubic() {
  return {{mpq_class(0), mpq_class(1, 3)},
          {mpq_class(2, 7), mpq_class(-5)},
          {mpq_class(11, 3), mpq_class(4)},
          {mpq_class(3), mpq_class(1, 2)}};
}

std::array<mpq_class, 2> at(const Poles<mpq_class>& poles, const mpq_class& t) {
  return blossom(poles, std::vector<mpq_class>(poles.size() - 1, t));
}

// c(a + s (b - a)) = restricted(s), an identity of polynomials: degree + 1 points decide it.
TEST(Curve, RestrictionIsExactInRationals) {
  const auto poles = rational_cubic();
  const mpq_class a(3, 16), b(5, 8);
  const auto part = restrict_poles(poles, a, b);
  for (int k = 0; k <= 3; ++k) {
    const mpq_class s = mpq_class(k) / 3;
    EXPECT_EQ(at(part, s), at(poles, a + s * (b - a)));
  }
}

TEST(Curve, RestrictingBackwardsReverses) {
  const auto poles = rational_cubic();
  auto forward = restrict_poles(poles, mpq_class(1, 4), mpq_class(3, 4));
  const auto backward = restrict_poles(poles, mpq_class(3, 4), mpq_class(1, 4));
  std::reverse(forward.begin(), forward.end());
  EXPECT_EQ(forward, backward);
}

TEST(Curve, ElevationKeepsTheCurveInRationals) {
  const auto poles = rational_cubic();
  const auto raised = elevate_poles(elevate_poles(poles));
  ASSERT_EQ(raised.size(), 6u);
  for (int k = 0; k <= 5; ++k)
    EXPECT_EQ(at(raised, mpq_class(mpq_class(k) / 5)), at(poles, mpq_class(mpq_class(k) / 5)));
}

TEST(Curve, DoubleRestrictionAgreesWithTheExactOneToRounding) {
  const BezierCurve curve{{Point(0.1, 0.2), Point(0.7, -0.3), Point(1.1, 0.9), Point(0.4, 1.3)}};
  const BezierCurve fast = elevate(restrict_curve(curve, 0.375, 0.4375), 5);
  const BezierCurve exact = restrict_exactly(curve, 0.375, 0.4375, 5);
  ASSERT_EQ(exact.degree(), 5);
  for (int i = 0; i <= 5; ++i) EXPECT_LT((fast.poles[i] - exact.poles[i]).norm(), 1e-15);
}

TEST(Curve, ExactRestrictionToTheWholeReturnsTheSameBits) {
  const BezierCurve curve{
      {Point(0.1, 0.2), Point(0.7, -0.3), Point(1.1, 0.9), Point(1e9 / 3, 1.3)}};
  EXPECT_EQ(restrict_exactly(curve, 0, 1, 3).poles, curve.poles);
  EXPECT_EQ(restrict_exactly(curve, 1, 0, 3).poles, reversed(curve).poles);
}

// d/dt of t^2 (as a quadratic) and of a line, by hand.
TEST(Curve, DerivativeOfAParabola) {
  const BezierCurve parabola{{Point(0, 0), Point(0.5, 0), Point(1, 1)}};
  EXPECT_EQ(derivative(parabola, 0.25), Point(1, 0.5));
  EXPECT_EQ(evaluate(parabola, 0.25), Point(0.25, 0.0625));
}

}  // namespace
}  // namespace c1mesh
