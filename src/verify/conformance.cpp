// SPDX-License-Identifier: GPL-3.0-or-later
// Conformance: the control points on the boundary against the exact restriction of the input
// curves.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "verify/checks.h"
#include "verify/exact.h"
#include "verify/rounding.h"

namespace c1mesh::verification {
namespace {

double ulp(double x) {
  const double next = std::nextafter(std::abs(x), std::numeric_limits<double>::infinity());
  return next - std::abs(x);
}

}  // namespace

VerifyItem check_conformance(const Subject& subject, Metrics& metrics, Samples& samples,
                             Certificate& certificate) {
  Faults faults;
  std::map<int, double> by_control;  // a control point at a vertex lies on two curves
  const int n = subject.degree();
  std::vector<CurveEdge> edges = subject.result.boundary_edges;
  edges.insert(edges.end(), subject.result.feature_edges.begin(),
               subject.result.feature_edges.end());
  for (const CurveEdge& e : edges) {
    const int id = subject.surface.find_edge(e.a, e.b);
    const BezierCurve& curve = subject.result.curves[e.curve];
    if (curve.degree() > n) {
      faults.add(fmt::format("curve {} has a higher degree than the result", e.curve));
      continue;
    }
    if (id < 0) continue;  // reported by the topology check
    // A feature edge may be listed along either of its two triangles: take the one that runs so.
    const SurfaceEdge& edge = subject.surface.edges[id];
    const bool forward = edge.side[e.a < e.b ? 0 : 1].present();
    const Side& side = edge.side[(e.a < e.b) == forward ? 0 : 1];
    const auto exact = exact_restriction(curve, e.t0, e.t1, n);
    double distance = 0, magnitude = 0;
    for (int s = 0; s <= n; ++s) {
      const int control = subject.control_id(side.triangle, side.corner, forward ? s : n - s, 0);
      const Point& p = subject.result.control_points[control];
      const double off =
          length_above({exact[s][0] - Rational(p.x()), exact[s][1] - Rational(p.y())});
      double& largest = by_control[control];
      largest = std::max(largest, relative_above(off, subject.extent));
      distance = std::max(distance, off);
      magnitude = std::max({magnitude, std::abs(p.x()), std::abs(p.y())});
    }
    const double bound = relative_above(distance, subject.extent);
    metrics.conformance_max = std::max(metrics.conformance_max, bound);
    certificate.curve_edges.push_back({e.a, e.b, bound});
    const double allowed =
        subject.options.conformance_tolerance * subject.extent + 2 * ulp(magnitude);
    if (!(distance <= allowed))
      faults.add(fmt::format("edge ({}, {}) is {:.3g} of the extent away from curve {}", e.a, e.b,
                             bound, e.curve));
  }
  certificate.conformance = metrics.conformance_max;
  for (const auto& [control, off] : by_control) samples.conformance.push_back(off);
  return faults.item("conformance",
                     fmt::format("at most {:.3g} of the extent off the input curves (bound {:.3g})",
                                 metrics.conformance_max, subject.options.conformance_tolerance));
}

}  // namespace c1mesh::verification
