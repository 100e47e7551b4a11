// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/c1_system.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "c1mesh/cost.h"
#include "linear/sparse_solver.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

// Control ids of the row at distance `row` from the edge opposite corner `k`, in the direction from
// corner k+1 to corner k+2: n + 1 - row ids.
std::vector<int> row_controls(const CurvedMesh& mesh, int t, int k, int row) {
  const int n = mesh.degree;
  std::vector<int> ids;
  for (int s = 0; s <= n - row; ++s) {
    int weight[3];  // barycentric index: (p_00 corner 0, p_n0 corner 1, p_0n corner 2)
    weight[k] = row;
    weight[(k + 1) % 3] = n - row - s;
    weight[(k + 2) % 3] = s;
    ids.push_back(mesh.control_id(t, weight[1], weight[2]));
  }
  return ids;
}

Point row(const PointMatrix& points, int r) {
  return points.row(r).transpose();
}

}  // namespace

std::vector<C1Edge> c1_edges(const CurvedMesh& mesh) {
  std::vector<C1Edge> out;
  const MeshTopology topology(mesh);
  const std::vector<char> feature = feature_flags(mesh, topology);
  for (std::size_t k = 0; k < topology.edges.size(); ++k) {
    const MeshEdge& e = topology.edges[k];
    if (e.triangle[1] < 0 || feature[k]) continue;
    C1Edge edge;
    edge.vertex = {e.a, e.b, mesh.triangles[e.triangle[0]][e.corner[0]],
                   mesh.triangles[e.triangle[1]][e.corner[1]]};
    edge.edge = row_controls(mesh, e.triangle[0], e.corner[0], 0);
    edge.inner = row_controls(mesh, e.triangle[0], e.corner[0], 1);
    edge.outer = row_controls(mesh, e.triangle[1], e.corner[1], 1);
    std::reverse(edge.outer.begin(), edge.outer.end());
    out.push_back(std::move(edge));
  }
  return out;
}

std::vector<C1Edge> joint_equations(const CurvedMesh& mesh, const Joints& joints,
                                    const DomainLayout& layout, std::vector<Point>& control) {
  std::map<int, std::pair<int, int>> places;  // vertex -> (loop, position) of joints with tips
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (layout.tips[l][k].along >= 0)
        places[joints[l][k].vertex] = {static_cast<int>(l), static_cast<int>(k)};
  std::map<int, int> auxiliary;  // vertex -> id of its first auxiliary control point
  for (const auto& [vertex, place] : places) {
    const Joint& joint = joints[place.first][place.second];
    auxiliary[vertex] = static_cast<int>(control.size());
    const Point along = joint.d0 / mesh.degree, across(-along.y(), along.x());
    control.push_back(control[vertex] + along);
    control.push_back(control[vertex] + across);
  }
  std::vector<C1Edge> out;
  const MeshTopology topology(mesh);
  const std::vector<char> feature = feature_flags(mesh, topology);
  for (std::size_t i = 0; i < topology.edges.size(); ++i) {
    const MeshEdge& e = topology.edges[i];
    if (e.triangle[1] < 0 || feature[i]) continue;
    const std::vector<int> ids = row_controls(mesh, e.triangle[0], e.corner[0], 0);
    for (int side = 0; side < 2; ++side) {
      const int v = side == 0 ? e.a : e.b, other = side == 0 ? e.b : e.a;
      const auto place = places.find(v);
      if (place == places.end()) continue;
      const Tips tips = layout.tips[place->second.first][place->second.second];
      C1Edge equation;
      equation.vertex = {v, tips.along, tips.across, other};
      equation.edge = {v, auxiliary[v]};
      equation.inner = {auxiliary[v] + 1};
      equation.outer = {side == 0 ? ids[1] : ids[ids.size() - 2]};
      out.push_back(equation);
    }
  }
  return out;
}

Eigen::Vector3d barycentric(const Point& v0, const Point& v1, const Point& v2, const Point& v3) {
  const Point a = v1 - v0, b = v2 - v0, c = v3 - v0;
  const double area = cross(a, b);
  const double g1 = cross(c, b) / area, g2 = cross(a, c) / area;
  return {1 - g1 - g2, g1, g2};
}

Eigen::Vector3d edge_barycentric(const C1Edge& e, const PointMatrix& domain) {
  return barycentric(row(domain, e.vertex[0]), row(domain, e.vertex[1]), row(domain, e.vertex[2]),
                     row(domain, e.vertex[3]));
}

Eigen::Matrix<double, 2, 8> barycentric_derivative(const Point& v0, const Point& v1,
                                                   const Point& v2, const Point& v3) {
  const Point a = v1 - v0, b = v2 - v0, c = v3 - v0;
  const double area = cross(a, b);
  const Eigen::Vector3d g = barycentric(v0, v1, v2, v3);
  // Derivatives of cross(p, q): in p (q.y, -q.x), in q (-p.y, p.x).
  const auto left = [](const Point& q) { return Eigen::RowVector2d(q.y(), -q.x()); };
  const auto right = [](const Point& p) { return Eigen::RowVector2d(-p.y(), p.x()); };
  Eigen::Matrix<double, 2, 6> d;  // in a, b, c
  d.row(0) << -g[1] * left(b), right(c) - g[1] * right(a), left(b);
  d.row(1) << left(c) - g[2] * left(b), -g[2] * right(a), right(a);
  d /= area;
  Eigen::Matrix<double, 2, 8> out;
  out << -(d.leftCols<2>() + d.middleCols<2>(2) + d.rightCols<2>()), d;
  return out;
}

