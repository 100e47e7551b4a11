// SPDX-License-Identifier: GPL-3.0-or-later
// C1 across edges: the equations of docs/format.md, evaluated exactly on the doubles as written.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "verify/checks.h"
#include "verify/exact.h"
#include "verify/rounding.h"

namespace c1mesh::verification {
namespace {

/// The equations of one interior edge, from both sides.
struct EdgeDeviation {
  std::vector<double> d;  ///< not below d_ei, the larger of the two orientations, of the extent
  bool within = true;     ///< every equation holds up to the tolerance and coordinate rounding
};

/// gamma times the area of (v0, v1, v2), then that area itself: exact barycentric coordinates of
/// v3.
std::array<Rational, 4> barycentric(const Result& result, int v0, int v1, int v2, int v3) {
  const auto at = [&](int v) { return exact(result.domain_vertices[v]); };
  const Vec<Rational> p0 = at(v0), p1 = at(v1), p2 = at(v2), p3 = at(v3);
  return {exact_area(p3, p1, p2), exact_area(p0, p3, p2), exact_area(p0, p1, p3),
          exact_area(p0, p1, p2)};
}

double largest_coordinate(const std::array<const Point*, 4>& points) {
  double out = 0;
  for (const Point* p : points) out = std::max({out, std::abs(p->x()), std::abs(p->y())});
  return out;
}

/// With r = p' - (g0 p_0i + g1 p_0(i+1) + g2 p_1i) the equation of t -> t', solving it for p_1i
/// gives the equation of t' -> t with the residual -r / g2 and coefficients -g0/g2, -g1/g2, 1/g2.
EdgeDeviation deviation(const Subject& subject, const SurfaceEdge& edge) {
  const Result& result = subject.result;
  const int n = subject.degree();
  const Side &left = edge.side[0], &right = edge.side[1];
  const auto third = [&](const Side& s) {
    return result.triangles[s.triangle][(s.corner + 2) % 3];
  };
  const auto area = barycentric(result, edge.a, edge.b, third(left), third(right));
  if (sgn(area[3]) == 0 || sgn(area[2]) == 0)
    return {std::vector<double>(n, std::numeric_limits<double>::infinity()), false};
  const VerifyOptions& options = subject.options;
  const double whole = area[3].get_d();
  const double g0 = area[0].get_d() / whole, g1 = area[1].get_d() / whole;
  const double g2 = std::abs(area[2].get_d() / whole);
  const double forward = 1 + std::abs(g0) + std::abs(g1) + g2;
  const double backward = 1 + (std::abs(g0) + std::abs(g1) + 1) / g2;
  // The orientation whose third corner is the farther from the edge has the larger residual.
  const Rational& divisor = abs(area[2]) < abs(area[3]) ? area[2] : area[3];
  EdgeDeviation out;
  for (int i = 0; i < n; ++i) {
    const std::array<const Point*, 4> p{
        &subject.control(left.triangle, left.corner, i, 0),
        &subject.control(left.triangle, left.corner, i + 1, 0),
        &subject.control(left.triangle, left.corner, i, 1),
        &subject.control(right.triangle, right.corner, n - 1 - i, 1)};
    Vec<Rational> residual;
    for (int k = 0; k < 2; ++k) {
      residual[k] = area[3] * Rational((*p[3])[k]);
      for (int s = 0; s < 3; ++s) residual[k] -= area[s] * Rational((*p[s])[k]);
      residual[k] /= divisor;
    }
    const double d = length_above(residual);
    out.d.push_back(relative_above(d, subject.extent));
    // Rounding of the coordinates themselves: half an ulp each, weighted by the coefficients.
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * largest_coordinate(p);
    const double coefficients = &divisor == &area[2] ? backward : forward;
    const bool bounded = std::isfinite(options.c1_bound);
    out.within = out.within &&
                 (bounded ? out.d.back() <= options.c1_bound
                          : d <= options.c1_tolerance * subject.extent + rounding * coefficients);
  }
  return out;
}

}  // namespace

std::vector<int> smooth_edges(const Subject& subject) {
  std::set<int> excluded;
  for (const auto& e : subject.result.relaxed_edges)
    excluded.insert(subject.surface.find_edge(e[0], e[1]));
  for (const CurveEdge& e : subject.result.feature_edges)
    excluded.insert(subject.surface.find_edge(e.a, e.b));
  std::vector<int> out;
  for (int e = 0; e < static_cast<int>(subject.surface.edges.size()); ++e)
    if (subject.surface.edges[e].interior() && !excluded.count(e)) out.push_back(e);
  return out;
}

VerifyItem check_c1(const Subject& subject, Metrics& metrics, Samples& samples,
                    Certificate& certificate) {
  Faults faults;
  const std::vector<int> edges = smooth_edges(subject);
  for (const int e : edges) {
    const SurfaceEdge& edge = subject.surface.edges[e];
    const EdgeDeviation found = deviation(subject, edge);
    samples.d_ei.insert(samples.d_ei.end(), found.d.begin(), found.d.end());
    const double most = *std::max_element(found.d.begin(), found.d.end());
    certificate.edges.push_back({edge.a, edge.b, most});
    certificate.c1 = std::max(certificate.c1, most);
    if (!found.within)
      faults.add(
          fmt::format("edge ({}, {}) deviates by {:.3g} of the extent", edge.a, edge.b, most));
  }
  metrics.d_ei = spread_of(samples.d_ei);
  const VerifyOptions& options = subject.options;
  return faults.item(
      "C1", fmt::format("{} edges, deviation at most {:.3g} of the extent (bound {:.3g})",
                        edges.size(), metrics.d_ei.max,
                        std::isfinite(options.c1_bound) ? options.c1_bound : options.c1_tolerance));
}

}  // namespace c1mesh::verification
