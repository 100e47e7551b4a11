// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates, followed against one small result.
#include "c1mesh/certificate.h"

#include "c1mesh/verify.h"
#include "fuzz/target.h"

namespace {

using namespace c1mesh;

/// The identity of a square of side 3, in two cubic triangles: all control points are integers.
Result square() {
  Result out;
  out.name = "square";
  out.domain_vertices = {Point(0, 0), Point(3, 0), Point(3, 3), Point(0, 3)};
  out.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (int y = 0; y <= 3; ++y)
    for (int x = 0; x <= 3; ++x) out.control_points.emplace_back(x, y);
  std::vector<int> lower, upper;
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i + j <= 3; ++i) {
      lower.push_back(4 * j + i + j);
      upper.push_back(4 * (i + j) + i);
    }
  out.triangle_control_points = {lower, upper};
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    out.curves.push_back({{out.domain_vertices[k], out.domain_vertices[next]}});
    out.boundary_edges.push_back({k, next, k, 0, 1});
    out.boundary_vertices.push_back({k, true});
  }
  return out;
}

}  // namespace

C1MESH_FUZZ_TARGET(certificate) {
  Certificate certificate;
  if (!fuzz::accepted([&] { certificate = parse_certificate(bytes); })) return;
  const std::string text = format_certificate(certificate);
  fuzz::require(format_certificate(parse_certificate(text)) == text,
                "a certificate does not read back");
  static const Result result = square();
  static const Certificate made = verify(result).certificate;
  const VerifyReport report = recheck(result, certificate);
  if (!report.valid()) return;
  // What holds of the identity: det J = 1, |J|^2 / det J = 2, and exact C1.
  fuzz::require(certificate.triangles.size() == made.triangles.size() && certificate.det <= 1 &&
                    certificate.g >= 2 && certificate.edges.size() == made.edges.size(),
                "a false certificate holds");
}