Point c1_residue(const C1Edge& e, int i, const Eigen::Vector3d& g,
                 const std::vector<Point>& control) {
  const Point& base = control[e.edge[i]];
  return (control[e.outer[i]] - base) - g[1] * (control[e.edge[i + 1]] - base) -
         g[2] * (control[e.inner[i]] - base);
}

double largest_residue(const std::vector<C1Edge>& edges, const PointMatrix& domain,
                       const std::vector<Point>& control) {
  double largest = 0;
  for (const C1Edge& e : edges) {
    const Eigen::Vector3d g = edge_barycentric(e, domain);
    for (std::size_t i = 0; i < e.inner.size(); ++i)
      largest = std::max(largest, c1_residue(e, static_cast<int>(i), g, control).norm());
  }
  return largest;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> c1_matrix(const std::vector<C1Edge>& edges,
                                                       const PointMatrix& domain, int controls) {
  std::vector<Eigen::Triplet<double>> triplets;
  int rows = 0;
  for (const C1Edge& e : edges) {
    const Eigen::Vector3d g = edge_barycentric(e, domain);
    for (std::size_t i = 0; i < e.inner.size(); ++i, ++rows) {
      triplets.emplace_back(rows, e.outer[i], 1);
      triplets.emplace_back(rows, e.edge[i], -g[0]);
      triplets.emplace_back(rows, e.edge[i + 1], -g[1]);
      triplets.emplace_back(rows, e.inner[i], -g[2]);
    }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> A(rows, controls);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

ProjectionReport project_to_c1(const std::vector<C1Edge>& edges, const PointMatrix& domain,
                               const std::vector<char>& fixed, const std::vector<double>& size,
                               std::vector<Point>& control) {
  const StageTimer timer("map: projection");
  ProjectionReport report;
  const int controls = static_cast<int>(control.size());
  std::vector<int> column(controls, -1), free;
  for (int k = 0; k < controls; ++k)
    if (!fixed[k]) {
      column[k] = static_cast<int>(free.size());
      free.push_back(k);
    }
  const auto A = c1_matrix(edges, domain, controls);
  // Scaled system: rows to unit norm, columns by the local size.
  std::vector<Eigen::Triplet<double>> triplets;
  std::vector<double> row_scale(A.rows());
  for (int r = 0; r < A.rows(); ++r) {
    double norm = 0;
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(A, r); it; ++it) {
      // Not std::pow(…, 2): a product in optimised builds alone, in others off by a rounding error.
      const double scaled = it.value() * size[it.col()];
      norm += scaled * scaled;
    }
    row_scale[r] = 1 / std::sqrt(norm);
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(A, r); it; ++it)
      if (column[it.col()] >= 0)
        triplets.emplace_back(r, column[it.col()], it.value() * size[it.col()] * row_scale[r]);
  }
  SparseMatrix S(A.rows(), free.size());
  S.setFromTriplets(triplets.begin(), triplets.end());
  const SparseMatrix normal = SparseMatrix(S.transpose() * S).triangularView<Eigen::Lower>();
  SparseSolver solver;
  if (!factorise_shifted(solver, normal, 1e-13)) return report;

  std::vector<Point> start = control;
  auto residues = [&](double& largest) {
    PointMatrix r(A.rows(), 2);
    largest = 0;
    for (int i = 0; i < A.rows(); ++i)
      for (int k = 0; k < 2; ++k) {
        long double sum = 0;
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(A, i); it; ++it)
          sum += static_cast<long double>(it.value()) * control[it.col()][k];
        r(i, k) = static_cast<double>(sum) * row_scale[i];
        largest = std::max(largest, std::abs(static_cast<double>(sum)));
      }
    return r;
  };
  double largest;
  PointMatrix r = residues(largest);
  report.before = report.after = largest;
  std::vector<Point> best = control;
  for (; report.rounds < 30; ++report.rounds) {
    for (int k = 0; k < 2; ++k) {
      const Eigen::VectorXd right = S.transpose() * r.col(k);
      const Eigen::VectorXd move = solver.solve(right);
      for (std::size_t j = 0; j < free.size(); ++j)
        control[free[j]][k] -= move[static_cast<Eigen::Index>(j)] * size[free[j]];
    }
    r = residues(largest);
    if (!(largest < report.after)) break;
    const bool slow = largest > 0.7 * report.after;
    report.after = largest;
    best = control;
    if (slow && report.rounds > 3) break;
  }
  control = best;
  for (int k = 0; k < controls; ++k)
    report.largest_move = std::max(report.largest_move, (control[k] - start[k]).norm());
  return report;
}

}  // namespace c1mesh
