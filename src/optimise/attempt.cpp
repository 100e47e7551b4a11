// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/attempt.h"

#include <algorithm>
#include <cmath>

#include "domain/apart.h"
#include "optimise/tracing.h"

namespace c1mesh {
namespace {

void finish(const CurvedMesh& mesh, const Joints& joints, const DomainLayout& layout,
            const MapState& state, const ExactReport& exact, Attempt& out) {
  out.success = exact.success;
  out.trouble = exact.trouble;
  out.domain = shape_of_domain(mesh.vertex_count(), joints, layout, state.unknowns);
  out.control.assign(state.control.begin(),
                     state.control.begin() + static_cast<std::ptrdiff_t>(mesh.control.size()));
  if (!out.success) return;
  const std::vector<double> g = distortion_bounds(mesh, out.domain.points, out.control);
  const auto worst = std::max_element(g.begin(), g.end());
  out.g = *worst;
  for (int v : mesh.triangles[worst - g.begin()]) out.trouble.push_back(v);
}

}  // namespace

Attempt attempt_region(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                       const AttemptOptions& options, const Checkpoint& outer) {
  Attempt out;
  out.roles = roles;
  const Checkpoint checkpoint = traced_roles(outer, joints, roles);
  DomainReport report;
  const DomainState domain = solve_domain(mesh, joints, roles, options.domain, report,
                                          traced_domain(checkpoint, "domain", mesh, joints, roles));
  out.domain_valid = report.valid;
  out.crossings = report.crossings;
  out.energy = report.energy;
  out.trouble = report.inverted;
  if (options.no_overlap && report.valid && report.crossings > 0) {
    out.domain_valid = false;
    out.trouble = crossing_vertices(mesh, domain.layout.exact * domain.unknowns);
  }
  if (!out.domain_valid) return out;
  out.domain_stage = shape_of_domain(mesh.vertex_count(), joints, domain.layout, domain.unknowns);

  MapState state{domain.unknowns, mesh.control};
  const std::vector<C1Edge> asked =
      asked_equations(mesh, joints, roles, domain.layout, state.control);
  const DomainElements elements =
      domain_elements(mesh, joints, roles, domain.layout, options.domain.weights);
  JointOptions joint = options.joint;
  joint.no_overlap = options.no_overlap;
  optimise_jointly(mesh, domain.layout, asked, elements, joint, state, checkpoint);
  const ExactReport exact =
      make_exact(mesh, domain.layout, asked, options.exact, state, checkpoint);
  finish(mesh, joints, domain.layout, state, exact, out);
  out.crossings = boundary_crossings(mesh, out.domain.points);
  if (options.no_overlap && boundary_meets_itself(mesh, out.domain.points)) out.success = false;
  return out;
}

Attempt attempt_on_initial_domain(const CurvedMesh& mesh, const Joints& joints,
                                  const ExactOptions& options, const Checkpoint& outer) {
  Attempt out;
  out.domain_valid = true;
  for (const auto& loop : joints) out.roles.emplace_back(loop.size(), Role::exceptional);
  const Checkpoint checkpoint = traced_roles(outer, joints, out.roles);
  const DomainLayout layout = make_layout(mesh, joints, out.roles);
  MapState state{PointMatrix(mesh.vertex_count(), 2), mesh.control};
  for (int v = 0; v < mesh.vertex_count(); ++v)
    state.unknowns.row(layout.unknown_of_row[v]) = mesh.domain[v].transpose();
  const ExactReport exact =
      make_exact(mesh, layout, asked_edges(mesh, joints, out.roles), options, state, checkpoint);
  finish(mesh, joints, layout, state, exact, out);
  return out;
}

}  // namespace c1mesh
