// SPDX-License-Identifier: GPL-3.0-or-later
// How the domain's vertices depend on its free unknowns: chains flat and with the right fractions
// by construction (docs/method.md, "chains").
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "domain/joints.h"
#include "mesh/curved_mesh.h"

namespace c1mesh {

/// What the domain does at a vertex on boundary or features.
enum class Role {
  flat,         ///< interior angle exactly pi, edge lengths in the ratio of the derivatives
  bent,         ///< a mild joint within a chain: turns by kappa w, w a free vector
  anchor,       ///< ends a chain, C1: a corner, a mild joint with a free vertex, a dangling end
  exceptional,  ///< ends a chain, C1 given up, as a corner the loop's polygon needs
  released,     ///< ends a chain, C1 given up because keeping it failed
  branch,       ///< ends chains, C1 given up: three or more curves meet
};

/// Is C1 given up at a vertex of this role? (All such are exceptional vertices of the result.)
inline bool gives_up_c1(Role role) {
  return role == Role::exceptional || role == Role::released || role == Role::branch;
}
inline bool ends_chain(Role role) {
  return role == Role::anchor || gives_up_c1(role);
}

/// roles[loop][position], aligned with Joints.
using Roles = std::vector<std::vector<Role>>;

/// The roles that keep everything C1 but at branch points: corners and distinctly turning joints
/// (|kappa| above `bent_limit`) are anchors, slighter ones bent, the rest flat.
Roles natural_roles(const Joints& joints, double bent_limit = 1e-2);

/// Carries roles to a refined mesh: by vertex id, new vertices flat.
Roles roles_on(const Joints& from, const Roles& roles, const Joints& to);

/// The rows of two auxiliary points at a mild joint v: v + e0 and v + w, with e0 the incoming
/// domain edge and w the vector of e1 = r e0 + kappa w. Over them the joint's gradient is well
/// conditioned however slight the turn: it maps (e0, w) to (d0, J d0).
struct Tips {
  int along = -1, across = -1;
};

/// points = exact * unknowns, for x and y alike. Rows: the mesh's vertices, then the tips of the
/// mild joints. Unknowns: interior vertices, chain ends, the vectors w of bent joints.
struct DomainLayout {
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  Matrix exact;                     ///< the positions
  Matrix sparse;                    ///< without far, tiny entries of w: for Hessians only
  std::vector<int> unknown_of_row;  ///< per vertex: the unknown it is equal to, or -1 in a chain
  std::vector<std::vector<Tips>> tips;         ///< [loop][position]; -1 where there are none
  std::vector<std::vector<int>> bend_unknown;  ///< [loop][position]: the unknown w, or -1

  int rows() const { return static_cast<int>(exact.rows()); }
  int unknowns() const { return static_cast<int>(exact.cols()); }
};

/// Precondition: every loop and closed feature has at least two chain ends (three for a valid
/// polygon).
DomainLayout make_layout(const CurvedMesh& mesh, const Joints& joints, const Roles& roles);

}  // namespace c1mesh
