// SPDX-License-Identifier: GPL-3.0-or-later
// What the proofs of the triangles say together.
#include <algorithm>
#include <limits>

#include "verify/checks.h"
#include "verify/triangle_proofs.h"

namespace c1mesh::verification {
namespace {

/// Areas of the domain per areas of the shape, each relative to its own extent, so that no choice
/// of units matters.
double area_scale(const Subject& subject) {
  Point low = subject.result.domain_vertices[0], high = low;
  for (const Point& p : subject.result.domain_vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double scale = (high - low).maxCoeff() / subject.extent;
  return scale * scale;
}

void note_bounds(const std::vector<TriangleFinding>& findings, const Subject& subject,
                 Metrics& metrics, Certificate& certificate) {
  certificate.det = metrics.min_det_coefficient = std::numeric_limits<double>::infinity();
  for (const TriangleFinding& finding : findings) {
    metrics.mips_bound_max = std::max(metrics.mips_bound_max, finding.most_distortion);
    metrics.min_det_coefficient = std::min(metrics.min_det_coefficient, finding.least_coefficient);
    certificate.det = std::min(certificate.det, finding.proof.det);
    certificate.g = std::max(certificate.g, finding.proof.g);
    certificate.triangles.push_back(finding.proof);
  }
  metrics.min_det_coefficient *= area_scale(subject);
}

}  // namespace

VerifyItem check_regularity(const Subject& subject, Metrics& metrics, Certificate& certificate,
                            Faults& record) {
  std::vector<int> invalid, undecided;
  const std::vector<TriangleFinding> findings = examine_triangles(subject);
  for (int t = 0; t < static_cast<int>(findings.size()); ++t) {
    if (findings[t].regular == Verdict::invalid) invalid.push_back(t);
    if (findings[t].regular == Verdict::undecided) undecided.push_back(t);
    if (!findings[t].record_holds)
      record.add(
          fmt::format("triangle {}: its proof does not show det J >= {:.17g} and g <= {:.17g}", t,
                      subject.given->triangles[t].det, subject.given->triangles[t].g));
  }
  note_bounds(findings, subject, metrics, certificate);
  const std::string name = "regularity";
  if (!invalid.empty())
    return {
        name, Verdict::invalid,
        fmt::format("det J is not positive in {} triangles: {}", invalid.size(), id_text(invalid))};
  if (!undecided.empty())
    return {name, Verdict::undecided,
            fmt::format("not decided in {} triangles: {}", undecided.size(), id_text(undecided))};
  return {name, Verdict::valid, "det J is positive on every triangle, proven"};
}

}  // namespace c1mesh::verification
