// SPDX-License-Identifier: GPL-3.0-or-later
// Exceptional point determination (paper, section 4.3, figure 11): near-flat domain vertices are
// made flat, by recursive straightening.
#pragma once

#include <vector>

#include "c1mesh/options.h"
#include "domain/joints.h"
#include "paper/paper_objective.h"

namespace c1mesh {

struct StraightenOptions {
  double bound = 3000;  ///< on g of eq. (4.5)
  Straightening how = Straightening::orthogonal;
  bool no_overlap = false;
};

struct Straightened {
  PointMatrix domain;
  std::vector<char> corner;  ///< per vertex on a curve: an end of straight runs
  double largest_move = 0;   ///< of a vertex, relative to the extent of the domain
  int restored = 0;          ///< how often a straightening was undone
};

/// Does the shape itself have a corner there, so that the domain may have one too and stay C1?
/// Turns that C1 over a flat vertex survives to `kNegligibleTurn` are none.
bool is_shape_corner(const Joint& joint);
inline constexpr double kNegligibleTurn = 1e-6;  // radians

/// Marks the corners of the shape, and of each loop the sharpest three vertices if there are fewer.
/// Then each run between two marked ones is put on its line; where a triangle would become inverted
/// or exceed the bound, or the boundary cross itself where that is excluded, it is restored and its
/// sharpest vertex marked too.
Straightened straighten(const CurvedMesh& initial, const Joints& joints, const Pair& state,
                        const StraightenOptions& options);

/// The corners over which C1 is given up: those at smooth joints, branch points, and those of the
/// shape that are convex where the domain is reflex, or the other way round, or flat there.
std::vector<char> exceptional_corners(const CurvedMesh& initial, const Joints& joints,
                                      const Straightened& straightened);

}  // namespace c1mesh
