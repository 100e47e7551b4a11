// SPDX-License-Identifier: GPL-3.0-or-later
// Nets of one triangle for tests of its terms.
#pragma once

#include <cstddef>
#include <functional>
#include <random>

#include "bernstein/jacobian.h"

namespace c1mesh::testing_tools {

/// The points o + i/n a + j/n b in net order.
inline Net affine_net(int n, const Point& o, const Point& a, const Point& b) {
  Net net;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i) net.push_back(o + double(i) / n * a + double(j) / n * b);
  return net;
}

/// An affine net with every point moved by at most `shift` in each coordinate.
inline Net random_net(int n, unsigned seed, double shift) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Net net = affine_net(n, {0.3, -0.2}, Point(1 + 0.2 * unit(random), 0.2 * unit(random)),
                       Point(0.3 * unit(random), 0.9 + 0.2 * unit(random)));
  for (Point& p : net) p += shift * Point(unit(random), unit(random));
  return net;
}

/// The map (u, v) -> (u, v + h(u)) of degree n, all coefficients of its det one; `slopes` are the n
/// Bernstein coefficients of h'. |J|^2 = 2 + h'^2.
inline Net sheared_net(int n, const std::vector<double>& slopes) {
  std::vector<double> h{0};
  for (int i = 0; i < n; ++i) h.push_back(h.back() + slopes[static_cast<std::size_t>(i)] / n);
  Net net = affine_net(n, {0, 0}, {1, 0}, {0, 1});
  std::size_t k = 0;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n - j; ++i, ++k) net[k].y() += h[static_cast<std::size_t>(i)];
  return net;
}

inline Net moved(const Net& net, const std::function<Point(const Point&)>& map) {
  Net out;
  for (const Point& p : net) out.push_back(map(p));
  return out;
}

/// (p, vec D) as variables, the edge vectors of the domain triangle behind the control points.
inline Eigen::VectorXd packed(const Net& net, const Eigen::Matrix2d& D) {
  Eigen::VectorXd x(2 * static_cast<Eigen::Index>(net.size()) + 4);
  for (std::size_t k = 0; k < net.size(); ++k)
    x.segment<2>(2 * static_cast<Eigen::Index>(k)) = net[k];
  x.tail<4>() << D.col(0), D.col(1);
  return x;
}

/// The first `size` points of the variables.
inline Net net_of(const Eigen::VectorXd& x, int size) {
  Net net;
  for (int k = 0; k < size; ++k) net.push_back(x.segment<2>(2 * k));
  return net;
}

inline Eigen::Matrix2d domain_of(const Eigen::VectorXd& x) {
  Eigen::Matrix2d D;
  D << x.segment<2>(x.size() - 4), x.tail<2>();
  return D;
}

}  // namespace c1mesh::testing_tools
