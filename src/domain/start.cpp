// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "c1mesh/cost.h"
#include "linear/sparse_solver.h"
#include "mesh/box_pairs.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

// The graph of the mesh, with one virtual centre per hole if asked for.
std::vector<std::array<int, 2>> graph_edges(const CurvedMesh& mesh, bool fill_holes) {
  std::vector<std::array<int, 2>> edges;
  const MeshTopology topology(mesh);
  for (const MeshEdge& e : topology.edges) edges.push_back({e.a, e.b});
  if (fill_holes)
    for (std::size_t l = 1; l < mesh.loops.size(); ++l)
      for (const BoundaryEdge& e : mesh.loops[l])
        edges.push_back({e.a, mesh.vertex_count() + static_cast<int>(l) - 1});
  return edges;
}

// Every free node at the average of its neighbours; `points` holds the fixed ones.
void solve_average(const std::vector<std::array<int, 2>>& edges, const std::vector<char>& fixed,
                   PointMatrix& points) {
  std::vector<int> index(fixed.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i)
    if (!fixed[i]) index[i] = count++;
  if (count == 0) return;
  std::vector<Eigen::Triplet<double>> triplets;
  PointMatrix right = PointMatrix::Zero(count, 2);
  for (const auto& e : edges)
    for (int side = 0; side < 2; ++side) {
      const int a = e[side], b = e[1 - side];
      if (fixed[a]) continue;
      triplets.emplace_back(index[a], index[a], 1);
      if (fixed[b])
        right.row(index[a]) += points.row(b);
      else if (index[a] > index[b])
        triplets.emplace_back(index[a], index[b], -1);
    }
  SparseMatrix laplacian(count, count);
  laplacian.setFromTriplets(triplets.begin(), triplets.end());
  SparseSolver solver;
  if (!factorise_shifted(solver, laplacian, 1e-14)) return;
  for (int k = 0; k < 2; ++k) {
    const Eigen::VectorXd solution = solver.solve(right.col(k));
    for (std::size_t i = 0; i < fixed.size(); ++i)
      if (!fixed[i]) points(static_cast<Eigen::Index>(i), k) = solution[index[i]];
  }
}

// Chain ends on a circle (convex ones) or on the chords between them (all others), at angles
// proportional to the boundary's length.
void place_on_convex_polygon(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                             PointMatrix& points) {
  const auto& loop = joints[0];
  const int m = static_cast<int>(loop.size());
  std::vector<double> length(m + 1, 0);
  for (int k = 0; k < m; ++k)
    length[k + 1] =
        length[k] + (mesh.domain[loop[(k + 1) % m].vertex] - mesh.domain[loop[k].vertex]).norm();
  std::vector<int> corners;
  for (int k = 0; k < m; ++k) {
    const bool convex = loop[k].kind == JointKind::corner
                            ? loop[k].convex()
                            : roles[0][k] == Role::exceptional || roles[0][k] == Role::branch;
    if (ends_chain(roles[0][k]) && convex) corners.push_back(k);
  }
  const int count = static_cast<int>(corners.size());
  const double radius = length[m] / (2 * std::numbers::pi);
  auto on_circle = [&](int c) {
    // Between even spacing and spacing by length, so that no chord degenerates.
    const double even = double(c) / count;
    const double by_length =
        (length[corners[c % count]] - length[corners[0]] + (c >= count ? length[m] : 0)) /
        length[m];
    const double angle = std::numbers::pi * (even + by_length);
    return Point(radius * std::cos(angle), radius * std::sin(angle));
  };
  for (int c = 0; c < count; ++c) {
    const int from = corners[c], to = c + 1 < count ? corners[c + 1] : corners[0] + m;
    const Point a = on_circle(c), b = on_circle(c + 1);
    const double whole = (to >= m ? length[to - m] + length[m] : length[to]) - length[from];
    for (int k = from; k < to; ++k) {
      const double at = (k >= m ? length[k - m] + length[m] : length[k]) - length[from];
      points.row(loop[k % m].vertex) = ((1 - at / whole) * a + at / whole * b).transpose();
    }
  }
}

}  // namespace

PointMatrix unknowns_near_points(const PointMatrix& wanted, const Joints& joints,
                                 const DomainLayout& layout) {
  PointMatrix unknowns = PointMatrix::Zero(layout.unknowns(), 2);
  for (Eigen::Index v = 0; v < wanted.rows(); ++v)
    if (layout.unknown_of_row[v] >= 0) unknowns.row(layout.unknown_of_row[v]) = wanted.row(v);
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      const int unknown = layout.bend_unknown[l][k];
      if (unknown < 0) continue;
      const Eigen::RowVector2d e =
          wanted.row(joints[l][k].vertex) - wanted.row(joints[l][k].previous);
      unknowns.row(unknown) << -e.y(), e.x();
    }
  return unknowns;
}

PointMatrix domain_points(const CurvedMesh& mesh) {
  PointMatrix points(mesh.vertex_count(), 2);
  for (int v = 0; v < mesh.vertex_count(); ++v) points.row(v) = mesh.domain[v].transpose();
  return points;
}

void set_domain(CurvedMesh& mesh, const PointMatrix& points) {
  for (int v = 0; v < mesh.vertex_count(); ++v) mesh.domain[v] = points.row(v).transpose();
}

