// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/project.h"

#include <algorithm>
#include <set>

#include "c1mesh/error.h"
#include "linear/sparse_solver.h"
#include "mesh/topology.h"
#include "optimise/c1_system.h"

namespace c1mesh {
namespace {

double extent_of(const Result& result) {
  Point low = result.control_points.front(), high = low;
  for (const Point& p : result.control_points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

// As much of the mesh as the equations need.
CurvedMesh mesh_of(const Result& result) {
  CurvedMesh mesh;
  mesh.degree = result.degree;
  mesh.domain = result.domain_vertices;
  mesh.triangles = result.triangles;
  mesh.control = result.control_points;
  for (const auto& net : result.triangle_control_points)
    mesh.nets.insert(mesh.nets.end(), net.begin(), net.end());
  return mesh;
}

std::vector<C1Edge> asked_edges(const Result& result, const CurvedMesh& mesh) {
  std::set<std::pair<int, int>> excluded;
  for (const auto& e : result.relaxed_edges) excluded.insert(std::minmax(e[0], e[1]));
  for (const CurveEdge& e : result.feature_edges) excluded.insert(std::minmax(e.a, e.b));
  std::vector<C1Edge> out;
  for (C1Edge& e : c1_edges(mesh))
    if (!excluded.contains(std::minmax(e.vertex[0], e.vertex[1]))) out.push_back(std::move(e));
  return out;
}

// Leaves of the moves what is in the range of A^T: the least move to where they lead. A^T A is
// singular in the directions that keep C1, and in its solutions the rounding along these is large,
// a thousandth of the move; A A^T has no such directions.
void make_orthogonal(const std::vector<C1Edge>& edges, const PointMatrix& domain,
                     const std::vector<Point>& before, std::vector<Point>& control) {
  const auto count = static_cast<int>(control.size());
  const SparseMatrix A = c1_matrix(edges, domain, count);
  SparseSolver solver;
  if (!factorise_shifted(
          solver, SparseMatrix(SparseMatrix(A * A.transpose()).triangularView<Eigen::Lower>()),
          1e-13))
    return;
  PointMatrix move(count, 2);
  for (int k = 0; k < count; ++k) move.row(k) = (control[k] - before[k]).transpose();
  for (int c = 0; c < 2; ++c) {
    const Eigen::VectorXd least = A.transpose() * solver.solve(A * move.col(c));
    for (int k = 0; k < count; ++k) control[k][c] = before[k][c] + least[k];
  }
}

void set_parameter(Parameters& parameters, const std::string& name, const ParameterValue& value) {
  for (auto& [key, old] : parameters)
    if (key == name) {
      old = value;
      return;
    }
  parameters.emplace_back(name, value);
}

[[noreturn]] void fail_on_domain() {
  Defect defect;
  defect.kind = DefectKind::unsupported;
  defect.message = "the result's domain has a triangle that is flat or inverted";
  defect.remedy = "project a result that verifies";
  throw InputError({defect});
}

}  // namespace

Projection project(const Result& result, double conformance_bound) {
  const CurvedMesh mesh = mesh_of(result);
  PointMatrix domain(mesh.vertex_count(), 2);
  for (int v = 0; v < mesh.vertex_count(); ++v) domain.row(v) = mesh.domain[v].transpose();
  for (const auto& t : mesh.triangles)
    if (!(cross(mesh.domain[t[1]] - mesh.domain[t[0]], mesh.domain[t[2]] - mesh.domain[t[0]]) > 0))
      fail_on_domain();
  Projection out{result};
  // All control points are free and weigh the same: the projection is orthogonal.
  const std::vector<C1Edge> edges = asked_edges(result, mesh);
  const std::vector<char> fixed(mesh.control.size(), 0);
  const std::vector<double> size(mesh.control.size(), 1);
  std::vector<Point>& control = out.result.control_points;
  const double extent = extent_of(result);
  out.before = project_to_c1(edges, domain, fixed, size, control).before / extent;
  make_orthogonal(edges, domain, mesh.control, control);
  out.after = project_to_c1(edges, domain, fixed, size, control).after / extent;
  for (std::size_t k = 0; k < control.size(); ++k)
    out.largest_move = std::max(out.largest_move, (control[k] - mesh.control[k]).norm() / extent);
  set_parameter(out.result.parameters, "projected", true);
  set_parameter(out.result.parameters, "c1_bound", 1e-11);
  set_parameter(out.result.parameters, "conformance_bound", conformance_bound);
  return out;
}

}  // namespace c1mesh
