// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of the coefficients of det J with respect to the control points.
#include <random>

#include "bernstein/jacobian.h"
#include "finite_differences.h"

namespace c1mesh {
namespace {

Eigen::VectorXd random_variables(int points, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::VectorXd x(2 * points);
  for (double& v : x) v = unit(random);
  return x;
}

Net net_of(const Eigen::VectorXd& x) {
  Net net;
  for (Eigen::Index k = 0; 2 * k < x.size(); ++k) net.push_back(x.segment<2>(2 * k));
  return net;
}

class DetDerivatives : public testing::TestWithParam<int> {
 protected:
  const JacobianTables& tables = JacobianTables::of(GetParam());
  Eigen::VectorXd x = random_variables(tables.net_size, 3);
};

TEST_P(DetDerivatives, GradientsMatchDifferences) {
  const Eigen::MatrixXd slopes = det_gradients(tables, net_of(x));
  ASSERT_EQ(slopes.rows(), x.size());
  ASSERT_EQ(slopes.cols(), tables.det_size);
  for (int k = 0; k < tables.det_size; ++k) {
    const auto value = [&](const Eigen::VectorXd& y) {
      return det_coefficients(tables, net_of(y))[k];
    };
    // Quadratic: central differences are exact but for rounding.
    EXPECT_LT(testing_tools::gradient_error(value, slopes.col(k), x, 1e-2), 1e-11);
  }
}

// Homogeneous of degree two: Euler's rule, gradient . x = 2 c.
TEST_P(DetDerivatives, GradientsSatisfyEulersRule) {
  const Eigen::VectorXd c = det_coefficients(tables, net_of(x));
  const Eigen::VectorXd sum = det_gradients(tables, net_of(x)).transpose() * x;
  EXPECT_LT((sum - 2 * c).norm(), 1e-13 * c.norm());
}

TEST_P(DetDerivatives, HessianMatchesDifferencesAndIsAdded) {
  const Eigen::VectorXd weights = random_variables(tables.det_size, 8).head(tables.det_size);
  const Eigen::Index size = x.size() + 4;  // room behind, as where a domain has variables too
  const Eigen::MatrixXd before = Eigen::MatrixXd::Constant(size, size, 0.5);
  Eigen::MatrixXd H = before;
  add_det_hessian(tables, weights, H);
  H -= before;
  EXPECT_EQ(H.rightCols(4).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(H.bottomRows(4).cwiseAbs().maxCoeff(), 0);
  const Eigen::MatrixXd points = H.topLeftCorner(x.size(), x.size());
  const auto slope = [&](const Eigen::VectorXd& y) -> Eigen::VectorXd {
    return det_gradients(tables, net_of(y)) * weights;
  };
  EXPECT_LT(testing_tools::hessian_error(slope, points, x, 1e-2), 1e-11);
  EXPECT_LE((points - points.transpose()).norm(), 1e-14 * points.norm());
  EXPECT_GT(points.norm(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Degrees, DetDerivatives, testing::Values(1, 2, 3, 4, 5));

}  // namespace
}  // namespace c1mesh
