// SPDX-License-Identifier: GPL-3.0-or-later
// An independent look at a result: nothing here is shared with the code that made it.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "c1mesh/certificate.h"
#include "c1mesh/result.h"
#include "c1mesh/shape.h"

namespace c1mesh {

/// Bounds that a result is held to.
struct VerifyOptions {
  double c1_tolerance = 1e-11;  ///< on d_ei relative to the extent, plus coordinate rounding
  /// Where finite, instead of that: every d_ei relative to the extent, and nothing for rounding.
  double c1_bound = std::numeric_limits<double>::infinity();
  double conformance_tolerance = 1e-13;  ///< relative to the extent, plus coordinate rounding
  int max_subdivision = 60;              ///< depth of bisection before rationals decide
};

/// Bounds as the result's parameters claim them (`c1_bound`, `conformance_bound`), the defaults
/// where they claim none.
VerifyOptions claimed_bounds(const Result& result);

/// What the spreads of the metrics are taken of; lengths relative to the extent.
struct Samples {
  std::vector<double> d_ei;  ///< every equation of every edge where C1 is asked
  /// For each such edge, the largest of ten equidistant points, ends included.
  std::vector<double> gradient_angle_deg, gradient_magnitude;
  /// For each control point on boundary or features, by id: the distance from its exact place.
  std::vector<double> conformance;
};

/// What a verification found.
struct VerifyReport {
  std::vector<VerifyItem> items;  ///< every check that was made
  Metrics metrics;                ///< recomputed from the result alone (`seconds` is empty)
  Samples samples;                ///< what the metrics sum up
  Certificate certificate;        ///< what was proven and how

  /// Every triangle certified, domain orientation exact.
  bool regular() const;
  /// The boundary is that of the curves, within the tolerance.
  bool conforming() const;
  /// C1 everywhere but across relaxed edges.
  bool c1() const;
  /// Every item valid.
  bool valid() const;
};

/// Certifies a result from its data alone. Throws nothing for bad geometry: it is reported.
VerifyReport verify(const Result& result, const VerifyOptions& options = {});

/// As above, and that the result's curves are those of `input` (up to the repairs it states).
VerifyReport verify(const Result& result, const Shape& input, const VerifyOptions& options = {});

/// Checks `certificate` instead of searching for proofs: each of its proofs must hold of `result`,
/// and each of its bounds. Adds an item "certificate".
VerifyReport recheck(const Result& result, const Certificate& certificate,
                     const VerifyOptions& options = {});

/// The report for people: one line per item, then the metrics.
std::string report_text(const VerifyReport& report);

}  // namespace c1mesh
