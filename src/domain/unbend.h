// SPDX-License-Identifier: GPL-3.0-or-later
// A domain from the initial one by continuity: the chains are unbent while every triangle stays
// positive, every vertex wound once and the boundary free of crossings (docs/method.md).
#pragma once

#include <numbers>

#include "domain/energy.h"
#include "domain/layout.h"
#include "linear/newton.h"

namespace c1mesh {

struct UnbendOptions {
  int stages = 12;                           ///< from the initial turns to the layout's, at least
  double stage_turn = std::numbers::pi / 4;  ///< what a stage may turn a chain's end by, radians
  int iterations = 3;                        ///< Newton steps in each stage or round
  int rounds = 25;                           ///< multiplier updates, at most
  bool apart =
      true;  ///< keep the boundary from crossing itself; false: only every triangle positive
  double loose = 10;    ///< stiffness of the turns on their way, relative to a mean triangle
  double tight = 2560;  ///< of the turns at the layout's
  double most = 1e5;    ///< of the layout's positions, at most
};

struct UnbendReport {
  int iterations = 0;
  double residue = 0;  ///< largest distance to the layout's positions, relative to the edges there
  bool reached = false;  ///< the unknowns are valid, and were all the way
};

/// Values of the layout's unknowns; valid if the report says `reached`, else a start to untangle.
/// `elements` as for the layout. Positions on the way are bound to no chain.
PointMatrix unbend_domain(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                          const DomainLayout& layout, const DomainElements& elements,
                          const UnbendOptions& options, UnbendReport& report,
                          const Checkpoint& checkpoint);

}  // namespace c1mesh
