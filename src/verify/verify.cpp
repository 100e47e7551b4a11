// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/verify.h"

#include <optional>

#include "c1mesh/cost.h"
#include "verify/checks.h"

namespace c1mesh {
namespace {

using verification::Subject;

/// Larger side of the bounding box of the curves' poles, of the control points if there are none.
double extent_of(const Result& result) {
  std::vector<Point> points;
  for (const BezierCurve& curve : result.curves)
    points.insert(points.end(), curve.poles.begin(), curve.poles.end());
  if (points.empty()) points = result.control_points;
  Point low = points[0], high = low;
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double side = (high - low).maxCoeff();
  return side > 0 ? side : 1;
}

VerifyReport run(const Result& result, const Shape* input, const Certificate* given,
                 const VerifyOptions& options) {
  VerifyReport report;
  std::optional<StageTimer> timer(std::in_place, "verify: structure");
  report.items.push_back(verification::check_structure(result));
  if (report.items[0].verdict != Verdict::valid) return report;  // nothing else may be looked up

  timer.emplace("verify: topology");
  Subject subject{result, options, verification::surface_of(result), extent_of(result), nullptr};
  verification::Faults record;
  if (given && verification::certificate_fits(subject, *given, record)) subject.given = given;
  Metrics& metrics = report.metrics;
  Samples& samples = report.samples;
  Certificate& made = report.certificate;
  made.name = result.name;
  made.degree = result.degree;
  made.extent = subject.extent;
  metrics.triangles = static_cast<int>(result.triangles.size());
  report.items.push_back(verification::check_topology(subject));
  timer.emplace("verify: curves");
  report.items.push_back(verification::check_coverage(subject));
  if (input) report.items.push_back(verification::check_input_curves(subject, *input));
  report.items.push_back(verification::check_conformance(subject, metrics, samples, made));
  timer.emplace("verify: boundary simple");
  report.items.push_back(verification::check_boundary_simple(subject, made, record));
  timer.emplace("verify: domain");
  report.items.push_back(verification::check_domain_orientation(subject));
  report.items.push_back(verification::check_winding(subject));
  timer.emplace("verify: regularity");
  report.items.push_back(verification::check_regularity(subject, metrics, made, record));
  timer.emplace("verify: C1");
  report.items.push_back(verification::check_c1(subject, metrics, samples, made));
  timer.emplace("verify: exceptional vertices");
  report.items.push_back(verification::check_boundary_vertices(subject));
  report.items.push_back(verification::check_exceptional(subject, metrics));
  timer.emplace("verify: measures");
  verification::measure_gradients(subject, metrics, samples);
  verification::measure_flatness(subject, metrics);
  timer.emplace("verify: overlap");
  metrics.domain_overlaps = verification::domain_overlaps(subject);
  made.items = report.items;
  if (subject.given) verification::compare_bounds(*given, made, record);
  if (given) report.items.push_back(record.item("certificate", "all its proofs and bounds hold"));
  return report;
}

}  // namespace

VerifyOptions claimed_bounds(const Result& result) {
  VerifyOptions out;
  for (const auto& [name, value] : result.parameters) {
    const double* bound = std::get_if<double>(&value);
    if (!bound || !(*bound > 0)) continue;
    if (name == "c1_bound") out.c1_bound = *bound;
    if (name == "conformance_bound") out.conformance_tolerance = *bound;
  }
  return out;
}

VerifyReport verify(const Result& result, const VerifyOptions& options) {
  return run(result, nullptr, nullptr, options);
}

VerifyReport verify(const Result& result, const Shape& input, const VerifyOptions& options) {
  return run(result, &input, nullptr, options);
}

VerifyReport recheck(const Result& result, const Certificate& certificate,
                     const VerifyOptions& options) {
  return run(result, nullptr, &certificate, options);
}

}  // namespace c1mesh
