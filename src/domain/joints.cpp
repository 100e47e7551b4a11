// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/joints.h"

#include <cmath>
#include <map>
#include <numbers>

#include "mesh/topology.h"

namespace c1mesh {
namespace {

void classify(Joint& joint, const BoundaryEdge& before, const BoundaryEdge& after, int degree,
              double corner_angle) {
  const double c = cross(joint.d0, joint.d1), d = joint.d0.dot(joint.d1);
  const double square = joint.d0.squaredNorm();
  const bool same_curve = before.curve == after.curve && before.t1 == after.t0 &&
                          (before.t1 - before.t0 > 0) == (after.t1 - after.t0 > 0);
  if (same_curve) {
    joint.kind = JointKind::inside;
    joint.ratio = (after.t1 - after.t0) / (before.t1 - before.t0);
    return;
  }
  joint.turn = std::atan2(c, d);
  joint.ratio = d / square;
  joint.kappa = c / square;
  const double residue = std::abs(c) / std::sqrt(square) / degree;
  if (d > 0 && residue <= 1e-14) {
    joint.kind = JointKind::smooth;
    joint.kappa = joint.turn = 0;
    joint.ratio = joint.d1.norm() / joint.d0.norm();
  } else if (std::abs(joint.turn) * 180 / std::numbers::pi < corner_angle) {
    joint.kind = JointKind::mild;
  } else {
    joint.kind = JointKind::corner;
  }
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
      classify(joint, loop[before], loop[k], n, corner_angle);
      joints[l].push_back(joint);
    }
  }
  return joints;
}

}  // namespace c1mesh
