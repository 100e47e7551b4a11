// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/project.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "base/extent.h"
#include "c1mesh/error.h"
#include "domain/start.h"
#include "linear/least_move.h"
#include "mesh/topology.h"
#include "optimise/c1_system.h"
#include "paper/singular.h"

namespace c1mesh {
namespace {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

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

// A p, one row an equation, summed in extended precision.
Eigen::MatrixXd residues_of(const RowMatrix& A, const std::vector<Point>& control) {
  Eigen::MatrixXd out(A.rows(), 2);
  for (int r = 0; r < A.rows(); ++r)
    for (int k = 0; k < 2; ++k) {
      long double sum = 0;
      for (RowMatrix::InnerIterator it(A, r); it; ++it)
        sum += static_cast<long double>(it.value()) * control[it.col()][k];
      out(r, k) = static_cast<double>(sum);
    }
  return out;
}

// The least move that makes A p = 0, refined while that helps; the largest residue before and
// after.
std::pair<double, double> move_onto(const RowMatrix& A, std::vector<Point>& control) {
  constexpr int kRounds = 6;
  constexpr double kDependent = 1e-10;  // of a row from the others, relative to rows of norm 1
  const LeastMove solver{SparseMatrix(A), kDependent};
  Eigen::MatrixXd residues = residues_of(A, control);
  const double before = residues.size() ? residues.cwiseAbs().maxCoeff() : 0;
  double after = before;
  for (int round = 0; round < kRounds && after > 0; ++round) {
    const Eigen::MatrixXd move = solver.solve(residues);
    std::vector<Point> next = control;
    for (std::size_t k = 0; k < next.size(); ++k)
      next[k] -= move.row(static_cast<Eigen::Index>(k)).transpose();
    residues = residues_of(A, next);
    const double largest = residues.cwiseAbs().maxCoeff();
    if (!(largest < after)) break;
    after = largest;
    control = std::move(next);
  }
  return {before, after};
}

// Those inside; the domain's boundary and its features keep their shape.
std::vector<char> movable_vertices(const Result& result, const MeshTopology& topology) {
  std::vector<char> out(result.domain_vertices.size(), 1);
  for (std::size_t v = 0; v < out.size(); ++v)
    if (topology.on_boundary[v]) out[v] = 0;
  for (const CurveEdge& e : result.feature_edges) out[e.a] = out[e.b] = 0;
  return out;
}

// All control points are free and weigh the same: the projection is orthogonal.
void project_over(const std::vector<C1Edge>& edges, const PointMatrix& domain,
                  const std::vector<Point>& start, Projection& out) {
  std::vector<Point>& control = out.result.control_points;
  const RowMatrix A = c1_matrix(edges, domain, static_cast<int>(control.size()));
  std::tie(out.before, out.after) = move_onto(A, control);
  for (std::size_t k = 0; k < control.size(); ++k)
    out.largest_move = std::max(out.largest_move, (control[k] - start[k]).norm());
}

void set_parameter(Parameters& parameters, const std::string& name, const ParameterValue& value) {
  for (auto& [key, old] : parameters)
    if (key == name) {
      old = value;
      return;
    }
  parameters.emplace_back(name, value);
}

// A claim that is tighter already stays.
void tighten_parameter(Parameters& parameters, const std::string& name, double value) {
  for (const auto& [key, old] : parameters)
    if (const auto* bound = std::get_if<double>(&old); key == name && bound && *bound < value)
      return;
  set_parameter(parameters, name, value);
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
  for (const auto& t : mesh.triangles)
    if (!(cross(mesh.domain[t[1]] - mesh.domain[t[0]], mesh.domain[t[2]] - mesh.domain[t[0]]) > 0))
      fail_on_domain();
  const MeshTopology topology(mesh);
  const std::vector<char> movable = movable_vertices(result, topology);
  const std::vector<C1Edge> edges = asked_edges(result, mesh);
  const double extent = extent_of(result.control_points);
  Projection out;
  for (double tolerance : {0.0, 1e-6, 1e-5, 1e-4, 1e-3}) {
    Projection trial{result};
    PointMatrix domain = domain_points(mesh);
    if (tolerance > 0) trial.singular = make_singular(mesh, topology, movable, tolerance, domain);
    if (tolerance > 0 && trial.singular == out.singular) continue;
    for (int v = 0; v < mesh.vertex_count(); ++v)
      trial.result.domain_vertices[v] = domain.row(v).transpose();
    project_over(edges, domain, mesh.control, trial);
    // Exactness first; a move is not worth it for an equation less exact.
    const auto rank = [exact_enough = 1e-12 * extent](const Projection& p) {
      return std::make_pair(p.after > exact_enough, p.largest_move);
    };
    if (tolerance == 0 || rank(trial) < rank(out)) out = std::move(trial);
  }
  out.before /= extent;
  out.after /= extent;
  out.largest_move /= extent;
  set_parameter(out.result.parameters, "projected", true);
  tighten_parameter(out.result.parameters, "c1_bound", 1e-11);
  set_parameter(out.result.parameters, "conformance_bound", conformance_bound);
  return out;
}

}  // namespace c1mesh