DomainShape shape_of_domain(int vertices, const Joints& joints, const DomainLayout& layout,
                            const PointMatrix& unknowns) {
  DomainShape shape;
  shape.points = (layout.exact * unknowns).topRows(vertices);
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (const int unknown = layout.bend_unknown[l][k]; unknown >= 0)
        shape.bends[joints[l][k].vertex] = {unknowns.row(unknown).transpose(),
                                            joints[l][k].d0.norm()};
  return shape;
}

PointMatrix unknowns_of_shape(const DomainShape& shape, const Joints& joints,
                              const DomainLayout& layout) {
  const PointMatrix& points = shape.points;
  PointMatrix unknowns = unknowns_near_points(points, joints, layout);
  for (std::size_t l = 0; l < joints.size(); ++l) {
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      const int unknown = layout.bend_unknown[l][k];
      if (unknown < 0) continue;
      const Joint& joint = joints[l][k];
      if (const auto known = shape.bends.find(joint.vertex); known != shape.bends.end()) {
        // w scales with d0, which refinement halves.
        const double scale = joint.d0.norm() / known->second.length;
        unknowns.row(unknown) = scale * known->second.w.transpose();
        continue;
      }
      const Eigen::RowVector2d v = points.row(joint.vertex);
      const Eigen::RowVector2d in = v - points.row(joint.previous);
      const Eigen::RowVector2d out = points.row(joint.next) - v;
      unknowns.row(unknown) = (out - joint.ratio * in) / joint.kappa;
    }
  }
  return unknowns;
}

PointMatrix start_positions(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                            const DomainLayout& layout, Start start) {
  const StageTimer timer("map: start");
  const int vertices = mesh.vertex_count();
  const PointMatrix initial = domain_points(mesh);
  PointMatrix wanted = initial;
  if (start == Start::convex) {
    const int holes = static_cast<int>(mesh.loops.size()) - 1;
    PointMatrix points = PointMatrix::Zero(vertices + holes, 2);
    std::vector<char> fixed(vertices + holes, 0);
    place_on_convex_polygon(mesh, joints, roles, points);
    for (const Joint& joint : joints[0]) fixed[joint.vertex] = 1;
    solve_average(graph_edges(mesh, true), fixed, points);
    wanted = points.topRows(vertices);
  }
  PointMatrix unknowns = unknowns_near_points(wanted, joints, layout);
  // The boundary is now where the chains put it; let the interior follow.
  const PointMatrix placed = (layout.exact * unknowns).topRows(vertices);
  PointMatrix points = start == Start::shape ? PointMatrix(placed - initial) : placed;
  std::vector<char> fixed(vertices, 0);
  for (const auto& loop : joints)
    for (const Joint& joint : loop) fixed[joint.vertex] = 1;
  solve_average(graph_edges(mesh, false), fixed, points);
  if (start == Start::shape) points += initial;
  for (int v = 0; v < vertices; ++v)
    if (!fixed[v]) unknowns.row(layout.unknown_of_row[v]) = points.row(v);
  return unknowns;
}

std::vector<int> winding_faults(const CurvedMesh& mesh, const PointMatrix& points) {
  std::vector<double> angle(mesh.vertex_count(), 0);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Point a = points.row(t[(k + 1) % 3]) - points.row(t[k]);
      const Point b = points.row(t[(k + 2) % 3]) - points.row(t[k]);
      angle[t[k]] += std::atan2(cross(a, b), a.dot(b));
    }
  std::vector<char> boundary(mesh.vertex_count(), 0);
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& e : loop) boundary[e.a] = 1;
  const double full = 2 * std::numbers::pi;
  std::vector<int> faults;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (boundary[v] ? angle[v] > full : std::abs(angle[v] - full) > 1e-3) faults.push_back(v);
  return faults;
}

int boundary_crossings(const CurvedMesh& mesh, const PointMatrix& points) {
  return static_cast<int>(crossing_vertices(mesh, points).size() / 4);
}

std::vector<int> crossing_vertices(const CurvedMesh& mesh, const PointMatrix& points) {
  const StageTimer timer("map: crossings");
  struct Segment {
    int a, b;
    Point p, q;
  };
  std::vector<Segment> segments;
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& e : loop)
      segments.push_back({e.a, e.b, points.row(e.a), points.row(e.b)});
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) {
    const double x = std::min(s.p.x(), s.q.x()), y = std::min(t.p.x(), t.q.x());
    return x != y ? x < y : s.a < t.a;
  });
  std::vector<meshing::Box> boxes;
  for (const Segment& s : segments) {
    boxes.emplace_back(s.p);
    boxes.back().extend(s.q);
  }
  std::vector<int> all(segments.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::pair<int, int>> pairs = meshing::meeting_pairs(boxes, all);
  std::sort(pairs.begin(), pairs.end());
  std::vector<int> crossings;
  for (const auto& [i, j] : pairs) {
    const Segment &s = segments[i], &t = segments[j];
    if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) continue;
    const double o1 = cross(s.q - s.p, t.p - s.p), o2 = cross(s.q - s.p, t.q - s.p);
    const double o3 = cross(t.q - t.p, s.p - t.p), o4 = cross(t.q - t.p, s.q - t.p);
    if ((o1 > 0) != (o2 > 0) && (o3 > 0) != (o4 > 0))
      crossings.insert(crossings.end(), {s.a, s.b, t.a, t.b});
  }
  return crossings;
}

}  // namespace c1mesh
