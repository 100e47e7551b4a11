// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/triangle_energy.h"

#include <Eigen/LU>
#include <random>

#include "finite_differences.h"

namespace c1mesh {
namespace {

using testing_tools::gradient_error;
using testing_tools::hessian_error;

Eigen::VectorXd random_state(const TriangleEnergy& energy, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.05, 0.05);
  const int n = energy.tables().degree;
  Eigen::VectorXd x(energy.size());
  int k = 0;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i, ++k)
      x.segment<2>(2 * k) = Point(double(i) / n + shift(random), double(j) / n + shift(random));
  x.tail<4>() << 1.2, 0.1, -0.2, 0.8;
  return x;
}

Net net_of(const Eigen::VectorXd& x) {
  Net net;
  for (Eigen::Index k = 0; 2 * k + 4 < x.size(); ++k) net.push_back(x.segment<2>(2 * k));
  return net;
}

Eigen::Matrix2d domain_of(const Eigen::VectorXd& x) {
  Eigen::Matrix2d D;
  D.col(0) = x.segment<2>(x.size() - 4);
  D.col(1) = x.tail<2>();
  return D;
}

class Energy : public testing::TestWithParam<int> {};

TEST_P(Energy, DerivativesMatchDifferencesAndHessianIsSymmetric) {
  const TriangleEnergy energy(GetParam());
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Eigen::VectorXd x = random_state(energy, seed);
    const auto value = [&](const Eigen::VectorXd& y) {
      return energy.value(net_of(y), domain_of(y));
    };
    const auto slope = [&](const Eigen::VectorXd& y) {
      double f;
      Eigen::VectorXd g;
      Eigen::MatrixXd H;
      EXPECT_TRUE(energy.derivatives(net_of(y), domain_of(y), f, g, H));
      return g;
    };
    double f;
    Eigen::VectorXd g;
    Eigen::MatrixXd H;
    ASSERT_TRUE(energy.derivatives(net_of(x), domain_of(x), f, g, H));
    EXPECT_NEAR(f, value(x), 1e-12 * f);
    EXPECT_LT(gradient_error(value, g, x, 1e-6), 1e-7);
    EXPECT_LT(hessian_error(slope, H, x, 1e-6), 1e-7);
    EXPECT_LE((H - H.transpose()).norm(), 1e-14 * H.norm());
  }
}

// Scaling, turning and moving shape or domain changes nothing; affine maps have their MIPS value.
TEST_P(Energy, InvariancesAndClosedForm) {
  const TriangleEnergy energy(GetParam());
  const Eigen::VectorXd x = random_state(energy, 3);
  Net net = net_of(x);
  const Eigen::Matrix2d D = domain_of(x);
  const double f = energy.value(net, D);
  Eigen::Matrix2d turn;
  turn << 0.6, -0.8, 0.8, 0.6;
  for (Point& p : net) p = 2.5 * turn * p + Point(3, -1);
  EXPECT_NEAR(energy.value(net, D), f, 1e-12 * f);
  EXPECT_NEAR(energy.value(net, 0.3 * turn * D), f, 1e-12 * f);

  const int n = GetParam();
  Net affine;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) affine.emplace_back(2.0 * i / n, 5.0 * j / n);
  EXPECT_NEAR(energy.value(affine, Eigen::Matrix2d::Identity()), 0.4 + 2.5, 1e-12);
}

TEST_P(Energy, InfiniteOutsideTheValidRegion) {
  const TriangleEnergy energy(GetParam());
  const Eigen::VectorXd x = random_state(energy, 4);
  Eigen::Matrix2d flipped = domain_of(x);
  flipped.col(0).swap(flipped.col(1));
  EXPECT_TRUE(std::isinf(energy.value(net_of(x), flipped)));
  Net folded = net_of(x);
  folded[1] = Point(-0.5, 0);  // the first control vector along the edge points backwards
  EXPECT_TRUE(std::isinf(energy.value(folded, domain_of(x))));
}

INSTANTIATE_TEST_SUITE_P(Degrees, Energy, testing::Values(3, 4, 5));

}  // namespace
}  // namespace c1mesh
