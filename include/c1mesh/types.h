// SPDX-License-Identifier: GPL-3.0-or-later
// Points and Bezier curves: the vocabulary every other header builds on.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace c1mesh {

/// A point or vector of the plane. In a Drawing, a Shape's `curves` and a Result: the input's
/// units, y upward. Inside the pipeline: the normalised frame (see Frame).
using Point = Eigen::Vector2d;

/// A planar polynomial Bezier curve of degree `poles.size() - 1` over t in [0, 1].
struct BezierCurve {
  std::vector<Point> poles;  ///< control points p_0 … p_n

  /// How many poles there are, less one.
  int degree() const { return static_cast<int>(poles.size()) - 1; }
  /// The value at t = 0.
  const Point& start() const { return poles.front(); }
  /// The value at t = 1.
  const Point& end() const { return poles.back(); }
};

/// The twist-free cross product a.x b.y - a.y b.x: twice the signed area of the triangle 0, a, b.
inline double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace c1mesh
