// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/jacobian.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace c1mesh {
namespace {

int position(int n, int i, int j) {
  return j * (n + 1) - j * (j - 1) / 2 + i;
}

double bernstein(int n, int i, int j, double u, double v) {
  const double w = 1 - u - v;
  return std::exp(std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(j + 1) -
                  std::lgamma(n - i - j + 1)) *
         std::pow(u, i) * std::pow(v, j) * std::pow(w, n - i - j);
}

double value(int n, const Eigen::VectorXd& c, double u, double v) {
  double sum = 0;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) sum += c[position(n, i, j)] * bernstein(n, i, j, u, v);
  return sum;
}

Net random_net(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  Net net;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i)
      net.emplace_back(double(i) / n + shift(random), double(j) / n + shift(random));
  return net;
}

Eigen::Matrix2d jacobian_at(int n, const Net& net, double u, double v) {
  Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n - j; ++i) {
      const double b = n * bernstein(n - 1, i, j, u, v);
      J.col(0) += b * (net[position(n, i + 1, j)] - net[position(n, i, j)]);
      J.col(1) += b * (net[position(n, i, j + 1)] - net[position(n, i, j)]);
    }
  return J;
}

class Jacobian : public testing::TestWithParam<int> {};

TEST_P(Jacobian, DetAndNormFormsAgreeWithPointwiseValues) {
  const int n = GetParam();
  const auto& tables = JacobianTables::of(n);
  const Net net = random_net(n, 7);
  Eigen::Matrix2d D;
  D << 1.3, 0.2, -0.4, 0.9;
  const Eigen::VectorXd det = det_coefficients(tables, net);
  const Eigen::VectorXd norm = norm_coefficients(tables, net, D.col(0), D.col(1));
  for (const auto& uv : {Point(0.1, 0.2), Point(0.6, 0.3), Point(0.0, 1.0), Point(0.25, 0.5)}) {
    const Eigen::Matrix2d J = jacobian_at(n, net, uv.x(), uv.y());
    EXPECT_NEAR(value(2 * n - 2, det, uv.x(), uv.y()), J.determinant(), 1e-11);
    EXPECT_NEAR(value(2 * n - 2, norm, uv.x(), uv.y()), (J * D.inverse()).squaredNorm(), 1e-11);
  }
}

// The mean of |a|^2 over the triangle from the mass matrix against the Bernstein coefficients'
// mean.
TEST_P(Jacobian, MassMatrixIntegratesTheSquaredNorm) {
  const int n = GetParam();
  const auto& tables = JacobianTables::of(n);
  const Net net = random_net(n, 11);
  double integral = 0;
  for (int a = 0; a < tables.derivative_size; ++a)
    for (int b = 0; b < tables.derivative_size; ++b) {
      const Point ua = net[tables.along_u[a]] - net[tables.origin[a]];
      const Point ub = net[tables.along_u[b]] - net[tables.origin[b]];
      const Point va = net[tables.along_v[a]] - net[tables.origin[a]];
      const Point vb = net[tables.along_v[b]] - net[tables.origin[b]];
      integral += tables.mass(a, b) * (ua.dot(ub) + va.dot(vb));
    }
  const Eigen::VectorXd norm = norm_coefficients(tables, net, Point(1, 0), Point(0, 1));
  EXPECT_NEAR(integral, norm.mean(), 1e-12 * norm.mean());
}

TEST_P(Jacobian, AffineTriangleHasConstantCoefficientsAndItsMipsValue) {
  const int n = GetParam();
  Net net;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) net.emplace_back(2.0 * i / n, 3.0 * j / n);
  const Eigen::VectorXd det = det_coefficients(JacobianTables::of(n), net);
  EXPECT_NEAR(det.minCoeff(), 6, 1e-13);
  EXPECT_NEAR(det.maxCoeff(), 6, 1e-13);
  // MIPS of diag(2, 3): (4 + 9) / 6.
  EXPECT_NEAR(distortion_bound(JacobianTables::of(n), net, Point(1, 0), Point(0, 1)), 13.0 / 6,
              1e-12);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Jacobian, testing::Values(1, 2, 3, 4, 5));

}  // namespace
}  // namespace c1mesh
