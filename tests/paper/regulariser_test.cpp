// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/regulariser.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "finite_differences.h"
#include "paper/random_nets.h"

namespace c1mesh {
namespace {

using namespace testing_tools;

constexpr double kGuard = Regulariser::kGuard;

TEST(InverseSquare, IsTheInverseSquareAboveTheGuard) {
  for (const double x : {0.1000001, 0.2, 1.0, 7.5}) {
    const InverseSquare h(x);
    EXPECT_NEAR(h.value * x * x, 1, 1e-14);
    EXPECT_NEAR(h.first * x * x * x, -2, 1e-14);
    EXPECT_NEAR(h.second * x * x * x * x, 6, 1e-14);
  }
}

// Its Taylor polynomial 1/g^2 - 2 b/g^3 + 3 b^2/g^4, b = x - g.
TEST(InverseSquare, IsTheTaylorPolynomialBelowTheGuard) {
  for (const double x : {0.0999, 0.05, 0.0, -0.3, -20.0}) {
    const InverseSquare h(x);
    const double b = x - kGuard, g2 = kGuard * kGuard;
    const double value = (1 - 2 * b / kGuard + 3 * b * b / g2) / g2;
    EXPECT_NEAR(h.value, value, 1e-13 * value);
    EXPECT_NEAR(h.first, (-2 / kGuard + 6 * b / g2) / g2, 1e-13 * std::abs(h.first));
    EXPECT_NEAR(h.second, 6 / (g2 * g2), 1e-13 * h.second);
    EXPECT_LT(h.first, 0) << "it must push back";
  }
}

// Value, first and second derivative agree on both sides, the third jumps from -24 / g^5 to 0.
TEST(InverseSquare, IsTwiceContinuouslyDifferentiableAtTheGuard) {
  const double step = 1e-9;
  const InverseSquare below(kGuard - step), above(kGuard + step);
  EXPECT_NEAR(below.value, above.value, 2.1 * step * std::abs(above.first));
  EXPECT_NEAR(below.first, above.first, 2.1 * step * above.second);
  EXPECT_NEAR(below.second, above.second, 24 * step / std::pow(kGuard, 5) * 1.1);
  EXPECT_GT(below.second - above.second, 24 * step / std::pow(kGuard, 5) * 0.5);
}

class RegulariserOf : public testing::TestWithParam<int> {
 protected:
  int n() const { return GetParam(); }
  const JacobianTables& tables() const { return JacobianTables::of(n()); }
  Regulariser over(const Point& d1, const Point& d2) const { return {tables(), d1, d2}; }
  Eigen::MatrixXd hessian_at(const Regulariser& regulariser, const Net& net, bool project,
                             Eigen::VectorXd& gradient, double weight = 1) const {
    gradient = Eigen::VectorXd::Zero(2 * tables().net_size);
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(gradient.size(), gradient.size());
    const double value = regulariser.add(net, weight, project, gradient, hessian);
    EXPECT_NEAR(value, weight * regulariser.value(net), 1e-13 * std::abs(value));
    return hessian;
  }
  // Determinants of J_ij, to know on which side of the guard a net is.
  double least_determinant(const Net& net, const Point& d1, const Point& d2) const {
    double least = 1e300;
    for (int k = 0; k < tables().derivative_size; ++k)
      least = std::min(least, cross(net[tables().along_u[k]] - net[tables().origin[k]],
                                    net[tables().along_v[k]] - net[tables().origin[k]]) *
                                  n() * n() / cross(d1, d2));
    return least;
  }
};

const Point kD1(1.1, 0.2), kD2(-0.3, 0.9);

// The identity has R = 4 at every one of the n (n + 1) / 2 control vectors; a scaling by s
// R = 2 s^2 + 2 / s^2; and stretches by s and 1 / t the sum of both.
TEST_P(RegulariserOf, ClosedForms) {
  const double area = 0.5 * cross(kD1, kD2), count = n() * (n() + 1) / 2.0;
  const Regulariser regulariser = over(kD1, kD2);
  const Net identity = affine_net(n(), {3, 4}, kD1, kD2);
  EXPECT_NEAR(regulariser.value(identity), 4 * area * count, 1e-12);
  for (const double s : {0.6, 1.7, 5.0}) {
    const Net scaled = moved(identity, [&](const Point& p) { return Point(s * p); });
    EXPECT_NEAR(regulariser.value(scaled), (2 * s * s + 2 / (s * s)) * area * count, 1e-10);
    const Net stretched =
        moved(identity, [&](const Point& p) { return Point(s * p.x(), 2 * p.y()); });
    EXPECT_NEAR(regulariser.value(stretched), (s * s + 4 + 1 / (s * s) + 0.25) * area * count,
                1e-10);
  }
}

// The definition, eq. (4.3), with an inverse matrix where every det J_ij is above the guard.
TEST_P(RegulariserOf, IsTheSumOfTheDefinition) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Net net = random_net(n(), seed, 0.1 / n());
    ASSERT_GT(least_determinant(net, kD1, kD2), kGuard);
    Eigen::Matrix2d hat;
    hat << kD1, kD2;
    hat /= n();
    double sum = 0;
    for (int k = 0; k < tables().derivative_size; ++k) {
      Eigen::Matrix2d M;
      M << net[tables().along_u[k]] - net[tables().origin[k]],
          net[tables().along_v[k]] - net[tables().origin[k]];
      const Eigen::Matrix2d J = M * hat.inverse();
      sum += J.squaredNorm() + J.inverse().squaredNorm();
    }
    sum *= 0.5 * cross(kD1, kD2);
    EXPECT_NEAR(over(kD1, kD2).value(net), sum, 1e-12 * sum);
  }
}

