// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/joints.h"

#include <cmath>
#include <map>
#include <numbers>

#include "c1mesh/cost.h"
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

struct Path {
  const std::vector<BoundaryEdge>* edges;
  bool closed, feature;
};

std::vector<Path> paths_of(const CurvedMesh& mesh) {
  std::vector<Path> out;
  for (const auto& loop : mesh.loops) out.push_back({&loop, true, false});
  for (const FeatureLine& line : mesh.features) out.push_back({&line.edges, line.closed, true});
  return out;
}

// How many edges on curves end in each vertex.
std::vector<int> curve_edges(const CurvedMesh& mesh) {
  std::vector<int> count(mesh.vertex_count(), 0);
  for (const Path& path : paths_of(mesh))
    for (const BoundaryEdge& edge : *path.edges) ++count[edge.a], ++count[edge.b];
  return count;
}

// kind_of(joint) decides what cannot be seen from the mesh alone.
template <class KindOf>
Joints joints_of(const CurvedMesh& mesh, const KindOf& kind_of) {
  const auto control = boundary_control(mesh);
  const std::vector<Path> paths = paths_of(mesh);
  const std::vector<int> meeting = curve_edges(mesh);
  const int n = mesh.degree;
  Joints joints(paths.size());
  for (std::size_t l = 0; l < paths.size(); ++l) {
    const auto& edges = *paths[l].edges;
    const int m = static_cast<int>(edges.size());
    for (int k = 0; k < m + !paths[l].closed; ++k) {
      Joint joint;
      joint.vertex = k < m ? edges[k].a : edges[m - 1].b;
      joint.loop = static_cast<int>(l);
      joint.position = k;
      joint.feature = paths[l].feature;
      joint.branch = meeting[joint.vertex] > 2;
      const bool first = !paths[l].closed && k == 0, last = k == m;
      const int before = (k + m - 1) % m;
      if (!first) {
        const auto& in = control[l][before];
        joint.previous = edges[before].a;
        joint.d0 = n * (mesh.control[in[n]] - mesh.control[in[n - 1]]);
      }
      if (!last) {
        const auto& out = control[l][k];
        joint.next = edges[k].b;
        joint.d1 = n * (mesh.control[out[1]] - mesh.control[out[0]]);
      }
      if (first || last) {
        joint.kind = JointKind::end;
        (first ? joint.d0 : joint.d1) = Point::Zero();
      } else {
        joint.kind = same_curve(edges[before], edges[k]) ? JointKind::inside : kind_of(joint);
        measure(joint, edges[before], edges[k]);
      }
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
  for (const Path& path : paths_of(mesh)) {
    out.emplace_back();
    for (const BoundaryEdge& edge : *path.edges) {
      const auto side = sides.at({edge.a, edge.b});
      out.back().push_back(edge_controls(mesh, side.first, (side.second + 2) % 3));
    }
  }
  return out;
}

Joints find_joints(const CurvedMesh& mesh, double corner_angle) {
  const StageTimer timer("map: joints");
  return joints_of(mesh,
                   [&](const Joint& joint) { return classify(joint, mesh.degree, corner_angle); });
}

Joints find_joints_again(const CurvedMesh& mesh, const Joints& before) {
  const StageTimer timer("map: joints");
  std::vector<std::map<int, JointKind>> kinds(
      before.size());  // per path: a branch point is in several
  for (const auto& path : before)
    for (const Joint& joint : path) kinds[joint.loop][joint.vertex] = joint.kind;
  return joints_of(mesh, [&](const Joint& joint) { return kinds[joint.loop].at(joint.vertex); });
}

}  // namespace c1mesh
