// SPDX-License-Identifier: GPL-3.0-or-later
// The map of a result, triangle by triangle: values, Jacobians, images of straight segments.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bernstein/net_blossom.h"
#include "c1mesh/result.h"

namespace c1mesh {

/// A view of a result for those who write it, with the ids of its control points; what users of the
/// library get is Map (c1mesh/map.h).
class PiecewiseMap {
 public:
  explicit PiecewiseMap(const Result& result) : result_(result) {}

  /// Image of a point of triangle t.
  Point evaluate(int t, const Barycentric& at) const;
  /// The same point in the domain.
  Point domain_point(int t, const Barycentric& at) const;
  /// Jacobian of the map from the domain (columns: d/du, d/dv) at a point of triangle t.
  Eigen::Matrix2d jacobian(int t, const Barycentric& at) const;
  /// |J|_F^2 / det J there; infinite where det J <= 0.
  double distortion(int t, const Barycentric& at) const;
  /// Control points (degree + 1) of the image of the straight segment p -> q in triangle t: the
  /// blossom at n-i times p and i times q. Exact up to rounding.
  std::vector<Point> segment(int t, const Barycentric& p, const Barycentric& q) const;
  /// Control points of triangle t's edge from corner k to corner k+1.
  std::vector<Point> edge(int t, int k) const;
  /// Index in net order of the control point with exponents (n-second-third, second, third) at the
  /// corners (k, k+1, k+2).
  int turned_index(int k, int second, int third) const;
  int control_id(int t, int k, int second, int third) const {
    return result_.triangle_control_points[t][turned_index(k, second, third)];
  }
  const Result& result() const { return result_; }

 private:
  Net net(int t) const;

  const Result& result_;
};

}  // namespace c1mesh
