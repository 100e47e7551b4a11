// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/stages.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "c1mesh/cost.h"
#include "domain/apart.h"
#include "mesh/topology.h"
#include "optimise/tracing.h"

namespace c1mesh {
namespace {

// Each control point's own length scale: the square root of the smallest area around it.
std::vector<double> control_sizes(const CurvedMesh& mesh, const std::vector<Point>& control) {
  const JacobianTables& tables = JacobianTables::of(mesh.degree);
  std::vector<double> size(control.size(), 1);
  std::fill_n(size.begin(), mesh.control.size(), 1e300);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    Net net(tables.net_size);
    const int* ids = &mesh.nets[t * tables.net_size];
    for (int k = 0; k < tables.net_size; ++k) net[k] = control[ids[k]];
    const double length = std::sqrt(std::abs(det_coefficients(tables, net).mean()));
    for (int k = 0; k < tables.net_size; ++k) size[ids[k]] = std::min(size[ids[k]], length);
  }
  return size;
}

// The vertices of the edges with the largest residues, worst first, without repetition.
std::vector<int> worst_vertices(const std::vector<C1Edge>& edges, const PointMatrix& domain,
                                const std::vector<Point>& control, int mesh_vertices) {
  std::vector<std::pair<double, std::size_t>> worst;
  for (std::size_t k = 0; k < edges.size(); ++k)
    worst.emplace_back(-largest_residue({edges[k]}, domain, control), k);
  std::sort(worst.begin(), worst.end());
  std::vector<int> out;
  std::vector<char> listed(mesh_vertices, 0);
  for (std::size_t k = 0; k < worst.size() && worst[k].first < 0.1 * worst[0].first; ++k)
    for (int v : edges[worst[k].second].vertex)
      if (v < mesh_vertices && !std::exchange(listed[v], 1)) out.push_back(v);
  return out;
}

double largest_of(const std::vector<double>& g) {
  return *std::max_element(g.begin(), g.end());
}

// The method of multipliers at the highest rho, until the residue is far below what the projection
// can mend without harm.
void drive_to_zero(MapObjective& objective, const ExactOptions& options, Eigen::VectorXd& x,
                   ExactReport& report, const Checkpoint& checkpoint) {
  for (int round = 0; round < options.multiplier_rounds; ++round) {
    const double residue =
        largest_residue(objective.edges(), objective.domain_points(x), objective.unpack(x).control);
    if (residue <= 1e-11) return;
    objective.update_multipliers(x);
    report.iterations += newton(objective, x, {options.iterations, 1e-9}, checkpoint).iterations;
  }
}

// A few steps at a time, each time with a fresh scaffold around the domain. Steps after which the
// boundary crosses itself nevertheless are undone and taken with the scaffold's flat triangles too.
void optimise_apart(const CurvedMesh& mesh, const DomainLayout& layout,
                    const std::vector<DomainElement>& extras, int iterations,
                    const std::function<bool(std::vector<DomainElement>, int)>& run,
                    MapState& state) {
  constexpr int kSteps = 5;
  Flats flats = Flats::left_out;
  for (int done = 0; done < iterations; done += kSteps) {
    const MapState before = state;
    std::vector<DomainElement> all = extras;
    const std::vector<DomainElement> scaffold = scaffold_elements(
        mesh, layout.exact * state.unknowns, flats, scaffold_weight(mesh.triangle_count()));
    all.insert(all.end(), scaffold.begin(), scaffold.end());
    const bool converged = run(std::move(all), kSteps);
    if (!boundary_meets_itself(mesh, layout.exact * state.unknowns)) {
      if (converged) return;
      continue;
    }
    state = before;
    if (flats == Flats::kept) return;
    flats = Flats::kept;
  }
}

}  // namespace

