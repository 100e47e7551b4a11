// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured in plain doubles: the gradients on both sides of each edge.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/float_traps.h"
#include "verify/checks.h"

namespace c1mesh::verification {
namespace {

constexpr int kSamples = 10;  // per edge, ends included

/// The columns of the domain triangle's edge vectors from its corner k.
Eigen::Matrix2d domain_frame(const Result& result, int t, int k) {
  const auto at = [&](int c) -> const Point& {
    return result.domain_vertices[result.triangles[t][c % 3]];
  };
  Eigen::Matrix2d frame;
  frame << at(k + 1) - at(k), at(k + 2) - at(k);
  return frame;
}

/// J at the point s of the edge that starts at `side`'s corner: columns from the rows of control
/// points on the edge and next to it.
Eigen::Matrix2d jacobian_on(const Subject& subject, const Side& side, double s) {
  const int n = subject.degree();
  Point along = Point::Zero(), across = Point::Zero();
  for (int i = 0; i < n; ++i) {
    const Point& p = subject.control(side.triangle, side.corner, i, 0);
    const double bernstein = multinomial(n - 1, i, 0) * std::pow(s, i) * std::pow(1 - s, n - 1 - i);
    along += n * bernstein * (subject.control(side.triangle, side.corner, i + 1, 0) - p);
    across += n * bernstein * (subject.control(side.triangle, side.corner, i, 1) - p);
  }
  Eigen::Matrix2d columns;
  columns << along, across;
  return columns * domain_frame(subject.result, side.triangle, side.corner).inverse();
}

}  // namespace

Spread spread_of(std::vector<double> sample) {
  if (sample.empty()) return {};
  std::sort(sample.begin(), sample.end());
  const auto ranked = [&](double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * double(sample.size())));
    return sample[std::max<std::size_t>(rank, 1) - 1];
  };
  return {ranked(0.5), ranked(0.99), sample.back()};
}

// Any file is measured, whatever it holds: flat domain triangles, numbers near overflow. What comes
// out for them may be infinite and is not certified.
void measure_gradients(const Subject& subject, Metrics& metrics, Samples& samples) {
  const FloatTrapsOff flat_triangles;
  for (const int e : smooth_edges(subject)) {
    const SurfaceEdge& edge = subject.surface.edges[e];
    double angle = 0, magnitude = 0;
    for (int k = 0; k < kSamples; ++k) {
      const double s = double(k) / (kSamples - 1);
      const Eigen::Matrix2d left = jacobian_on(subject, edge.side[0], s);
      const Eigen::Matrix2d right = jacobian_on(subject, edge.side[1], 1 - s);
      for (int row = 0; row < 2; ++row) {  // the gradients of x and of y
        const Point g = left.row(row), h = right.row(row);
        const double longer = std::max(g.norm(), h.norm());
        angle =
            std::max(angle, std::atan2(std::abs(cross(g, h)), g.dot(h)) * 180 / std::numbers::pi);
        if (longer > 0) magnitude = std::max(magnitude, std::abs(g.norm() - h.norm()) / longer);
      }
    }
    samples.gradient_angle_deg.push_back(angle);
    samples.gradient_magnitude.push_back(magnitude);
  }
  metrics.gradient_angle_deg = spread_of(samples.gradient_angle_deg);
  metrics.gradient_magnitude = spread_of(samples.gradient_magnitude);
}

}  // namespace c1mesh::verification
