// SPDX-License-Identifier: GPL-3.0-or-later
// A region with an exactly C1 map, and what such a map must be.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "domain/exceptional.h"
#include "mesh/shapes.h"
#include "optimise/attempt.h"

namespace c1mesh::testing_tools {

struct ExactMap {
  std::map<int, BezierCurve> curves;
  CurvedMesh mesh;
  Joints joints;
  Attempt attempt;
};

/// One try at the region within the loops, its distortion left as the exact stage finds it.
inline ExactMap exact_map(const std::vector<std::vector<BezierCurve>>& loops) {
  ExactMap out;
  const MeshInput input = test::input_of(loops);
  for (const auto& loop : input.loops)
    for (const LoopCurve& c : loop) out.curves[c.curve] = c.bezier;
  MeshReport report;
  out.mesh = initial_mesh(input, {}, report);
  out.joints = find_joints(out.mesh, 8);
  const Roles roles =
      place_exceptional(out.mesh, out.joints, natural_roles(out.joints), Placement::curvature);
  AttemptOptions options;
  options.exact.good_enough = 1e300;
  out.attempt = attempt_region(out.mesh, out.joints, roles, options, {});
  return out;
}

/// An exact map as the stages take it: layout, equations of edges and joints, values.
struct ExactState {
  DomainLayout layout;
  MapState state;
  std::vector<C1Edge> asked;
  PointMatrix domain;

  explicit ExactState(const ExactMap& map)
      : layout(make_layout(map.mesh, map.joints, map.attempt.roles)),
        state{unknowns_of_shape(map.attempt.domain, map.joints, layout), map.attempt.control},
        asked(asked_edges(map.mesh, map.joints, map.attempt.roles)) {
    const auto more = joint_equations(map.mesh, map.joints, layout, state.control);
    asked.insert(asked.end(), more.begin(), more.end());
    domain = layout.exact * state.unknowns;
  }

  double residue() const { return largest_residue(asked, domain, state.control); }
  double g(const CurvedMesh& mesh) const {
    const std::vector<double> all = distortion_bounds(mesh, domain, state.control);
    return *std::max_element(all.begin(), all.end());
  }
};

}  // namespace c1mesh::testing_tools