std::vector<C1Edge> asked_edges(const CurvedMesh& mesh, const Joints& joints, const Roles& roles) {
  std::vector<char> exceptional(mesh.vertex_count(), 0);
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (gives_up_c1(roles[l][k])) exceptional[joints[l][k].vertex] = 1;
  std::vector<C1Edge> out;
  for (C1Edge& e : c1_edges(mesh))
    if (!exceptional[e.vertex[0]] && !exceptional[e.vertex[1]]) out.push_back(std::move(e));
  return out;
}

std::vector<C1Edge> asked_equations(const CurvedMesh& mesh, const Joints& joints,
                                    const Roles& roles, const DomainLayout& layout,
                                    std::vector<Point>& control) {
  std::vector<C1Edge> asked = asked_edges(mesh, joints, roles);
  const std::vector<C1Edge> more = joint_equations(mesh, joints, layout, control);
  asked.insert(asked.end(), more.begin(), more.end());
  return asked;
}

JointReport optimise_jointly(const CurvedMesh& mesh, const DomainLayout& layout,
                             const std::vector<C1Edge>& asked, const DomainElements& elements,
                             const JointOptions& options, MapState& state,
                             const Checkpoint& checkpoint) {
  const StageTimer timer("map: joint stage");
  // Wedges as they are; the triangles' distortion now moves with the control points, and in its
  // place each domain triangle is held near the shape the domain stage gave it.
  std::vector<DomainElement> extras(elements.all.begin() + elements.triangles, elements.all.end());
  const PointMatrix domain = layout.exact * state.unknowns;
  for (int t = 0; t < elements.triangles; ++t) {
    DomainElement element = elements.all[t];
    const Eigen::Matrix2d reference = columns_of(element, domain);
    element.metric = metric_of(reference);
    element.area = cross(reference.col(0), reference.col(1));
    element.balance = 1;
    element.weight *= options.domain_quality;
    extras.push_back(element);
  }
  JointReport report;
  const auto run = [&](std::vector<DomainElement> all, int iterations) {
    MapObjective objective(mesh, layout, asked, std::move(all), state, true);
    objective.rho = options.rho;
    objective.exponent = options.exponent;
    Eigen::VectorXd x = objective.pack(state);
    const NewtonReport part =
        newton(objective, x, {iterations, 1e-4}, traced_map(checkpoint, "joint", mesh, objective));
    state = objective.unpack(x);
    report.iterations += part.iterations;
    report.energy = part.value;
    return part.converged;
  };
  if (options.no_overlap)
    optimise_apart(mesh, layout, extras, options.iterations, run, state);
  else
    run(std::move(extras), options.iterations);
  report.residue = largest_residue(asked, layout.exact * state.unknowns, state.control);
  return report;
}

ExactReport make_exact(const CurvedMesh& mesh, const DomainLayout& layout,
                       const std::vector<C1Edge>& asked, const ExactOptions& options,
                       MapState& state, const Checkpoint& checkpoint) {
  const StageTimer timer("map: exact stage");
  ExactReport report;
  MapObjective objective(mesh, layout, asked, {}, state, false);
  objective.exponent = options.exponent;
  const PointMatrix domain = layout.exact * state.unknowns;
  Eigen::VectorXd x = objective.pack(state);
  int stalls = 0;
  const Checkpoint continuing = traced_map(checkpoint, "continuation", mesh, objective);
  for (double rho = options.first_rho; rho <= options.last_rho && stalls < 2; rho *= 10) {
    objective.rho = rho;
    report.iterations += newton(objective, x, {options.iterations, 1e-5}, continuing).iterations;
    state.control = objective.unpack(x).control;
    const double residue = largest_residue(asked, domain, state.control);
    // Ten times the penalty should all but divide the residue by ten; where it does not even halve
    // it, no regular C1 map over this domain is near.
    stalls = rho > options.first_rho && residue > 0.5 * report.residue ? stalls + 1 : 0;
    report.residue = residue;
  }
  if (report.residue > options.give_up_residue) {
    report.final_residue = report.residue;
    report.trouble = worst_vertices(asked, domain, state.control, mesh.vertex_count());
    return report;
  }
  const Checkpoint driving = traced_map(checkpoint, "exact", mesh, objective);
  drive_to_zero(objective, options, x, report, driving);
  state.control = objective.unpack(x).control;
  report.residue = largest_residue(asked, domain, state.control);
  MapState exact = state;
  const ProjectionReport projection = project_to_c1(
      asked, domain, objective.fixed(), control_sizes(mesh, state.control), exact.control);
  if (driving.observe) driving.observe(objective.pack(exact), 1);
  report.final_residue = projection.after;
  std::vector<double> g = distortion_bounds(mesh, domain, exact.control);
  report.success = projection.after < kExact && std::isfinite(largest_of(g));
  if (report.success) {
    state.control = exact.control;
    if (largest_of(g) > options.good_enough)
      lower_distortion(mesh, layout, asked, options, state, checkpoint);
    return report;
  }
  if (projection.after >= kExact) {
    report.trouble = worst_vertices(asked, domain, exact.control, mesh.vertex_count());
  } else {
    for (std::size_t t = 0; t < g.size(); ++t)
      if (!std::isfinite(g[t]))
        for (int v : mesh.triangles[t]) report.trouble.push_back(v);
  }
  return report;
}

