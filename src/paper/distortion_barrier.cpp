// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/distortion_barrier.h"

#include <cmath>
#include <limits>

#include "optimise/inverse_metric.h"

namespace c1mesh {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// |max(v, 0)|_p, scaled by the largest entry, which is positive: powers of 12 and more would
// overflow.
double p_norm(const Eigen::VectorXd& v, double p) {
  const double largest = v.maxCoeff();
  return largest * std::pow((v / largest).array().max(0.0).pow(p).sum(), 1 / p);
}

}  // namespace

DistortionBarrier::DistortionBarrier(int degree) : tables_(JacobianTables::of(degree)) {
  const int N = tables_.net_size;
  const double scale = double(degree) * degree;
  for (const auto& products : tables_.products) {
    Forms f{Eigen::MatrixXd::Zero(N, N), Eigen::MatrixXd::Zero(N, N), Eigen::MatrixXd::Zero(N, N)};
    for (const auto& [first, second, weight] : products) {
      const int o[2] = {tables_.origin[first], tables_.origin[second]};
      const int u[2] = {tables_.along_u[first], tables_.along_u[second]};
      const int v[2] = {tables_.along_v[first], tables_.along_v[second]};
      const auto add = [&, w = scale * weight](Eigen::MatrixXd& form, int a, int b) {
        form(a, b) += w;
        form(a, o[1]) -= w;
        form(o[0], b) -= w;
        form(o[0], o[1]) += w;
      };
      add(f.uu, u[0], u[1]);
      add(f.vv, v[0], v[1]);
      add(f.uv, u[0], v[1]);
      add(f.uv, v[0], u[1]);
    }
    // The pairs are ordered both ways, so the sums are symmetric up to rounding; make them so.
    f.uu = 0.5 * (f.uu + f.uu.transpose().eval());
    f.uv = 0.5 * (f.uv + f.uv.transpose().eval());
    f.vv = 0.5 * (f.vv + f.vv.transpose().eval());
    forms_.push_back(std::move(f));
  }
}

// n_i det D: the factor det D cancels against that of the d_i.
Eigen::VectorXd DistortionBarrier::norms(const Net& net, const Eigen::Vector3d& s) const {
  std::vector<Point> a(tables_.derivative_size), b(tables_.derivative_size);
  for (int k = 0; k < tables_.derivative_size; ++k) {
    a[k] = net[tables_.along_u[k]] - net[tables_.origin[k]];
    b[k] = net[tables_.along_v[k]] - net[tables_.origin[k]];
  }
  const double scale = double(tables_.degree) * tables_.degree;
  Eigen::VectorXd q(tables_.det_size);
  for (int i = 0; i < tables_.det_size; ++i) {
    double sum = 0;
    for (const auto& [k, l, weight] : tables_.products[i])
      sum += weight * (s[0] * a[k].dot(a[l]) + s[1] * (a[k].dot(b[l]) + b[k].dot(a[l])) +
                       s[2] * b[k].dot(b[l]));
    q[i] = scale * sum;
  }
  return q;
}

double DistortionBarrier::distortion(const Net& net, const Eigen::Matrix2d& D) const {
  if (!(cross(D.col(0), D.col(1)) > 0)) return kInfinite;
  const Eigen::VectorXd c = det_coefficients(tables_, net);
  if (!(c.minCoeff() > 0)) return kInfinite;
  return p_norm(norms(net, inverse_metric(D).value), exponent) * p_norm(c.cwiseInverse(), exponent);
}

double DistortionBarrier::value(const Net& net, const Eigen::Matrix2d& D, double bound) const {
  const double g = distortion(net, D);
  return g < bound ? -std::log(bound - g) : kInfinite;
}

