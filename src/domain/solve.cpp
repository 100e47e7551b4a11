// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/solve.h"

#include <algorithm>
#include <cmath>

#include "c1mesh/cost.h"
#include "domain/apart.h"
#include "domain/unbend.h"

namespace c1mesh {
namespace {

// Triangles from each hole's edges to its centre: they keep the hole from turning inside out. The
// centre is one more unknown; the reference is the regular fan.
void fill_holes(const CurvedMesh& mesh, double weight, DomainLayout& layout,
                std::vector<DomainElement>& elements, PointMatrix& unknowns) {
  const int holes = static_cast<int>(mesh.loops.size()) - 1;
  if (holes == 0) return;
  const int rows = layout.rows(), columns = layout.unknowns();
  const PointMatrix points = layout.exact * unknowns;
  for (DomainLayout::Matrix* matrix : {&layout.exact, &layout.sparse}) {
    std::vector<Eigen::Triplet<double>> triplets;
    for (int row = 0; row < rows; ++row)
      for (DomainLayout::Matrix::InnerIterator it(*matrix, row); it; ++it)
        triplets.emplace_back(row, static_cast<int>(it.col()), it.value());
    for (int h = 0; h < holes; ++h) triplets.emplace_back(rows + h, columns + h, 1);
    matrix->resize(rows + holes, columns + holes);
    matrix->setFromTriplets(triplets.begin(), triplets.end());
  }
  unknowns.conservativeResize(columns + holes, 2);
  for (int h = 0; h < holes; ++h) {
    const auto& loop = mesh.loops[h + 1];
    const double sector = 2 * M_PI / static_cast<double>(loop.size());
    Point centre = Point::Zero();
    for (const BoundaryEdge& e : loop) {
      centre += points.row(e.a).transpose() / double(loop.size());
      const double length = (mesh.domain[e.b] - mesh.domain[e.a]).norm();
      // A hole's loop is clockwise: seen from the centre its edges run b -> a.
      const double radius = length / (2 * std::sin(0.5 * sector));
      Eigen::Matrix2d S;
      S << radius, radius * std::cos(sector), 0, radius * std::sin(sector);
      DomainElement element;
      element.points = {rows + h, e.b, e.a};
      element.metric = metric_of(S);
      element.area = radius * radius * std::sin(sector);
      element.weight = weight / double(mesh.triangle_count());
      elements.push_back(element);
    }
    unknowns.row(columns + h) = centre.transpose();
  }
}

struct Attempt {
  PointMatrix unknowns;
  DomainReport report;
};

// An observer hears of places of vertices, a layout's computation is over its unknowns.
Checkpoint over_unknowns(const CurvedMesh& mesh, const DomainLayout& layout,
                         const Checkpoint& checkpoint) {
  return checkpoint.over([&mesh, &layout](const Eigen::VectorXd& x) {
    const PointMatrix rows = layout.exact * unflatten(x);
    return flatten(rows.topRows(mesh.vertex_count()));
  });
}

// Newton that keeps the boundary from crossing itself: a few steps at a time with a fresh scaffold.
// Steps after which it crosses nevertheless are undone and taken with the whole scaffold.
NewtonReport minimise_apart(const CurvedMesh& mesh, const DomainLayout& layout,
                            const DomainElements& elements, double exponent,
                            const NewtonOptions& options, Eigen::VectorXd& x,
                            const Checkpoint& checkpoint) {
  NewtonReport total;
  Flats flats = Flats::left_out;
  while (total.iterations < options.max_iterations && !total.converged) {
    const Eigen::VectorXd before = x;
    std::vector<DomainElement> all = elements.all;
    const std::vector<DomainElement> scaffold = scaffold_elements(
        mesh, layout.exact * unflatten(x), flats, scaffold_weight(elements.triangles));
    all.insert(all.end(), scaffold.begin(), scaffold.end());
    DomainObjective objective(layout, std::move(all));
    objective.exponent = exponent;
    const NewtonReport part = newton(objective, x, {5, options.relative_decrease},
                                     over_unknowns(mesh, layout, checkpoint));
    total.iterations += part.iterations;
    total.converged = part.converged;
    if (!boundary_meets_itself(mesh, layout.exact * unflatten(x))) continue;
    x = before;
    total.converged = false;
    if (flats == Flats::kept) break;
    flats = Flats::kept;
  }
  DomainObjective plain(layout, elements.all);
  plain.exponent = exponent;
  total.value = plain.value(x);
  return total;
}

// Where the start's least relative determinant is under `least_start` (a Tutte embedding underflows
// long before it inverts): untangles with the holes filled. Then minimises without the filling.
Attempt attempt_start(const CurvedMesh& mesh, const DomainLayout& layout,
                      const DomainElements& elements, const DomainOptions& options,
                      PointMatrix start, double least_start, bool apart,
                      const Checkpoint& checkpoint) {
  Attempt out;
  out.unknowns = std::move(start);
  normalise_domain(mesh, layout, out.unknowns);
  Eigen::VectorXd x = flatten(out.unknowns);
  DomainObjective objective(layout, elements.all);
  const Checkpoint on_unknowns = over_unknowns(mesh, layout, checkpoint);
  if (objective.least_determinant(x) < least_start) {
    DomainLayout filled = layout;
    std::vector<DomainElement> with_holes = elements.all;
    PointMatrix unknowns = out.unknowns;
    fill_holes(mesh, 0.1, filled, with_holes, unknowns);
    DomainObjective tangled(filled, with_holes);
    Eigen::VectorXd y = flatten(unknowns);
    out.report.untangle_iterations = untangle_domain(tangled, y, options.untangle_iterations,
                                                     over_unknowns(mesh, filled, checkpoint))
                                         .iterations;
    x = y.head(x.size());
    if (!(objective.least_determinant(x) > 0))
      out.report.untangle_iterations +=
          untangle_domain(objective, x, options.untangle_iterations, on_unknowns).iterations;
  }
  out.unknowns = unflatten(x);
  const PointMatrix points = layout.exact * out.unknowns;
  for (const DomainElement& e : elements.all)
    if (!(determinant_of(e, points) > 0))
      for (int v : e.points)
        if (v < mesh.vertex_count()) out.report.inverted.push_back(v);
  if (out.report.inverted.empty()) out.report.inverted = winding_faults(mesh, points);
  if (!out.report.inverted.empty()) return out;

  const auto minimise = [&](const NewtonOptions& steps) {
    return apart ? minimise_apart(mesh, layout, elements, objective.exponent, steps, x, checkpoint)
                 : newton(objective, x, steps, on_unknowns);
  };
  const NewtonReport first = minimise({options.newton_iterations, 1e-4});
  out.report.newton_iterations = first.iterations;
  out.report.energy = first.value;
  for (objective.exponent = 2; objective.exponent <= options.final_exponent;
       objective.exponent *= 2)
    out.report.newton_iterations += minimise({15, 1e-3}).iterations;
  out.unknowns = unflatten(x);
  normalise_domain(mesh, layout, out.unknowns);
  const PointMatrix final_points = layout.exact * out.unknowns;
  out.report.inverted = winding_faults(mesh, final_points);
  out.report.valid = out.report.inverted.empty();
  out.report.crossings = boundary_crossings(mesh, final_points);
  for (const DomainElement& e : elements.all)
    out.report.largest =
        std::max(out.report.largest, element_value(e, columns_of(e, final_points), 1, 0));
  return out;
}

// Valid before invalid, without crossings before with, then by energy.
bool better(const DomainReport& a, const DomainReport& b) {
  if (a.valid != b.valid) return a.valid;
  if ((a.crossings == 0) != (b.crossings == 0)) return a.crossings == 0;
  return a.valid ? a.energy < b.energy : a.inverted.size() < b.inverted.size();
}

}  // namespace

void normalise_domain(const CurvedMesh& mesh, const DomainLayout& layout, PointMatrix& unknowns) {
  const PointMatrix points = layout.exact * unknowns;
  double area = 0, shape = 0;
  Point centre = Point::Zero();
  for (const auto& t : mesh.triangles) {
    const Point a = points.row(t[0]), b = points.row(t[1]), c = points.row(t[2]);
    area += std::abs(cross(b - a, c - a));
    shape += cross(mesh.domain[t[1]] - mesh.domain[t[0]], mesh.domain[t[2]] - mesh.domain[t[0]]);
    centre += (a + b + c) / (3.0 * mesh.triangle_count());
  }
  const double scale = std::sqrt(shape / area);
  // The vectors w do not translate: only rows that are positions do.
  std::vector<char> vector_unknown(layout.unknowns(), 0);
  for (const auto& loop : layout.bend_unknown)
    for (int unknown : loop)
      if (unknown >= 0) vector_unknown[unknown] = 1;
  for (int u = 0; u < layout.unknowns(); ++u) {
    if (!vector_unknown[u]) unknowns.row(u) -= centre.transpose();
    unknowns.row(u) *= scale;
  }
}

DomainState solve_domain(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                         const DomainOptions& options, DomainReport& report,
                         const Checkpoint& checkpoint) {
  const StageTimer timer("map: domain");
  DomainState state{roles, make_layout(mesh, joints, roles), {}};
  const DomainElements elements =
      domain_elements(mesh, joints, roles, state.layout, options.weights);
  bool first = true;
  // Returns true when nothing better is to be expected.
  const auto attempt = [&](const PointMatrix& start, double least_start, bool apart) {
    Attempt next =
        attempt_start(mesh, state.layout, elements, options, start, least_start, apart, checkpoint);
    if (first || better(next.report, report)) {
      report = next.report;
      state.unknowns = next.unknowns;
    }
    first = false;
    return report.valid && report.crossings == 0;
  };
  if (!options.warm.empty() &&
      (attempt(unknowns_of_shape(options.warm, joints, state.layout), 0, false) ||
       (report.valid && !options.no_overlap)))
    return state;
  if (attempt(start_positions(mesh, joints, roles, state.layout, Start::shape), 1e-3, false))
    return state;
  for (const bool apart : {true, false}) {
    UnbendOptions how = options.unbend;
    how.apart = apart;
    UnbendReport unbending;
    const PointMatrix unbent =
        unbend_domain(mesh, joints, roles, state.layout, elements, how, unbending, checkpoint);
    if (attempt(unbent, unbending.reached ? 0 : 1e-3, false)) return state;
    if (apart && unbending.reached && attempt(unbent, 0, true)) return state;
    if (report.valid) return state;
  }
  attempt(start_positions(mesh, joints, roles, state.layout, Start::convex), 1e-3, false);
  return state;
}

}  // namespace c1mesh
