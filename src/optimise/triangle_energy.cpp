// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/triangle_energy.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "optimise/inverse_metric.h"

namespace c1mesh {

TriangleEnergy::TriangleEnergy(int degree) : tables_(JacobianTables::of(degree)) {
  const int N = tables_.net_size, M = tables_.derivative_size;
  Eigen::MatrixXd U = Eigen::MatrixXd::Zero(M, N), V = U;
  for (int k = 0; k < M; ++k) {
    U(k, tables_.along_u[k]) += 1;
    U(k, tables_.origin[k]) -= 1;
    V(k, tables_.along_v[k]) += 1;
    V(k, tables_.origin[k]) -= 1;
  }
  uu_ = U.transpose() * tables_.mass * U;
  vv_ = V.transpose() * tables_.mass * V;
  uv_ = U.transpose() * tables_.mass * V;
  uv_ += uv_.transpose().eval();
}

double TriangleEnergy::value(const Net& net, const Eigen::Matrix2d& D) const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (!(cross(D.col(0), D.col(1)) > 0)) return kInfinite;
  const Eigen::VectorXd c = det_coefficients(tables_, net);
  if (!(c.minCoeff() > 0)) return kInfinite;
  const Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic>> p(net[0].data(), 2,
                                                                     tables_.net_size);
  const Eigen::Vector3d s = inverse_metric(D).value;
  const double q = (p * (s[0] * uu_ + s[1] * uv_ + s[2] * vv_)).cwiseProduct(p).sum();
  return q * c.cwiseInverse().mean();
}

// h = mean 1/c_k: gradient -mean(c_k^-2 grad c_k), Hessian
// mean(2 c_k^-3 grad c_k grad c_k^T - c_k^-2 hess c_k).
void TriangleEnergy::inverse_mean(const Net& net, const Eigen::VectorXd& c, double& h,
                                  Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) const {
  const int K = tables_.det_size;
  const Eigen::MatrixXd slopes = det_gradients(tables_, net);
  const Eigen::ArrayXd inverse = c.array().inverse();
  h = inverse.mean();
  gradient = -slopes * inverse.square().matrix() / K;
  const Eigen::MatrixXd scaled = slopes * (2 * inverse.cube()).sqrt().matrix().asDiagonal();
  hessian.noalias() = scaled * scaled.transpose() / K;
  add_det_hessian(tables_, -inverse.square().matrix() / K, hessian);
}

bool TriangleEnergy::derivatives(const Net& net, const Eigen::Matrix2d& D, double& value,
                                 Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) const {
  const int N = tables_.net_size, P = 2 * N;
  if (!(cross(D.col(0), D.col(1)) > 0)) return false;
  const Eigen::VectorXd c = det_coefficients(tables_, net);
  if (!(c.minCoeff() > 0)) return false;
  const Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic>> p(net[0].data(), 2, N);

  double h;
  Eigen::VectorXd dh;
  Eigen::MatrixXd ddh(P, P);
  inverse_mean(net, c, h, dh, ddh);

  const InverseMetric S = inverse_metric(D);
  const Eigen::MatrixXd stiffness = S.value[0] * uu_ + S.value[1] * uv_ + S.value[2] * vv_;
  // Q as a vector (Q11, 2 Q12, Q22) and its derivative in p, one column an entry.
  Eigen::Matrix<double, Eigen::Dynamic, 3> dQ(P, 3);
  const Eigen::MatrixXd* forms[3] = {&uu_, &uv_, &vv_};
  Eigen::Vector3d Q;
  for (int k = 0; k < 3; ++k) {
    const Eigen::MatrixXd product = p * *forms[k];
    Q[k] = product.cwiseProduct(p).sum();
    dQ.col(k) = 2 * Eigen::Map<const Eigen::VectorXd>(product.data(), P);
  }
  const double q = S.value.dot(Q);
  const Eigen::VectorXd dq_p = dQ * S.value;
  const Eigen::Vector4d dq_D = S.gradient.transpose() * Q;

  value = q * h;
  gradient.resize(P + 4);
  gradient << h * dq_p + q * dh, h * dq_D;
  hessian.resize(P + 4, P + 4);
  auto pp = hessian.topLeftCorner(P, P);
  pp.noalias() = q * ddh + dq_p * dh.transpose() + dh * dq_p.transpose();
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      pp(2 * i, 2 * j) += 2 * h * stiffness(i, j);
      pp(2 * i + 1, 2 * j + 1) += 2 * h * stiffness(i, j);
    }
  hessian.topRightCorner(P, 4) = h * dQ * S.gradient + dh * dq_D.transpose();
  hessian.bottomLeftCorner(4, P) = hessian.topRightCorner(P, 4).transpose();
  hessian.bottomRightCorner(4, 4) = h * inverse_metric_hessian(Q, D);
  return true;
}

void project_to_semidefinite(Eigen::MatrixXd& hessian) {
  // A Cholesky factorisation of a slightly shifted copy is far cheaper than eigenvalues and settles
  // most elements; what it lets through is negative by less than the shift.
  const Eigen::Index size = hessian.rows();
  Eigen::MatrixXd shifted = hessian;
  shifted.diagonal().array() += 1e-10 * hessian.trace() / static_cast<double>(size);
  if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(shifted).info() == Eigen::Success) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(hessian);
  // Subtracting the negative part touches only the few eigenvectors that have one.
  Eigen::Index negative = 0;
  while (negative < size && eigen.eigenvalues()[negative] < 0) ++negative;
  const auto vectors = eigen.eigenvectors().leftCols(negative);
  hessian.noalias() -=
      vectors * eigen.eigenvalues().head(negative).asDiagonal() * vectors.transpose();
}

}  // namespace c1mesh
