// SPDX-License-Identifier: GPL-3.0-or-later
// The norm of d_ei (eq. 4.1), not squared, made differentiable.
#pragma once

#include <cmath>

#include "c1mesh/types.h"

namespace c1mesh {

/// sqrt(|d|^2 + epsilon^2) - epsilon: between |d| - epsilon and |d|, convex. `majoriser` is that of
/// the quadratic in d that touches the norm here and nowhere falls below it: the weight 1 / |d| of
/// re-weighted least squares. The norm's own Hessian has no curvature along d, and steps by it are
/// hundreds of times too long where d is not linear (docs/paper.md).
struct SmoothNorm {
  double value = 0;
  Point gradient;
  double majoriser = 0;  ///< times the identity

  static double at(const Point& d, double epsilon) {
    // The difference of two nearly equal numbers, without cancellation.
    const double square = d.squaredNorm();
    return square / (std::sqrt(square + epsilon * epsilon) + epsilon);
  }
  SmoothNorm(const Point& d, double epsilon) : value(at(d, epsilon)) {
    const double root = std::sqrt(d.squaredNorm() + epsilon * epsilon);
    gradient = d / root;
    majoriser = 1 / root;
  }
};

}  // namespace c1mesh
