// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that are far from any polygon of few corners: teeth, branches, turns.
#pragma once

#include <vector>

#include "domain/energy.h"
#include "domain/exceptional.h"
#include "mesh/shapes.h"

namespace c1mesh::test {

/// The polygon with every corner rounded: all joints smooth, curves and sides alternate. Curves
/// begin `share` of the shorter side away from the corner.
std::vector<BezierCurve> rounded(const std::vector<Point>& corners, double share);

/// Teeth upwards from a spine.
std::vector<Point> comb(int teeth);

/// A trunk with `levels` of branches to both sides, each with a twig upwards.
std::vector<Point> tree(int levels);

/// A region on its way to the domain stage: the fewest exceptional vertices, placed by curvature.
struct Stage {
  CurvedMesh mesh;
  Joints joints;
  Roles roles;
  DomainLayout layout;
  DomainElements elements;
};
Stage stage_of(const std::vector<std::vector<BezierCurve>>& loops);

}  // namespace c1mesh::test
