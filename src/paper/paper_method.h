// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's method for one region (sections 4.3, 5.1, 5.5): phase one, exceptional points, phase
// two, as often as asked.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "c1mesh/options.h"
#include "linear/checkpoint.h"
#include "paper/straighten.h"

namespace c1mesh {

/// Interior edges beside a warped triangle are soft, the others hard. Those with an end in
/// `exceptional` are left out, hard ones too (docs/paper.md), and so are features.
AskedEdges classify_edges(const CurvedMesh& initial, const std::vector<char>& exceptional);

struct PaperSolution {
  /// Regular. g is within the lifted bound, unless that leaves the barrier's smooth bound no
  /// room after phase one.
  Pair state;
  std::vector<char> exceptional;  ///< per vertex
  std::vector<std::array<int, 2>> relaxed;
  std::vector<std::string> notes;
  bool interrupted = false;  ///< the time limit ended it early
};

/// Lengths in the normalised frame. A TimeLimitReached of `checkpoint` ends the phase, whose state
/// is straightened if that is still to do; anything else it throws is passed on.
PaperSolution run_paper_method(const CurvedMesh& initial, const Joints& joints,
                               const Options& options, const Checkpoint& checkpoint);

}  // namespace c1mesh
