// SPDX-License-Identifier: GPL-3.0-or-later
// Result files, and the certification of the small ones.
#include "c1mesh/result.h"

#include "c1mesh/verify.h"
#include "fuzz/target.h"

C1MESH_FUZZ_TARGET(result) {
  using namespace c1mesh;
  constexpr std::size_t kSmall = 64;
  Result result;
  if (!fuzz::accepted([&] { result = parse_result(bytes, "fuzz"); })) return;
  const std::string text = format_result(result);
  fuzz::require(format_result(parse_result(text, "fuzz")) == text, "a result does not read back");
  if (result.triangles.size() > kSmall || result.curves.size() > kSmall || result.degree > 6)
    return;
  const VerifyReport report = verify(result, claimed_bounds(result));
  fuzz::require(!report.valid() || (report.regular() && report.conforming() && report.c1()),
                "valid without its parts");
  report_text(report);
  if (!report.valid()) return;
  const Certificate kept = parse_certificate(format_certificate(report.certificate));
  const VerifyReport again = recheck(result, kept, claimed_bounds(result));
  fuzz::require(
      again.items.back().name == "certificate" && again.items.back().verdict == Verdict::valid,
      "a certificate does not hold of its own result");
}
