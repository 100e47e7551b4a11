// SPDX-License-Identifier: GPL-3.0-or-later
// What the shape's boundary does at each boundary vertex of the mesh.
#pragma once

#include <vector>

#include "mesh/curved_mesh.h"

namespace c1mesh {

enum class JointKind {
  inside,  ///< within a curve: smooth, and the derivative ratio is the ratio of parameter lengths
  smooth,  ///< two curves, tangents agree to rounding
  mild,    ///< turns by less than the corner angle
  corner,  ///< turns by more
};

/// One boundary vertex, between the loop's edges `before` and `after`.
struct Joint {
  int vertex = -1;
  int loop = -1, position = -1;  ///< position = index of the edge that leaves the vertex
  JointKind kind = JointKind::inside;
  Point d0, d1;      ///< n (p_n - p_(n-1)) into and n (p_1 - p_0) out of the vertex
  double ratio = 1;  ///< r = d0.d1 / |d0|^2; inside a curve exactly the parameter ratio
  double kappa = 0;  ///< cross(d0, d1) / |d0|^2: d1 = r d0 + kappa J d0; 0 unless mild or corner
  double turn = 0;   ///< signed turning angle, radians, positive to the left
  bool convex() const { return turn > 0; }
};

/// joints[loop][position] for every boundary vertex.
using Joints = std::vector<std::vector<Joint>>;

/// Classifies by the control points of the mesh; `corner_angle` in degrees. A joint counts as
/// smooth when treating it as flat leaves a C1 residue |d1 - r d0| under 1e-14 of the extent.
Joints find_joints(const CurvedMesh& mesh, double corner_angle);

/// The joints of a mesh refined from one with joints `before`: boundary vertices of that one keep
/// their kind (as edges get shorter a slight turn would seem to vanish), new ones are inside
/// curves.
Joints find_joints_again(const CurvedMesh& mesh, const Joints& before);

/// For each loop and position: ids of the n+1 control points along the edge, first to last.
std::vector<std::vector<std::vector<int>>> boundary_control(const CurvedMesh& mesh);

}  // namespace c1mesh
