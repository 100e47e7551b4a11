// SPDX-License-Identifier: GPL-3.0-or-later
// A region solved by the paper's method.
#pragma once

#include "c1mesh/trace.h"
#include "pipeline/ladder.h"

namespace c1mesh {

/// Always valid; after a time limit the initial mesh, or the last pass that was finished.
RegionSolution solve_region_as_paper(const CurvedMesh& initial, const Options& options, int region,
                                     const Checkpoint& checkpoint, const Trace& trace);

}  // namespace c1mesh
