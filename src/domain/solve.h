// SPDX-License-Identifier: GPL-3.0-or-later
// The domain stage: from a mesh and roles to a valid domain of low distortion, the shape fixed.
#pragma once

#include "domain/energy.h"
#include "domain/minimise.h"
#include "domain/start.h"
#include "domain/unbend.h"

namespace c1mesh {

struct DomainOptions {
  DomainWeights weights;
  int untangle_iterations = 120;
  int newton_iterations = 60;
  double final_exponent = 4;  ///< p-norm that ends the optimisation (1: none)
  UnbendOptions unbend;
  bool no_overlap = false;  ///< a start whose boundary crosses itself is not good enough
  DomainShape warm;         ///< to start from, tried first; empty: none
};

struct DomainReport {
  bool valid = false;  ///< every triangle and wedge positive, wound once
  int crossings = 0;   ///< pairs of crossing boundary edges
  double energy = 0;   ///< the exponent-1 objective reached
  double largest = 0;  ///< the largest element energy
  int untangle_iterations = 0, newton_iterations = 0;
  std::vector<int> inverted;  ///< vertices of inverted elements, or wound wrongly
};

/// The domain's state: what the joint stage starts from.
struct DomainState {
  Roles roles;
  DomainLayout layout;
  PointMatrix unknowns;
};

/// Tries the starts in order and keeps the first valid result without crossings, else the best: the
/// warm one, the shape, the unbent one (kept apart, then not), the convex one. An observer is told
/// of the places of the mesh's vertices (x and y interleaved), valid or not.
DomainState solve_domain(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                         const DomainOptions& options, DomainReport& report,
                         const Checkpoint& checkpoint);

/// Scales and centres the unknowns so that the domain's area is the shape's.
void normalise_domain(const CurvedMesh& mesh, const DomainLayout& layout, PointMatrix& unknowns);

}  // namespace c1mesh
