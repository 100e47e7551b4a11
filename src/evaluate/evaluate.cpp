// SPDX-License-Identifier: GPL-3.0-or-later
// One result, measured by its verification.
#include "c1mesh/evaluate.h"

namespace c1mesh {

ShapeEvaluation evaluate(const Result& result) {
  ShapeEvaluation out;
  out.name = result.name;
  VerifyReport report = verify(result, claimed_bounds(result));
  const VerifyItem& structure = report.items.front();
  if (structure.verdict != Verdict::valid) {  // nothing else was looked at
    out.unreadable = true;
    out.fault = structure.name + ": " + structure.message;
    return out;
  }
  out.evaluated = true;
  out.metrics = std::move(report.metrics);
  out.samples = std::move(report.samples);
  out.regular = report.regular();
  out.conforming = report.conforming();
  out.c1 = report.c1();
  out.valid = report.valid();
  return out;
}

}  // namespace c1mesh
