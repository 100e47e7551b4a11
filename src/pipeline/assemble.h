// SPDX-License-Identifier: GPL-3.0-or-later
// From the regions' maps in the normalised frame to one Result in the input's units.
#pragma once

#include "c1mesh/options.h"
#include "c1mesh/result.h"
#include "c1mesh/shape.h"
#include "pipeline/ladder.h"

namespace c1mesh {

/// Control points on boundary and features are the exact restrictions of the input curves, rounded
/// once.
Result assemble_result(const Shape& shape, const std::vector<RegionSolution>& regions,
                       const Options& options, int degree);

}  // namespace c1mesh
