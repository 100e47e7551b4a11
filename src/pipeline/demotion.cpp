// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/demotion.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace c1mesh {
namespace {

// What giving up a vertex is worth, as a factor on its distance: a smooth vertex must be much
// nearer than a corner to be chosen, because it adds a corner to the domain.
double reluctance(const Joint& joint, Role role) {
  if (role == Role::flat) return 8;
  if (joint.kind == JointKind::corner) return joint.convex() == (joint.loop == 0) ? 2 : 1;
  return 1;
}

}  // namespace

int demote_near(const CurvedMesh& mesh, const Joints& joints, const std::vector<int>& trouble,
                int count, Roles& roles) {
  // (distance, loop, position), so that ties are settled the same way every time.
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      if (roles[l][k] == Role::exceptional) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (int v : trouble)
        nearest = std::min(nearest,
                           (mesh.domain[v] - mesh.domain[joints[l][k].vertex]).norm() + 1e-3);
      order.emplace_back(nearest * reluctance(joints[l][k], roles[l][k]), l, k);
    }
  std::sort(order.begin(), order.end());
  const int changed = std::min(count, static_cast<int>(order.size()));
  for (int i = 0; i < changed; ++i)
    roles[std::get<1>(order[i])][std::get<2>(order[i])] = Role::exceptional;
  return changed;
}

Roles roles_on(const Joints& from, const Roles& roles, const Joints& to) {
  std::map<int, Role> by_vertex;
  for (std::size_t l = 0; l < from.size(); ++l)
    for (std::size_t k = 0; k < from[l].size(); ++k) by_vertex[from[l][k].vertex] = roles[l][k];
  Roles out;
  for (const auto& loop : to) {
    out.emplace_back();
    for (const Joint& joint : loop) {
      const auto found = by_vertex.find(joint.vertex);
      out.back().push_back(found == by_vertex.end() ? Role::flat : found->second);
    }
  }
  return out;
}

void demote_all_joints(const Joints& joints, Roles& roles) {
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (joints[l][k].kind == JointKind::corner || joints[l][k].kind == JointKind::mild)
        roles[l][k] = Role::exceptional;
}

}  // namespace c1mesh