// A = |max(q, 0)|_p, the sums over the positive q_i: grad A = sum w_i grad q_i, w_i = (q_i /
// A)^(p-1), and hess A = sum w_i hess q_i + (p-1)/A (sum (q_i / A)^(p-2) grad q_i grad q_i^T - grad
// A grad A^T).
DistortionBarrier::Factor DistortionBarrier::norm_factor(const Net& net,
                                                         const Eigen::Matrix2d& D) const {
  const int N = tables_.net_size, P = 2 * N, K = tables_.det_size;
  const InverseMetric S = inverse_metric(D);
  const Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic>> p(net[0].data(), 2, N);
  const Eigen::VectorXd q = norms(net, S.value);
  Factor A;
  A.value = p_norm(q, exponent);
  const Eigen::ArrayXd ratio = (q.array() / A.value).max(0.0);
  const Eigen::ArrayXd w = ratio.pow(exponent - 1);
  Eigen::MatrixXd slopes(P + 4, K), stiffness = Eigen::MatrixXd::Zero(N, N);
  Eigen::Vector3d Q = Eigen::Vector3d::Zero();  // sum w_i (Q11, 2 Q12, Q22)_i
  Eigen::Matrix<double, Eigen::Dynamic, 3> dQ = Eigen::MatrixXd::Zero(P, 3);
  for (int i = 0; i < K; ++i) {
    const Forms& f = forms_[i];
    const Eigen::MatrixXd* parts[3] = {&f.uu, &f.uv, &f.vv};
    Eigen::VectorXd along = Eigen::VectorXd::Zero(P);
    Eigen::Vector3d values;
    for (int k = 0; k < 3; ++k) {
      const Eigen::MatrixXd product = p * *parts[k];
      values[k] = product.cwiseProduct(p).sum();
      const Eigen::Map<const Eigen::VectorXd> flat(product.data(), P);
      along += 2 * S.value[k] * flat;
      dQ.col(k) += 2 * w[i] * flat;
      stiffness += w[i] * S.value[k] * *parts[k];
    }
    slopes.col(i) << along, S.gradient.transpose() * values;
    Q += w[i] * values;
  }
  A.gradient = slopes * w.matrix();
  const Eigen::ArrayXd curvature = (exponent - 1) / A.value * ratio.pow(exponent - 2);
  A.hessian.noalias() = slopes * curvature.matrix().asDiagonal() * slopes.transpose();
  A.hessian -= (exponent - 1) / A.value * A.gradient * A.gradient.transpose();
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < 2; ++k) A.hessian(2 * i + k, 2 * j + k) += 2 * stiffness(i, j);
  const Eigen::MatrixXd mixed = dQ * S.gradient;
  A.hessian.topRightCorner(P, 4) += mixed;
  A.hessian.bottomLeftCorner(4, P) += mixed.transpose();
  A.hessian.bottomRightCorner(4, 4) += inverse_metric_hessian(Q, D);
  return A;
}

// The same for B = |1 / c|_p, with grad(1 / c) = -grad c / c^2 and hess(1 / c) = 2 grad c grad c^T
// / c^3 - hess c / c^2. It depends on the control points only.
DistortionBarrier::Factor DistortionBarrier::inverse_factor(const Net& net,
                                                            const Eigen::VectorXd& c) const {
  const Eigen::ArrayXd r = c.array().inverse();
  Factor B;
  B.value = p_norm(r.matrix(), exponent);
  const Eigen::ArrayXd ratio = r / B.value, w = ratio.pow(exponent - 1);
  const Eigen::MatrixXd slopes = det_gradients(tables_, net);
  B.gradient = -slopes * (w * r.square()).matrix();
  const Eigen::ArrayXd curvature =
      2 * w * r.cube() + (exponent - 1) / B.value * ratio.pow(exponent - 2) * r.square().square();
  B.hessian.noalias() = slopes * curvature.matrix().asDiagonal() * slopes.transpose();
  B.hessian -= (exponent - 1) / B.value * B.gradient * B.gradient.transpose();
  add_det_hessian(tables_, -(w * r.square()).matrix(), B.hessian);
  return B;
}

bool DistortionBarrier::derivatives(const Net& net, const Eigen::Matrix2d& D, double bound,
                                    double& value, Eigen::VectorXd& gradient,
                                    Eigen::MatrixXd& hessian) const {
  const int P = 2 * tables_.net_size;
  if (!(cross(D.col(0), D.col(1)) > 0)) return false;
  const Eigen::VectorXd c = det_coefficients(tables_, net);
  if (!(c.minCoeff() > 0)) return false;
  const Factor A = norm_factor(net, D), B = inverse_factor(net, c);
  const double room = bound - A.value * B.value;
  if (!(room > 0)) return false;
  value = -std::log(room);
  gradient = B.value * A.gradient;
  gradient.head(P) += A.value * B.gradient;
  hessian = B.value * A.hessian;
  hessian.topLeftCorner(P, P) += A.value * B.hessian;
  hessian.leftCols(P) += A.gradient * B.gradient.transpose();
  hessian.topRows(P) += B.gradient * A.gradient.transpose();
  gradient /= room;
  hessian /= room;
  hessian += gradient * gradient.transpose();
  return true;
}

}  // namespace c1mesh
