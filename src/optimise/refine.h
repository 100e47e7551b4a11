// SPDX-License-Identifier: GPL-3.0-or-later
// Local refinement of an exactly C1 map where its distortion is large.
#pragma once

#include "optimise/attempt.h"

namespace c1mesh {

struct RefineOptions {
  double target = 20;  ///< g to stop at
  double growth = 2;   ///< at most so many times the triangles
  int rounds = 12;
};

/// Bisects the triangles whose g exceeds the target, the worst first: the map stays the same and
/// its bounds n_i, d_k become sharper; then lowers the distortion with the unknowns gained
/// (lower_distortion). Exactly C1 as before; only the far half of a relaxed edge that was cut is
/// asked anew, for which the map moves a little. g never rises; the target may be out of reach.
/// `mesh` and `joints` are those of `attempt`, a success, and are replaced with it; mesh.domain
/// becomes the map's.
void refine_where_distorted(const RefineOptions& options, const ExactOptions& exact,
                            CurvedMesh& mesh, Joints& joints, Attempt& attempt,
                            const Checkpoint& checkpoint);

}  // namespace c1mesh
