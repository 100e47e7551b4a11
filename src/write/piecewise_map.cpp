// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/piecewise_map.h"

#include <Eigen/LU>
#include <array>
#include <limits>

namespace c1mesh {

Net PiecewiseMap::net(int t) const {
  Net out;
  for (const int id : result_.triangle_control_points[t]) out.push_back(result_.control_points[id]);
  return out;
}

Point PiecewiseMap::evaluate(int t, const Barycentric& at) const {
  Net points = net(t);
  for (int n = result_.degree; n > 0; --n) reduce_net(points, n, at);
  return points[0];
}

Point PiecewiseMap::domain_point(int t, const Barycentric& at) const {
  Point out = Point::Zero();
  for (int k = 0; k < 3; ++k) out += at[k] * result_.domain_vertices[result_.triangles[t][k]];
  return out;
}

Eigen::Matrix2d PiecewiseMap::jacobian(int t, const Barycentric& at) const {
  Net points = net(t);
  for (int n = result_.degree; n > 1; --n) reduce_net(points, n, at);
  const auto corner = [&](int k) -> const Point& {
    return result_.domain_vertices[result_.triangles[t][k]];
  };
  Eigen::Matrix2d derivative, frame;
  derivative << points[1] - points[0], points[2] - points[0];
  frame << corner(1) - corner(0), corner(2) - corner(0);
  return result_.degree * derivative * frame.inverse();
}

double PiecewiseMap::distortion(int t, const Barycentric& at) const {
  const Eigen::Matrix2d J = jacobian(t, at);
  const double det = J.determinant();
  return det > 0 ? J.squaredNorm() / det : std::numeric_limits<double>::infinity();
}

std::vector<Point> PiecewiseMap::segment(int t, const Barycentric& p, const Barycentric& q) const {
  return restrict_net_to_line(net(t), result_.degree, p, q);
}

int PiecewiseMap::turned_index(int k, int second, int third) const {
  std::array<int, 3> exponent;
  exponent[k] = result_.degree - second - third;
  exponent[(k + 1) % 3] = second;
  exponent[(k + 2) % 3] = third;
  return net_index(result_.degree, exponent[1], exponent[2]);
}

std::vector<Point> PiecewiseMap::edge(int t, int k) const {
  std::vector<Point> out;
  for (int s = 0; s <= result_.degree; ++s)
    out.push_back(result_.control_points[control_id(t, k, s, 0)]);
  return out;
}

}  // namespace c1mesh
