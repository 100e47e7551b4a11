// SPDX-License-Identifier: GPL-3.0-or-later
// Joint optimisation of domain and shape, and the exact stage that follows it.
#pragma once

#include <vector>

#include "domain/solve.h"
#include "optimise/map_objective.h"

namespace c1mesh {

/// The edges across which C1 is asked: all interior ones that are neither features nor have an
/// exceptional end.
std::vector<C1Edge> asked_edges(const CurvedMesh& mesh, const Joints& joints, const Roles& roles);

/// Those, and the equations of the mild joints' tips, whose auxiliary control points are appended
/// to `control` (see joint_equations).
std::vector<C1Edge> asked_equations(const CurvedMesh& mesh, const Joints& joints,
                                    const Roles& roles, const DomainLayout& layout,
                                    std::vector<Point>& control);

struct JointOptions {
  double rho = 1000;          ///< C1 penalty, relative to the shape's area
  double domain_quality = 1;  ///< weight that keeps domain triangles near the domain stage's
  int iterations = 25;
  double exponent = 1;
  bool no_overlap = false;  ///< the boundary of the domain, free of crossings, stays so
};

struct JointReport {
  int iterations = 0;
  double energy = 0;
  double residue = 0;  ///< largest d_ei
};

/// Newton on both halves of the map. The domain stays valid, det J stays positive.
JointReport optimise_jointly(const CurvedMesh& mesh, const DomainLayout& layout,
                             const std::vector<C1Edge>& asked, const DomainElements& elements,
                             const JointOptions& options, MapState& state,
                             const Checkpoint& checkpoint);

struct ExactOptions {
  double first_rho = 1e2, last_rho = 1e7;  ///< frozen continuation, tenfold each time
  int iterations = 12;                     ///< Newton steps for each rho
  int multiplier_rounds = 12;
  double exponent = 1;
  double good_enough = 20;        ///< g above which the p-norms below are worth their time
  double final_exponent = 8;      ///< p-norms 4, 8, … up to this lower the largest g
  double give_up_residue = 1e-3;  ///< residue at the end of the continuation: no hope
};

/// A residue the doubles cannot be asked to beat: rounding of coordinates of size one.
inline constexpr double kExact = 2e-13;

struct ExactReport {
  int iterations = 0;
  double residue = 0;        ///< after the continuation
  double final_residue = 0;  ///< after the projection
  bool success = false;      ///< C1 to rounding, every Bernstein coefficient of det J positive
  std::vector<int> trouble;  ///< mesh vertices where it failed, worst first
};

/// Freezes the domain, drives the C1 residue to zero by a growing penalty and multipliers over the
/// control points alone, then projects exactly. On failure `state` is what the continuation
/// reached.
ExactReport make_exact(const CurvedMesh& mesh, const DomainLayout& layout,
                       const std::vector<C1Edge>& asked, const ExactOptions& options,
                       MapState& state, const Checkpoint& checkpoint);

/// Lowers the largest distortion inside the C1 space, the domain frozen: p-norms 4, 8, … of the
/// triangles' energies. `state` is exact before and after; false if nothing better was found.
bool lower_distortion(const CurvedMesh& mesh, const DomainLayout& layout,
                      const std::vector<C1Edge>& asked, const ExactOptions& options,
                      MapState& state, const Checkpoint& checkpoint);

/// The least move of the free control points after which every equation holds to rounding; the
/// largest residue left.
double project_exactly(const CurvedMesh& mesh, const DomainLayout& layout,
                       const std::vector<C1Edge>& asked, MapState& state);

/// g(t) of every triangle (eq. 4.5); infinite where a Bernstein coefficient is not positive.
std::vector<double> distortion_bounds(const CurvedMesh& mesh, const PointMatrix& domain,
                                      const std::vector<Point>& control);

}  // namespace c1mesh
