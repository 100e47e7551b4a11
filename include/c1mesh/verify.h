// SPDX-License-Identifier: GPL-3.0-or-later
// An independent look at a result: nothing here is shared with the code that made it.
#pragma once

#include <string>
#include <vector>

#include "c1mesh/result.h"
#include "c1mesh/shape.h"

namespace c1mesh {

enum class Verdict { valid, invalid, undecided };

/// One thing that was looked at.
struct VerifyItem {
  std::string name;  ///< "topology", "coverage", "conformance", "boundary simple",
                     ///< "domain orientation", "regularity", "C1", "exceptional vertices", …
  Verdict verdict = Verdict::undecided;
  std::string message;  ///< what was found, with ids
};

struct VerifyOptions {
  double c1_tolerance = 1e-11;  ///< on d_ei relative to the extent, plus coordinate rounding
  double conformance_tolerance = 1e-13;  ///< relative to the extent, plus coordinate rounding
  int max_subdivision = 60;              ///< depth of bisection before rationals decide
};

/// Bounds as the result's parameters claim them (`c1_bound`, `conformance_bound`), the defaults
/// where they claim none.
VerifyOptions claimed_bounds(const Result& result);

struct VerifyReport {
  std::vector<VerifyItem> items;
  Metrics metrics;  ///< recomputed from the result alone (`seconds` is empty)

  bool regular() const;  ///< every triangle certified, domain orientation exact
  bool conforming() const;
  bool c1() const;     ///< C1 everywhere but across relaxed edges
  bool valid() const;  ///< every item valid
};

/// Certifies a result from its data alone. Throws nothing for bad geometry: it is reported.
VerifyReport verify(const Result& result, const VerifyOptions& options = {});

/// As above, and that the result's curves are those of `input` (up to the repairs it states).
VerifyReport verify(const Result& result, const Shape& input, const VerifyOptions& options = {});

/// The report for people: one line per item, then the metrics.
std::string report_text(const VerifyReport& report);

}  // namespace c1mesh
