// SPDX-License-Identifier: GPL-3.0-or-later
// One try at a region: domain stage, joint stage, exact stage, for given roles and weights.
#pragma once

#include <vector>

#include "optimise/stages.h"

namespace c1mesh {

struct AttemptOptions {
  DomainOptions domain;
  JointOptions joint;
  ExactOptions exact;
  bool no_overlap = false;  ///< a map over a domain that overlaps itself is no success
};

/// What one try reached.
struct Attempt {
  bool domain_valid = false;
  bool success = false;  ///< exactly C1 where asked, regular
  int crossings = 0;     ///< of the domain's boundary
  double energy = 0;     ///< of the domain stage
  double g = 0;          ///< largest g(t), if success
  Roles roles;
  DomainShape domain;        ///< as the map has it
  DomainShape domain_stage;  ///< what the domain stage left, if valid: a start for other tries
  std::vector<Point> control;
  std::vector<int> trouble;  ///< vertices where it failed, or of the triangle with the largest g
};

Attempt attempt_region(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                       const AttemptOptions& options, const Checkpoint& checkpoint);

/// The same without a domain stage: the mesh's own domain as it is, every boundary vertex
/// exceptional. Succeeds unless the interior itself resists.
Attempt attempt_on_initial_domain(const CurvedMesh& mesh, const Joints& joints,
                                  const ExactOptions& options, const Checkpoint& checkpoint);

}  // namespace c1mesh
