// SPDX-License-Identifier: GPL-3.0-or-later
// det J > 0 on every closed triangle, and |J|^2 / det J from above, proven.
#pragma once

#include <vector>

#include "verify/checks.h"

namespace c1mesh::verification {

/// One triangle: the proof, and what follows from the Bernstein coefficients without any split.
struct TriangleFinding {
  Verdict regular = Verdict::undecided;
  TriangleProof proof;
  bool record_holds = true;      ///< the given proof, if one is, proves what it says
  double most_distortion = 0;    ///< not below g(t) = max n_i / min d_i (eq. 4.5); may be infinite
  double least_coefficient = 0;  ///< not above any Bernstein coefficient of det J
};

/// A search for each triangle, or what the certificate that is followed says of it.
std::vector<TriangleFinding> examine_triangles(const Subject& subject);

}  // namespace c1mesh::verification
