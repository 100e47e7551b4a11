// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/refine.h"

#include <algorithm>
#include <cmath>

#include "c1mesh/cost.h"
#include "mesh/bisect.h"
#include "optimise/tracing.h"

namespace c1mesh {
namespace {

// An exact map on its mesh, and the distortion of its triangles.
struct Stage {
  CurvedMesh mesh;
  Joints joints;
  Attempt map;
  std::vector<double> g;
  double largest() const { return *std::max_element(g.begin(), g.end()); }
};

std::vector<char> exceptional_vertices(const Stage& stage) {
  std::vector<char> out(stage.mesh.vertex_count(), 0);
  for (std::size_t l = 0; l < stage.joints.size(); ++l)
    for (std::size_t k = 0; k < stage.joints[l].size(); ++k)
      if (gives_up_c1(stage.map.roles[l][k])) out[stage.joints[l][k].vertex] = 1;
  return out;
}

// The same map on a mesh in which the chosen triangles are bisected.
Stage bisected(const Stage& stage, const std::vector<int>& chosen) {
  Stage next = stage;
  bisect_triangles(next.mesh, chosen, exceptional_vertices(stage));
  next.joints = find_joints_again(next.mesh, stage.joints);
  next.map.roles = roles_on(stage.joints, stage.map.roles, next.joints);
  next.map.domain.points = domain_points(next.mesh);
  return next;
}

// How often lowering may still be tried: it costs far more than bisection.
struct Patience {
  int lowerings = 3;
  int pause = 0;  // rounds to let pass after one in vain
};

// Exact again after the roundings of the split; lowered if that did not gain enough by itself.
bool settle(Stage& stage, double before, double target, const ExactOptions& exact,
            Patience& patience, const Checkpoint& checkpoint) {
  constexpr double kEnough = 0.75;
  const DomainLayout layout = make_layout(stage.mesh, stage.joints, stage.map.roles);
  MapState state{unknowns_of_shape(stage.map.domain, stage.joints, layout), stage.mesh.control};
  const std::vector<C1Edge> asked =
      asked_equations(stage.mesh, stage.joints, stage.map.roles, layout, state.control);
  const PointMatrix domain = (layout.exact * state.unknowns).topRows(stage.mesh.vertex_count());
  if (project_exactly(stage.mesh, layout, asked, state) >= kExact) return false;
  if (checkpoint.trace) {
    TraceRecord record = trace_record(stage.mesh, asked, domain, state.control);
    record.stage = "refinement";
    record.step = 1;  // the projection
    checkpoint.trace(record);
  }
  const auto measure = [&] {
    stage.g = distortion_bounds(stage.mesh, domain, state.control);
    return stage.largest();
  };
  double g = measure();
  if (!std::isfinite(g)) return false;
  if (patience.pause > 0) {
    --patience.pause;
  } else if (g > target && g > kEnough * before && patience.lowerings > 0) {
    --patience.lowerings;
    if (lower_distortion(stage.mesh, layout, asked, exact, state, checkpoint))
      g = measure();
    else
      patience.pause = 2;
  }
  stage.map.g = g;
  stage.map.domain =
      shape_of_domain(stage.mesh.vertex_count(), stage.joints, layout, state.unknowns);
  stage.map.control.assign(
      state.control.begin(),
      state.control.begin() + static_cast<std::ptrdiff_t>(stage.mesh.control.size()));
  stage.mesh.control = stage.map.control;
  set_domain(stage.mesh, domain);
  return true;
}

}  // namespace

void refine_where_distorted(const RefineOptions& options, const ExactOptions& exact,
                            CurvedMesh& mesh, Joints& joints, Attempt& attempt,
                            const Checkpoint& outer) {
  const StageTimer timer("map: refinement");
  const Checkpoint checkpoint =
      traced_roles(outer, joints, attempt.roles).marked([](TraceRecord& record) {
        record.stage = "refinement";
      });
  Stage stage{mesh, joints, attempt, {}};
  set_domain(stage.mesh, attempt.domain.points);
  stage.mesh.control = attempt.control;
  stage.g = distortion_bounds(mesh, attempt.domain.points, attempt.control);
  const double most = options.growth * mesh.triangle_count();
  Stage best = stage;
  Patience patience;
  for (int round = 0; round < options.rounds && stage.largest() > options.target; ++round) {
    if (checkpoint) checkpoint();
    const double before = stage.largest();
    const double limit = std::max(options.target, 0.5 * before);
    std::vector<int> chosen;
    for (std::size_t t = 0; t < stage.g.size(); ++t)
      if (stage.g[t] > limit) chosen.push_back(static_cast<int>(t));
    Stage next = bisected(stage, chosen);
    if (next.mesh.triangle_count() > most) break;
    if (!settle(next, before, options.target, exact, patience, checkpoint)) break;
    stage = std::move(next);
    if (stage.largest() < 0.98 * best.largest()) best = stage;
  }
  if (best.mesh.triangle_count() == mesh.triangle_count()) return;
  mesh = std::move(best.mesh);
  joints = std::move(best.joints);
  attempt = std::move(best.map);
}

}  // namespace c1mesh