double project_exactly(const CurvedMesh& mesh, const DomainLayout& layout,
                       const std::vector<C1Edge>& asked, MapState& state) {
  return project_to_c1(asked, layout.exact * state.unknowns,
                       fixed_control(mesh, state.control.size()),
                       control_sizes(mesh, state.control), state.control)
      .after;
}

bool lower_distortion(const CurvedMesh& mesh, const DomainLayout& layout,
                      const std::vector<C1Edge>& asked, const ExactOptions& options,
                      MapState& state, const Checkpoint& checkpoint) {
  const StageTimer timer("map: lower distortion");
  MapObjective objective(mesh, layout, asked, {}, state, false);
  objective.rho = options.last_rho;
  const PointMatrix domain = layout.exact * state.unknowns;
  Eigen::VectorXd x = objective.pack(state);
  double best = largest_of(distortion_bounds(mesh, domain, state.control));
  bool better = false;
  // Each norm starts near its optimum; what a few steps do not gain is not worth their time.
  ExactOptions brief = options;
  brief.iterations = 2;
  brief.multiplier_rounds = 6;
  ExactReport report;
  const Checkpoint lowering = traced_map(checkpoint, "p-norm", mesh, objective);
  for (double p = 4; p <= options.final_exponent; p *= 2) {
    objective.exponent = p;
    objective.reference = objective.largest(x);
    newton(objective, x, {6, 1e-3}, lowering);
    drive_to_zero(objective, brief, x, report, lowering);
    MapState next{state.unknowns, objective.unpack(x).control};
    const ProjectionReport projection = project_to_c1(
        asked, domain, objective.fixed(), control_sizes(mesh, next.control), next.control);
    if (lowering.observe) lowering.observe(objective.pack(next), 1);
    const double g = largest_of(distortion_bounds(mesh, domain, next.control));
    if (!(projection.after < kExact) || !(g < best)) continue;
    best = g;
    state.control = next.control;
    better = true;
  }
  return better;
}

std::vector<double> distortion_bounds(const CurvedMesh& mesh, const PointMatrix& domain,
                                      const std::vector<Point>& control) {
  const JacobianTables& tables = JacobianTables::of(mesh.degree);
  std::vector<double> g;
  Net net(tables.net_size);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < tables.net_size; ++k) net[k] = control[mesh.nets[t * tables.net_size + k]];
    const Point origin = domain.row(mesh.triangles[t][0]).transpose();
    g.push_back(distortion_bound(tables, net, domain.row(mesh.triangles[t][1]).transpose() - origin,
                                 domain.row(mesh.triangles[t][2]).transpose() - origin));
  }
  return g;
}

}  // namespace c1mesh
