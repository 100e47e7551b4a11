// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/distortion_barrier.h"

#include <cmath>

#include "finite_differences.h"
#include "paper/random_nets.h"

namespace c1mesh {
namespace {

using namespace testing_tools;

const Eigen::Matrix2d kD = (Eigen::Matrix2d() << 1.1, -0.3, 0.2, 0.9).finished();

double bound_of(const DistortionBarrier& barrier, const Net& net, const Eigen::Matrix2d& D) {
  return distortion_bound(barrier.tables(), net, D.col(0), D.col(1));
}

// h' with coefficients 1, -1.3, -0.7 and zeros, times `size`: h'^2 has -1.3 among its coefficients
// and none above 1 (times size^2).
Net net_with_large_negative_norm(int n, double size) {
  std::vector<double> slopes(static_cast<std::size_t>(n), 0);
  slopes[0] = size;
  slopes[1] = -1.3 * size;
  slopes[2] = -0.7 * size;
  return sheared_net(n, slopes);
}

class BarrierOf : public testing::TestWithParam<int> {
 protected:
  DistortionBarrier barrier{GetParam()};
  int n() const { return GetParam(); }
  int size() const { return barrier.tables().net_size; }

  void expect_sandwiched(const Net& net, const Eigen::Matrix2d& D) const {
    const double g = bound_of(barrier, net, D), smooth = barrier.distortion(net, D);
    ASSERT_TRUE(std::isfinite(g));
    EXPECT_GE(smooth, g * (1 - 1e-14));
    EXPECT_LE(smooth, std::pow(barrier.tables().det_size, 2 / barrier.exponent) * g * (1 + 1e-14));
  }

