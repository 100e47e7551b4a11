// SPDX-License-Identifier: GPL-3.0-or-later
// What a certificate claims against what was found. The proofs themselves are followed where they
// are needed: triangle_proofs.cpp, boundary_simple.cpp.
#include "c1mesh/certificate.h"

#include "verify/checks.h"

namespace c1mesh::verification {
namespace {

void compare_edges(const std::vector<EdgeBound>& given, const std::vector<EdgeBound>& made,
                   const char* what, Faults& record) {
  if (given.size() != made.size())
    return record.add(
        fmt::format("{} {} are listed where the result has {}", given.size(), what, made.size()));
  for (std::size_t i = 0; i < given.size(); ++i) {
    const EdgeBound &claim = given[i], &found = made[i];
    if (claim.a != found.a || claim.b != found.b)
      record.add(fmt::format("({}, {}) is listed among the {} in the place of ({}, {})", claim.a,
                             claim.b, what, found.a, found.b));
    else if (!(found.bound <= claim.bound))
      record.add(fmt::format("edge ({}, {}) claims {:.17g} of the extent, but it is {:.17g}",
                             claim.a, claim.b, claim.bound, found.bound));
  }
}

/// The summary's bounds against the lists of the same certificate.
void compare_summary(const Certificate& given, Faults& record) {
  const auto check = [&](bool holds, const char* what) {
    if (!holds) record.add(fmt::format("the bound \"{}\" is not that of the list", what));
  };
  for (const TriangleProof& proof : given.triangles) {
    check(given.det <= proof.det, "det");
    check(given.g >= proof.g, "g");
  }
  for (const EdgeBound& edge : given.edges) check(given.c1 >= edge.bound, "c1");
  for (const EdgeBound& edge : given.curve_edges)
    check(given.conformance >= edge.bound, "conformance");
}

/// A verdict that was claimed must be the one that is found.
void compare_items(const Certificate& given, const Certificate& made, Faults& record) {
  for (const VerifyItem& claim : given.items) {
    if (claim.verdict != Verdict::valid) continue;
    for (const VerifyItem& found : made.items)
      if (found.name == claim.name && found.verdict != Verdict::valid)
        record.add(fmt::format("\"{}\" is claimed to be valid", claim.name));
  }
}

}  // namespace

bool certificate_fits(const Subject& subject, const Certificate& given, Faults& record) {
  const std::size_t before = record.count();
  if (given.triangles.size() != subject.result.triangles.size())
    record.add(fmt::format("it is of {} triangles, but the result has {}", given.triangles.size(),
                           subject.result.triangles.size()));
  if (given.degree != subject.degree())
    record.add(fmt::format("it is of degree {}, but the result of degree {}", given.degree,
                           subject.degree()));
  if (given.extent != subject.extent)
    record.add(fmt::format("it is for the extent {:.17g}, but the result's is {:.17g}",
                           given.extent, subject.extent));
  return record.count() == before;
}

void compare_bounds(const Certificate& given, const Certificate& made, Faults& record) {
  compare_edges(given.edges, made.edges, "edges where C1 is claimed", record);
  compare_edges(given.curve_edges, made.curve_edges, "edges on curves", record);
  compare_summary(given, record);
  compare_items(given, made, record);
}

}  // namespace c1mesh::verification
