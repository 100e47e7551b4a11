// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into every test program: tests run with floating-point traps on, so that a NaN or a
// division by zero outside the places that mean it (FloatTrapsOff) ends the test.
#include <gtest/gtest.h>

#include "base/float_traps.h"

namespace {

class TrappedFloats : public testing::Environment {
  void SetUp() override { c1mesh::trap_floats(); }
};

// gtest_main's main() is not ours: an environment that is added before it starts is set up by it.
const testing::Environment* const kTraps =
    testing::AddGlobalTestEnvironment(new TrappedFloats);  // owned by the framework

}  // namespace
