// SPDX-License-Identifier: GPL-3.0-or-later
// The norm of d_ei (eq. 4.1), not squared, made differentiable.
#pragma once

#include <cmath>

#include "c1mesh/types.h"

namespace c1mesh {

/// sqrt(|d|^2 + epsilon^2) - epsilon: between |d| - epsilon and |d|, convex, its Hessian is exact.
struct SmoothNorm {
  double value = 0;
  Point gradient;
  Eigen::Matrix2d hessian;

  static double at(const Point& d, double epsilon) {
    // The difference of two nearly equal numbers, without cancellation.
    const double square = d.squaredNorm();
    return square / (std::sqrt(square + epsilon * epsilon) + epsilon);
  }
  SmoothNorm(const Point& d, double epsilon) : value(at(d, epsilon)) {
    const double root = std::sqrt(d.squaredNorm() + epsilon * epsilon);
    gradient = d / root;
    hessian = (Eigen::Matrix2d::Identity() - gradient * gradient.transpose()) / root;
  }
};

}  // namespace c1mesh
