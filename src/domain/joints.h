// SPDX-License-Identifier: GPL-3.0-or-later
// What the shape's curves do at each vertex of the mesh on boundary or features.
#pragma once

#include <vector>

#include "mesh/curved_mesh.h"

namespace c1mesh {

enum class JointKind {
  inside,  ///< within a curve: smooth, and the derivative ratio is the ratio of parameter lengths
  smooth,  ///< two curves, tangents agree to rounding
  mild,    ///< turns by less than the corner angle
  corner,  ///< turns by more
  end,     ///< where an open feature ends: at a branch point, or dangling
};

/// One vertex on a path, a loop or a feature, between the path's edges `before` and `after`.
struct Joint {
  int vertex = -1;
  int loop = -1,
      position = -1;  ///< of the path; position = index of the edge that leaves the vertex
  int previous = -1, next = -1;  ///< the path's vertices before and after; -1 beyond an end
  bool feature = false;          ///< the path is a feature
  bool branch = false;           ///< three or more edges on curves meet here
  JointKind kind = JointKind::inside;
  Point d0, d1;      ///< n (p_n - p_(n-1)) into and n (p_1 - p_0) out of the vertex
  double ratio = 1;  ///< r = d0.d1 / |d0|^2; inside a curve exactly the parameter ratio
  double kappa = 0;  ///< cross(d0, d1) / |d0|^2: d1 = r d0 + kappa J d0; 0 unless mild or corner
  double turn = 0;   ///< signed turning angle, radians, positive to the left
  bool convex() const { return turn > 0; }
};

/// joints[path][position]: first the loops, then the features. A loop or closed feature has as many
/// joints as edges, an open feature one more. A branch point is in several paths.
using Joints = std::vector<std::vector<Joint>>;

/// Classifies by the control points of the mesh; `corner_angle` in degrees. A joint counts as
/// smooth when treating it as flat leaves a C1 residue |d1 - r d0| under 1e-14 of the extent.
Joints find_joints(const CurvedMesh& mesh, double corner_angle);

/// The joints of a mesh refined from one with joints `before`: boundary vertices of that one keep
/// their kind (as edges get shorter a slight turn would seem to vanish), new ones are inside
/// curves.
Joints find_joints_again(const CurvedMesh& mesh, const Joints& before);

/// For each path (loops, then features) and edge: ids of the n+1 control points along the edge,
/// first to last.
std::vector<std::vector<std::vector<int>>> boundary_control(const CurvedMesh& mesh);

}  // namespace c1mesh
