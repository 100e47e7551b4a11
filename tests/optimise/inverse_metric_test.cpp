// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/inverse_metric.h"

#include <Eigen/LU>
#include <random>

#include "finite_differences.h"

namespace c1mesh {
namespace {

Eigen::Matrix2d random_domain(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  Eigen::Matrix2d D;
  D << 1 + unit(random), unit(random), unit(random), 0.8 + unit(random);
  return D;
}

Eigen::Matrix2d matrix_of(const Eigen::VectorXd& x) {
  return Eigen::Map<const Eigen::Matrix2d>(x.data());
}

Eigen::VectorXd vector_of(const Eigen::Matrix2d& D) {
  return Eigen::Map<const Eigen::Vector4d>(D.data());
}

// |M D^-1|^2 det D = S11 |M0|^2 + 2 S12 M0.M1 + S22 |M1|^2 for any M.
TEST(InverseMetric, IsTheQuadraticFormOfDistortion) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Eigen::Matrix2d D = random_domain(seed);
    const Eigen::Vector3d S = inverse_metric(D).value;
    Eigen::Matrix2d M;
    for (double& m : M.reshaped()) m = normal(random);
    const double expected = (M * D.inverse()).squaredNorm() * D.determinant();
    EXPECT_NEAR(S[0] * M.col(0).squaredNorm() + 2 * S[1] * M.col(0).dot(M.col(1)) +
                    S[2] * M.col(1).squaredNorm(),
                expected, 1e-12 * std::abs(expected));
    EXPECT_NEAR(S[0] * S[2] - S[1] * S[1], 1, 1e-12) << "det S = det adj^2 / det^2";
  }
  EXPECT_EQ(inverse_metric(Eigen::Matrix2d::Identity()).value, Eigen::Vector3d(1, 0, 1));
}

TEST(InverseMetric, DerivativesMatchDifferences) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Eigen::Matrix2d D = random_domain(seed);
    ASSERT_GT(D.determinant(), 0.05);
    const Eigen::Vector3d s(normal(random), normal(random), normal(random));
    const auto value = [&](const Eigen::VectorXd& x) {
      return s.dot(inverse_metric(matrix_of(x)).value);
    };
    const auto slope = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      return inverse_metric(matrix_of(x)).gradient.transpose() * s;
    };
    const Eigen::VectorXd x = vector_of(D);
    const Eigen::MatrixXd H = inverse_metric_hessian(s, D);
    EXPECT_LT(testing_tools::gradient_error(value, slope(x), x, 1e-6), 1e-8);
    EXPECT_LT(testing_tools::hessian_error(slope, H, x, 1e-6), 1e-8);
    EXPECT_LE((H - H.transpose()).norm(), 1e-14 * H.norm());
    // S depends on the shape of D only: homogeneous of degree zero, the gradient of degree -1.
    EXPECT_NEAR(slope(x).dot(x), 0, 1e-12 * slope(x).norm());
    EXPECT_LT((H * x + slope(x)).norm(), 1e-11 * (1 + H.norm()));
  }
}

}  // namespace
}  // namespace c1mesh
