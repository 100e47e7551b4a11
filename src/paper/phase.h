// SPDX-License-Identifier: GPL-3.0-or-later
// One phase's optimisation: Newton on the objective of problem (4.6) while the norms' smoothing
// falls (paper, section 5.1).
#pragma once

#include "linear/checkpoint.h"
#include "paper/paper_objective.h"

namespace c1mesh {

struct PhaseOptions {
  PaperWeights weights;      ///< the smoothing is set by the phase
  double smoothing[2] = {};  ///< first and last, in the normalised frame
  int iterations = 0;        ///< at most
  bool domain_free = false;
  bool no_overlap = false;  ///< the boundary of a free domain, without crossings, stays so
};

/// Told of every iteration: the objective, its variables and the step length.
using PhaseObserver = std::function<void(const PaperObjective&, const Eigen::VectorXd&, double)>;

/// Lowers the objective from `state`, which stays regular with g below the bound. `state` is the
/// last one reached if `checkpoint` throws, too.
void run_phase(const CurvedMesh& initial, const AskedEdges& asked, const PhaseOptions& options,
               Pair& state, const Checkpoint& checkpoint, const PhaseObserver& observer);

}  // namespace c1mesh
