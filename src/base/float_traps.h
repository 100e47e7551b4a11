// SPDX-License-Identifier: GPL-3.0-or-later
// Traps of the floating-point unit: with them on, an operation that makes a NaN out of numbers, or
// an infinity by division or overflow, ends the process with SIGFPE where it happens. Off unless
// asked for; the tests ask, and the program if built with C1MESH_TRAP_FLOATS. Where the C library
// has no traps (others than glibc) all this does nothing.
#pragma once

#include <cfenv>

namespace c1mesh {

/// What a trap is set for. Not underflow, nor what is inexact: both are everyday.
inline constexpr int kTrappedFloats = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

/// From here on in this thread. Threads and arenas of TBB take the setting over from the thread
/// that makes them, so the call belongs before the first parallel loop.
inline void trap_floats() {
#ifdef __GLIBC__
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(kTrappedFloats);
#endif
}

/// For a scope in which such an operation is meant, or is another library's business: no traps in
/// this thread, the former ones at its end. It does not reach into the tasks of a parallel loop
/// within the scope, which run with the settings of their arena.
class FloatTrapsOff {
 public:
#ifdef __GLIBC__
  FloatTrapsOff() : former_(fedisableexcept(kTrappedFloats)) {}
  ~FloatTrapsOff() {
    if (former_ <= 0) return;
    // A flag raised meanwhile would be taken for a new exception by the x87 unit.
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(former_);
  }
#else
  FloatTrapsOff() = default;
  ~FloatTrapsOff() {}
#endif
  FloatTrapsOff(const FloatTrapsOff&) = delete;
  FloatTrapsOff& operator=(const FloatTrapsOff&) = delete;

 private:
#ifdef __GLIBC__
  int former_;
#endif
};

}  // namespace c1mesh
