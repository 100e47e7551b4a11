// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured in plain doubles: distortion and the gradients on both sides of each edge.
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

std::vector<Vec<double>> net_of(const Result& result, int t) {
  std::vector<Vec<double>> net;
  for (const int id : result.triangle_control_points[t])
    net.push_back({result.control_points[id].x(), result.control_points[id].y()});
  return net;
}

/// The columns of the domain triangle's edge vectors from its corner k.
Eigen::Matrix2d domain_frame(const Result& result, int t, int k) {
  const auto at = [&](int c) -> const Point& {
    return result.domain_vertices[result.triangles[t][c % 3]];
  };
  Eigen::Matrix2d frame;
  frame << at(k + 1) - at(k), at(k + 2) - at(k);
  return frame;
}

/// Bernstein coefficients of |J|_F^2 and the least one of det J.
struct Forms {
  double most_norm, least_det;
};

Forms forms_of(const Result& result, const ProductRule& rule, int t) {
  const Eigen::Matrix2d frame = domain_frame(result, t, 0), inverse = frame.inverse();
  const std::vector<Vec<double>> net = net_of(result, t);
  const auto d = derivative_forms(rule.degree + 1, net);
  std::vector<Eigen::Matrix2d> J;
  for (std::size_t a = 0; a < d[0].size(); ++a) {
    Eigen::Matrix2d columns;
    columns << d[0][a][0], d[1][a][0], d[0][a][1], d[1][a][1];
    J.push_back(columns * inverse);
  }
  const auto norm = product_form<double>(
      rule, [&](std::size_t a, std::size_t b) { return J[a].cwiseProduct(J[b]).sum(); });
  const auto det = det_form(rule, net);
  return {*std::max_element(norm.begin(), norm.end()),
          *std::min_element(det.begin(), det.end()) / frame.determinant()};
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
void measure_distortion(const Subject& subject, Metrics& metrics) {
  const FloatTrapsOff flat_triangles;
  const Result& result = subject.result;
  const ProductRule rule(subject.degree() - 1);
  Point low = result.domain_vertices[0], high = low;
  for (const Point& p : result.domain_vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Lengths relative to each plane's own extent, so that no choice of units matters.
  const double scale = std::pow((high - low).maxCoeff() / subject.extent, 2);
  metrics.min_det_coefficient = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t) {
    const Forms forms = forms_of(result, rule, t);
    const bool regular = forms.least_det > 0 && domain_frame(result, t, 0).determinant() > 0;
    const double bound =
        regular ? forms.most_norm / forms.least_det : std::numeric_limits<double>::infinity();
    metrics.mips_bound_max = std::max(metrics.mips_bound_max, bound);
    metrics.min_det_coefficient = std::min(metrics.min_det_coefficient, forms.least_det * scale);
  }
}

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
