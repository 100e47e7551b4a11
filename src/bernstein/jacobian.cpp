// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/jacobian.h"

#include <limits>
#include <map>
#include <memory>
#include <mutex>

namespace c1mesh {
namespace {

double factorial(int k) {
  double f = 1;
  for (int i = 2; i <= k; ++i) f *= i;
  return f;
}

double multinomial(int n, int i, int j) {
  return factorial(n) / (factorial(i) * factorial(j) * factorial(n - i - j));
}

int net_position(int n, int i, int j) {
  return j * (n + 1) - j * (j - 1) / 2 + i;
}

}  // namespace

JacobianTables::JacobianTables(int n)
    : degree(n),
      net_size((n + 1) * (n + 2) / 2),
      derivative_size(n * (n + 1) / 2),
      det_size((2 * n - 1) * n) {
  const int m = n - 1, d = 2 * n - 2;
  std::vector<std::array<int, 2>> index;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= m - j; ++i) {
      index.push_back({i, j});
      origin.push_back(net_position(n, i, j));
      along_u.push_back(net_position(n, i + 1, j));
      along_v.push_back(net_position(n, i, j + 1));
    }
  products.resize(det_size);
  mass.resize(derivative_size, derivative_size);
  for (int a = 0; a < derivative_size; ++a)
    for (int b = 0; b < derivative_size; ++b) {
      const int i = index[a][0] + index[b][0], j = index[a][1] + index[b][1];
      const double weight = multinomial(m, index[a][0], index[a][1]) *
                            multinomial(m, index[b][0], index[b][1]) / multinomial(d, i, j);
      products[net_position(d, i, j)].push_back({a, b, weight});
      // A Bernstein polynomial of degree d integrates to 1/((d+1)(d+2)); the mean is twice that.
      mass(a, b) = n * n * weight * 2.0 / ((d + 1.0) * (d + 2.0));
    }
}

const JacobianTables& JacobianTables::of(int n) {
  static std::mutex mutex;
  static std::map<int, std::unique_ptr<JacobianTables>> cache;
  const std::lock_guard<std::mutex> lock(mutex);
  auto& entry = cache[n];
  if (!entry) entry.reset(new JacobianTables(n));
  return *entry;
}

Eigen::VectorXd det_coefficients(const JacobianTables& tables, const Net& net) {
  const double scale = double(tables.degree) * tables.degree;
  std::vector<Point> a(tables.derivative_size), b(tables.derivative_size);
  for (int k = 0; k < tables.derivative_size; ++k) {
    a[k] = net[tables.along_u[k]] - net[tables.origin[k]];
    b[k] = net[tables.along_v[k]] - net[tables.origin[k]];
  }
  Eigen::VectorXd out(tables.det_size);
  for (int c = 0; c < tables.det_size; ++c) {
    double sum = 0;
    for (const auto& p : tables.products[c]) sum += p.weight * cross(a[p.first], b[p.second]);
    out[c] = scale * sum;
  }
  return out;
}

Eigen::MatrixXd det_gradients(const JacobianTables& tables, const Net& net) {
  const double scale = double(tables.degree) * tables.degree;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(2 * tables.net_size, tables.det_size);
  for (int k = 0; k < tables.det_size; ++k)
    for (const auto& pair : tables.products[k]) {
      const int ao = tables.origin[pair.first], au = tables.along_u[pair.first];
      const int bo = tables.origin[pair.second], bv = tables.along_v[pair.second];
      const Point u = scale * pair.weight * (net[au] - net[ao]);
      const Point v = scale * pair.weight * (net[bv] - net[bo]);
      const Point along_u(v.y(), -v.x()), along_v(-u.y(), u.x());
      out.block<2, 1>(2 * au, k) += along_u;
      out.block<2, 1>(2 * ao, k) -= along_u;
      out.block<2, 1>(2 * bv, k) += along_v;
      out.block<2, 1>(2 * bo, k) -= along_v;
    }
  return out;
}

void add_det_hessian(const JacobianTables& tables, const Eigen::VectorXd& weights,
                     Eigen::MatrixXd& hessian) {
  const int N = tables.net_size;
  // curl_ij: weight of cross(p_i, p_j) in sum_k weights_k c_k.
  Eigen::MatrixXd curl = Eigen::MatrixXd::Zero(N, N);
  const double scale = double(tables.degree) * tables.degree;
  for (int k = 0; k < tables.det_size; ++k)
    for (const auto& pair : tables.products[k]) {
      const int ao = tables.origin[pair.first], au = tables.along_u[pair.first];
      const int bo = tables.origin[pair.second], bv = tables.along_v[pair.second];
      const double weight = scale * weights[k] * pair.weight;
      curl(au, bv) += weight;
      curl(au, bo) -= weight;
      curl(ao, bv) -= weight;
      curl(ao, bo) += weight;
    }
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      const double entry = curl(i, j) - curl(j, i);  // of x_i y_j
      hessian(2 * i, 2 * j + 1) += entry;
      hessian(2 * j + 1, 2 * i) += entry;
    }
}

Eigen::VectorXd norm_coefficients(const JacobianTables& tables, const Net& net, const Point& d1,
                                  const Point& d2) {
  // J = n [a, b] D^-1 with D = [d1, d2]: the columns of J are mixed by the rows of D^-1.
  const double det = cross(d1, d2);
  const double scale = tables.degree / det;
  std::vector<Point> x(tables.derivative_size), y(tables.derivative_size);
  for (int k = 0; k < tables.derivative_size; ++k) {
    const Point a = net[tables.along_u[k]] - net[tables.origin[k]];
    const Point b = net[tables.along_v[k]] - net[tables.origin[k]];
    x[k] = scale * (a * d2.y() - b * d1.y());
    y[k] = scale * (b * d1.x() - a * d2.x());
  }
  Eigen::VectorXd out(tables.det_size);
  for (int c = 0; c < tables.det_size; ++c) {
    double sum = 0;
    for (const auto& p : tables.products[c])
      sum += p.weight * (x[p.first].dot(x[p.second]) + y[p.first].dot(y[p.second]));
    out[c] = sum;
  }
  return out;
}

double distortion_bound(const JacobianTables& tables, const Net& net, const Point& d1,
                        const Point& d2) {
  const double domain = cross(d1, d2);
  if (!(domain > 0)) return std::numeric_limits<double>::infinity();
  const double least = det_coefficients(tables, net).minCoeff() / domain;
  if (!(least > 0)) return std::numeric_limits<double>::infinity();
  return norm_coefficients(tables, net, d1, d2).maxCoeff() / least;
}

}  // namespace c1mesh
