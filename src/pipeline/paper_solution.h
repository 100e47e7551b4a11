// SPDX-License-Identifier: GPL-3.0-or-later
// A region solved by the paper's method.
#pragma once

#include "pipeline/ladder.h"

namespace c1mesh {

/// Always valid; a time limit ends the phase that is running.
RegionSolution solve_region_as_paper(const CurvedMesh& initial, const Options& options,
                                     const Checkpoint& checkpoint);

}  // namespace c1mesh