  void expect_derivatives_match(const Net& net, const Eigen::Matrix2d& D) const {
    const double bound = 1.5 * barrier.distortion(net, D);
    const Eigen::VectorXd x = packed(net, D);
    const auto value = [&](const Eigen::VectorXd& y) {
      return barrier.value(net_of(y, size()), domain_of(y), bound);
    };
    const auto slope = [&](const Eigen::VectorXd& y) {
      double f;
      Eigen::VectorXd g;
      Eigen::MatrixXd H;
      EXPECT_TRUE(barrier.derivatives(net_of(y, size()), domain_of(y), bound, f, g, H));
      return g;
    };
    double f;
    Eigen::VectorXd g;
    Eigen::MatrixXd H;
    ASSERT_TRUE(barrier.derivatives(net, D, bound, f, g, H));
    ASSERT_EQ(g.size(), x.size());
    EXPECT_NEAR(f, value(x), 1e-12 * (1 + std::abs(f)));
    EXPECT_LT(gradient_error(value, g, x, 1e-7), 1e-6);
    EXPECT_LT(hessian_error(slope, H, x, 1e-7), 1e-6);
    EXPECT_LE((H - H.transpose()).norm(), 1e-13 * H.norm());
  }
};

// K^(2/p) g is reached where all coefficients are equal: at an affine map.
TEST_P(BarrierOf, IsASmoothBoundOfG) {
  for (const double shift : {0.0, 0.05, 0.2})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Net net = random_net(n(), seed, shift / n());
      if (!std::isfinite(bound_of(barrier, net, kD))) continue;
      expect_sandwiched(net, kD);
    }
  const Net affine = affine_net(n(), {1, 2}, {2, 0}, {0, 5});
  const Eigen::Matrix2d D = Eigen::Matrix2d::Identity();
  EXPECT_NEAR(bound_of(barrier, affine, D), 2.9, 1e-12);
  EXPECT_NEAR(barrier.distortion(affine, D),
              2.9 * std::pow(barrier.tables().det_size, 2 / barrier.exponent), 1e-12);
}

TEST_P(BarrierOf, LargerExponentsAreCloser) {
  const Net net = random_net(n(), 3, 0.2 / n());
  double last = 1e300;
  for (const double p : {4.0, 12.0, 40.0, 200.0}) {
    barrier.exponent = p;
    expect_sandwiched(net, kD);
    const double smooth = barrier.distortion(net, kD);
    EXPECT_LT(smooth, last);
    last = smooth;
  }
  EXPECT_LT(last, 1.06 * bound_of(barrier, net, kD));
}

TEST_P(BarrierOf, IsInvariantUnderSimilaritiesOfShapeAndDomain) {
  Eigen::Matrix2d turn;
  turn << 0.6, -0.8, 0.8, 0.6;
  const Net net = random_net(n(), 5, 0.2 / n());
  const double g = barrier.distortion(net, kD);
  ASSERT_TRUE(std::isfinite(g));
  for (const double s : {1e-6, 2.5, 1e6}) {
    const Net other = moved(net, [&](const Point& p) { return Point(s * (turn * p)); });
    EXPECT_NEAR(barrier.distortion(other, kD), g, 1e-12 * g);
    EXPECT_NEAR(barrier.distortion(net, s * turn * kD), g, 1e-12 * g);
  }
  const Net shifted = moved(net, [](const Point& p) { return Point(p + Point(3, -1)); });
  EXPECT_NEAR(barrier.distortion(shifted, kD), g, 1e-12 * g);
}

TEST_P(BarrierOf, IsInfiniteOutside) {
  const Net net = random_net(n(), 4, 0.1 / n());
  const double g = barrier.distortion(net, kD);
  double f;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd H;
  EXPECT_TRUE(std::isfinite(barrier.value(net, kD, 1.001 * g)));
  EXPECT_TRUE(std::isinf(barrier.value(net, kD, 0.999 * g)));
  EXPECT_TRUE(std::isinf(barrier.value(net, kD, g)));
  EXPECT_FALSE(barrier.derivatives(net, kD, g, f, gradient, H));
  Eigen::Matrix2d flipped = kD, flat = kD;
  flipped.col(0).swap(flipped.col(1));
  flat.col(1) = 2 * flat.col(0);
  for (const Eigen::Matrix2d& D : {flipped, flat}) {
    EXPECT_TRUE(std::isinf(barrier.distortion(net, D)));
    EXPECT_TRUE(std::isinf(barrier.value(net, D, 1e9)));
    EXPECT_FALSE(barrier.derivatives(net, D, 1e9, f, gradient, H));
  }
  Net folded = net;
  folded[1] = net[0] - Point(0.5, 0);  // the first control vector points backwards
  EXPECT_TRUE(std::isinf(barrier.value(folded, kD, 1e9)));
  EXPECT_FALSE(barrier.derivatives(folded, kD, 1e9, f, gradient, H));
}

TEST_P(BarrierOf, DerivativesMatchDifferences) {
  int tried = 0;
  for (const double shift : {0.05, 0.2})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Net net = random_net(n(), seed, shift / n());
      if (!std::isfinite(barrier.distortion(net, kD))) continue;
      ++tried;
      expect_derivatives_match(net, kD);
    }
  EXPECT_GE(tried, 4);
}

// |J|^2 is positive, its coefficients need not be. Where one is negative and larger than all others
// in size, the bound is that of the others.
TEST_P(BarrierOf, NegativeCoefficientsOfTheNormDoNotCount) {
  const Eigen::Matrix2d D = Eigen::Matrix2d::Identity();
  for (const double size : {0.5, 2.0, 10.0}) {
    const Net net = net_with_large_negative_norm(n(), size);
    const Eigen::VectorXd norms =
        norm_coefficients(barrier.tables(), net, Point(1, 0), Point(0, 1));
    EXPECT_NEAR(det_coefficients(barrier.tables(), net).minCoeff(), 1, 1e-12);
    EXPECT_NEAR(bound_of(barrier, net, D), norms.maxCoeff(), 1e-12 * norms.maxCoeff());
    EXPECT_NEAR(norms.maxCoeff(), 2 + size * size, 1e-12 * norms.maxCoeff());
    EXPECT_NEAR(norms.minCoeff(), 2 - 1.3 * size * size, 1e-12 * norms.maxCoeff());
    expect_sandwiched(net, D);
    expect_derivatives_match(net, D);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, BarrierOf, testing::Values(3, 4, 5));

}  // namespace
}  // namespace c1mesh
