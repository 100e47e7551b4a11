// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/demotion.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "mesh/split.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

// What giving up a vertex is worth, as a factor on its distance: a smooth vertex must be much
// nearer than a corner to be chosen, because it adds a corner to the domain.
double reluctance(const Joint& joint, Role role) {
  if (role == Role::flat) return 8;
  if (joint.kind == JointKind::corner) return joint.convex() == (joint.loop == 0) ? 2 : 1;
  return 1;
}

// From the last to the first, so that earlier indices still fit.
void split_feature_edges_at(CurvedMesh& mesh, int vertex) {
  for (std::size_t f = 0; f < mesh.features.size(); ++f)
    for (int k = static_cast<int>(mesh.features[f].edges.size()) - 1; k >= 0; --k) {
      const BoundaryEdge& e = mesh.features[f].edges[k];
      if (e.a == vertex || e.b == vertex) split_feature_edge(mesh, static_cast<int>(f), k);
    }
}

}  // namespace

int demote_near(const CurvedMesh& mesh, const Joints& joints, const std::vector<int>& trouble,
                int count, Roles& roles) {
  // (distance, loop, position), so that ties are settled the same way every time.
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      if (gives_up_c1(roles[l][k])) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (int v : trouble)
        nearest =
            std::min(nearest, (mesh.domain[v] - mesh.domain[joints[l][k].vertex]).norm() + 1e-3);
      order.emplace_back(nearest * reluctance(joints[l][k], roles[l][k]), l, k);
    }
  std::sort(order.begin(), order.end());
  const int changed = std::min(count, static_cast<int>(order.size()));
  for (int i = 0; i < changed; ++i)
    roles[std::get<1>(order[i])][std::get<2>(order[i])] = Role::released;
  return changed;
}

void grade_corners(CurvedMesh& mesh, const Joints& joints, const Roles& roles, int levels) {
  std::vector<int> corners;
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (joints[l][k].kind == JointKind::corner && roles[l][k] == Role::anchor)
        corners.push_back(joints[l][k].vertex);
  for (; levels > 0; --levels)
    for (const int corner : corners) {
      split_feature_edges_at(mesh, corner);
      for (std::size_t l = 0; l < mesh.loops.size(); ++l) {
        const int m = static_cast<int>(mesh.loops[l].size());
        for (int k = 0; k < m; ++k) {
          if (mesh.loops[l][k].a != corner) continue;
          // Two splits at the later index first, so that the earlier one still fits.
          const int before = (k + m - 1) % m;
          split_boundary_edge(mesh, static_cast<int>(l), std::max(k, before));
          split_boundary_edge(mesh, static_cast<int>(l), std::min(k, before));
          break;
        }
      }
      std::vector<int> ends;
      const MeshTopology topology(mesh);
      const std::vector<char> feature = feature_flags(mesh, topology);
      for (std::size_t i = 0; i < topology.edges.size(); ++i) {
        const MeshEdge& e = topology.edges[i];
        if (e.triangle[1] >= 0 && !feature[i] && (e.a == corner || e.b == corner))
          ends.push_back(e.a == corner ? e.b : e.a);
      }
      for (const int end : ends) split_edge(mesh, corner, end);
    }
}

void demote_all_joints(const Joints& joints, Roles& roles) {
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if ((joints[l][k].kind == JointKind::corner || joints[l][k].kind == JointKind::mild) &&
          !joints[l][k].branch)
        roles[l][k] = Role::released;
}

}  // namespace c1mesh
