// SPDX-License-Identifier: GPL-3.0-or-later
// The program's exit statuses.
#pragma once

namespace c1mesh::app {

enum class Status : int {
  ok = 0,            ///< all that was asked holds and was verified
  internal = 1,      ///< our fault, or the output could not be written
  usage = 2,         ///< the command line is wrong
  input = 3,         ///< the input is invalid; nothing was written
  bound_missed = 4,  ///< a valid result that misses a bound that was asked
  limit = 5,         ///< a time or memory limit, or a signal, ended it
};

/// The worse of two statuses of a run over several inputs: what left less behind is worse, an error
/// of ours is worst. Order: ok, bound_missed, limit, input, usage, internal.
inline Status worse(Status a, Status b) {
  constexpr int kBadness[] = {0, 5, 4, 3, 1, 2};
  return kBadness[static_cast<int>(a)] < kBadness[static_cast<int>(b)] ? b : a;
}

}  // namespace c1mesh::app
