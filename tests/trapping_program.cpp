// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into the program where C1MESH_TRAP_FLOATS is set, for the tests that run it.
#include "base/float_traps.h"

namespace {

// Before main(), hence before any thread.
const bool kTrapped = (c1mesh::trap_floats(), true);

}  // namespace
