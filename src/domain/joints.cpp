// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/joints.h"

#include <cmath>
#include <map>
#include <numbers>

#include "mesh/topology.h"

namespace c1mesh {
namespace {

bool same_curve(const BoundaryEdge& before, const BoundaryEdge& after) {
  return before.curve == after.curve && before.t1 == after.t0 &&
         (before.t1 - before.t0 > 0) == (after.t1 - after.t0 > 0);
}

// Turn, ratio and kappa from the derivatives, for the joint's kind.
void measure(Joint& joint, const BoundaryEdge& before, const BoundaryEdge& after) {
  const double c = cross(joint.d0, joint.d1), d = joint.d0.dot(joint.d1);
  joint.turn = joint.kappa = 0;
  if (joint.kind == JointKind::inside) {
    joint.ratio = (after.t1 - after.t0) / (before.t1 - before.t0);
  } else if (joint.kind == JointKind::smooth) {
    joint.ratio = joint.d1.norm() / joint.d0.norm();
  } else {
    joint.turn = std::atan2(c, d);
    joint.ratio = d / joint.d0.squaredNorm();
    joint.kappa = c / joint.d0.squaredNorm();
  }
}

JointKind classify(const Joint& joint, int degree, double corner_angle) {
  const double c = cross(joint.d0, joint.d1), d = joint.d0.dot(joint.d1);
  const double residue = std::abs(c) / joint.d0.norm() / degree;
  if (d > 0 && residue <= 1e-14) return JointKind::smooth;
  const double turn = std::abs(std::atan2(c, d)) * 180 / std::numbers::pi;
  return turn < corner_angle ? JointKind::mild : JointKind::corner;
}

// kind_of(joint, edge before, edge after) decides what cannot be seen from the mesh alone.
template <class KindOf>
Joints joints_of(const CurvedMesh& mesh, const KindOf& kind_of) {
  const auto control = boundary_control(mesh);
  const int n = mesh.degree;
  Joints joints(mesh.loops.size());
  for (std::size_t l = 0; l < mesh.loops.size(); ++l) {
    const auto& loop = mesh.loops[l];
    const int m = static_cast<int>(loop.size());
    for (int k = 0; k < m; ++k) {
      const int before = (k + m - 1) % m;
      const auto &in = control[l][before], &out = control[l][k];
      Joint joint;
      joint.vertex = loop[k].a;
      joint.loop = static_cast<int>(l);
      joint.position = k;
      joint.d0 = n * (mesh.control[in[n]] - mesh.control[in[n - 1]]);
      joint.d1 = n * (mesh.control[out[1]] - mesh.control[out[0]]);
      joint.kind = same_curve(loop[before], loop[k]) ? JointKind::inside : kind_of(joint);
      measure(joint, loop[before], loop[k]);
      joints[l].push_back(joint);
    }
  }
  return joints;
}

}  // namespace

std::vector<std::vector<std::vector<int>>> boundary_control(const CurvedMesh& mesh) {
  std::map<std::pair<int, int>, std::pair<int, int>> sides;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      sides[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] = {t, k};
  std::vector<std::vector<std::vector<int>>> out;
  for (const auto& loop : mesh.loops) {
    out.emplace_back();
    for (const BoundaryEdge& edge : loop) {
      const auto side = sides.at({edge.a, edge.b});
      out.back().push_back(edge_controls(mesh, side.first, (side.second + 2) % 3));
    }
  }
  return out;
}

Joints find_joints(const CurvedMesh& mesh, double corner_angle) {
  return joints_of(mesh,
                   [&](const Joint& joint) { return classify(joint, mesh.degree, corner_angle); });
}

Joints find_joints_again(const CurvedMesh& mesh, const Joints& before) {
  std::map<int, JointKind> kinds;
  for (const auto& loop : before)
    for (const Joint& joint : loop) kinds[joint.vertex] = joint.kind;
  return joints_of(mesh, [&](const Joint& joint) { return kinds.at(joint.vertex); });
}

}  // namespace c1mesh
