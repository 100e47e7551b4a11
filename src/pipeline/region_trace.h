// SPDX-License-Identifier: GPL-3.0-or-later
// One region's part of a trace.
#pragma once

#include "c1mesh/trace.h"

namespace c1mesh {

/// Sets the region of each record and counts the iterations, from 1 wherever the stage or the pass
/// is another than before. Empty if `trace` is.
Trace trace_of_region(const Trace& trace, int region);

}  // namespace c1mesh