// Turning and moving the shape changes nothing; nor does turning the domain with the shape still.
TEST_P(RegulariserOf, IsInvariantUnderRigidMotions) {
  Eigen::Matrix2d turn;
  turn << 0.6, -0.8, 0.8, 0.6;
  const Net net = random_net(n(), 7, 0.3 / n());
  const double value = over(kD1, kD2).value(net);
  const Net turned = moved(net, [&](const Point& p) { return Point(turn * p + Point(5, -2)); });
  EXPECT_NEAR(over(kD1, kD2).value(turned), value, 1e-12 * value);
  EXPECT_NEAR(over(turn * kD1, turn * kD2).value(net), value, 1e-12 * value);
}

// Small shifts stay above the guard everywhere, large ones have control vectors below it.
TEST_P(RegulariserOf, DerivativesMatchDifferencesOnBothSidesOfTheGuard) {
  const Regulariser regulariser = over(kD1, kD2);
  int above = 0, inverted = 0;
  for (const double shift : {0.1, 0.4, 0.8})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Net net = random_net(n(), seed, shift / n());
      above += least_determinant(net, kD1, kD2) > kGuard;
      inverted += least_determinant(net, kD1, kD2) < 0;
      const Eigen::VectorXd x = packed(net, Eigen::Matrix2d::Zero()).head(2 * tables().net_size);
      const auto value = [&](const Eigen::VectorXd& y) {
        return regulariser.value(net_of(y, tables().net_size));
      };
      const auto slope = [&](const Eigen::VectorXd& y) {
        Eigen::VectorXd gradient;
        hessian_at(regulariser, net_of(y, tables().net_size), false, gradient);
        return gradient;
      };
      Eigen::VectorXd gradient;
      const Eigen::MatrixXd H = hessian_at(regulariser, net, false, gradient);
      EXPECT_LT(gradient_error(value, gradient, x, 1e-6), 1e-6);
      EXPECT_LT(hessian_error(slope, H, x, 1e-7), 1e-5);
      EXPECT_LE((H - H.transpose()).norm(), 1e-14 * H.norm());
    }
  EXPECT_GT(above, 0);
  EXPECT_GT(inverted, 0);
}

TEST_P(RegulariserOf, ProjectedHessianIsPositiveSemidefiniteAndWeightsAreFactors) {
  const Regulariser regulariser = over(kD1, kD2);
  bool was_needed = false;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Net net = random_net(n(), seed, 0.6 / n());
    Eigen::VectorXd gradient, same;
    const Eigen::MatrixXd exact = hessian_at(regulariser, net, false, gradient);
    const Eigen::MatrixXd projected = hessian_at(regulariser, net, true, same);
    EXPECT_EQ(gradient, same);
    using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
    EXPECT_GT(Solver(projected).eigenvalues()[0], -1e-12 * projected.norm());
    // Nothing but negative parts is taken away.
    EXPECT_GT(Solver(projected - exact).eigenvalues()[0], -1e-12 * projected.norm());
    was_needed |= Solver(exact).eigenvalues()[0] < -1e-3 * exact.norm();
    const Eigen::MatrixXd weighted = hessian_at(regulariser, net, true, same, 0.25);
    EXPECT_LT((weighted - 0.25 * projected).norm(), 1e-14 * projected.norm());
    EXPECT_LT((same - 0.25 * gradient).norm(), 1e-14 * gradient.norm());
  }
  EXPECT_TRUE(was_needed);
}

INSTANTIATE_TEST_SUITE_P(Degrees, RegulariserOf, testing::Values(3, 4, 5));

}  // namespace
}  // namespace c1mesh
