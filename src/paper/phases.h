// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's method for one region (sections 4.3, 5.1, 5.5): phase one, exceptional points, phase
// two, as often as asked.
#pragma once

#include <array>
#include <vector>

#include "c1mesh/options.h"
#include "c1mesh/trace.h"
#include "paper/straighten.h"

namespace c1mesh {

/// Interior edges beside a warped triangle are soft, the others hard; soft ones with an end in
/// `exceptional` are left out, features always.
AskedEdges classify_edges(const CurvedMesh& initial, const std::vector<char>& exceptional);

struct PaperSolution {
  Pair state;                     ///< regular, g within the lifted bound
  std::vector<char> exceptional;  ///< per vertex
  std::vector<std::array<int, 2>> relaxed;
  double bound = 0;  ///< on g, in phase two
  std::vector<std::string> notes;
};

/// Throws what `checkpoint` throws.
PaperSolution run_paper_method(const CurvedMesh& initial, const Joints& joints,
                               const Options& options, int region, const Checkpoint& checkpoint,
                               const Trace& trace);

}  // namespace c1mesh
