// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace c1mesh {
namespace {

// A half-edge with its ends in increasing order: sorting brings the two sides of an edge together.
struct HalfEdge {
  int low, high, triangle, corner;
  auto key() const { return std::tie(low, high, triangle, corner); }
  bool operator<(const HalfEdge& other) const { return key() < other.key(); }
  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> sorted_half_edges(const CurvedMesh& mesh) {
  std::vector<HalfEdge> out;
  out.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][(k + 1) % 3], b = mesh.triangles[t][(k + 2) % 3];
      out.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

MeshTopology::MeshTopology(const CurvedMesh& mesh) {
  const int triangles = mesh.triangle_count();
  const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
  // For each half-edge its partner, then number the edges in triangle order.
  std::vector<std::array<int, 3>> partner(triangles, {-1, -1, -1});
  for (std::size_t i = 0; i < halves.size(); ++i)
    if (i + 1 < halves.size() && halves[i].same_edge(halves[i + 1])) {
      partner[halves[i].triangle][halves[i].corner] = static_cast<int>(i + 1);
      partner[halves[i + 1].triangle][halves[i + 1].corner] = static_cast<int>(i);
      ++i;
    }
  triangle_edges.assign(triangles, {-1, -1, -1});
  vertex_triangles.resize(mesh.domain.size());
  on_boundary.assign(mesh.domain.size(), 0);
  for (int t = 0; t < triangles; ++t) {
    for (int v : mesh.triangles[t]) vertex_triangles[v].push_back(t);
    for (int k : {2, 0, 1}) {
      if (triangle_edges[t][k] >= 0) continue;
      MeshEdge edge;
      edge.a = mesh.triangles[t][(k + 1) % 3];
      edge.b = mesh.triangles[t][(k + 2) % 3];
      edge.triangle[0] = t;
      edge.corner[0] = k;
      triangle_edges[t][k] = static_cast<int>(edges.size());
      if (partner[t][k] >= 0) {
        const HalfEdge& other = halves[partner[t][k]];
        edge.triangle[1] = other.triangle;
        edge.corner[1] = other.corner;
        triangle_edges[other.triangle][other.corner] = static_cast<int>(edges.size());
      } else {
        on_boundary[edge.a] = on_boundary[edge.b] = 1;
      }
      edges.push_back(edge);
    }
  }
}

std::vector<char> feature_flags(const CurvedMesh& mesh, const MeshTopology& topology) {
  std::vector<char> out(topology.edges.size(), 0);
  for (const FeatureLine& line : mesh.features)
    for (const BoundaryEdge& f : line.edges)
      for (const int t : topology.vertex_triangles[f.a])
        for (const int e : topology.triangle_edges[t])
          if (std::minmax(topology.edges[e].a, topology.edges[e].b) == std::minmax(f.a, f.b))
            out[e] = 1;
  return out;
}

std::vector<char> on_curves(const CurvedMesh& mesh) {
  std::vector<char> out(mesh.domain.size(), 0);
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& e : loop) out[e.a] = out[e.b] = 1;
  for (const FeatureLine& line : mesh.features)
    for (const BoundaryEdge& e : line.edges) out[e.a] = out[e.b] = 1;
  return out;
}

std::vector<int> edge_controls(const CurvedMesh& mesh, int t, int k) {
  const int n = mesh.degree;
  std::vector<int> ids(n + 1);
  for (int i = 0; i <= n; ++i) {
    if (k == 2) ids[i] = mesh.control_id(t, i, 0);
    if (k == 0) ids[i] = mesh.control_id(t, n - i, i);
    if (k == 1) ids[i] = mesh.control_id(t, 0, n - i);
  }
  return ids;
}

Net net_of(const CurvedMesh& mesh, int t) {
  Net net(mesh.net_size());
  for (int k = 0; k < mesh.net_size(); ++k)
    net[k] = mesh.control[mesh.nets[t * mesh.net_size() + k]];
  return net;
}

double triangle_bound(const CurvedMesh& mesh, int t) {
  const auto& v = mesh.triangles[t];
  return distortion_bound(JacobianTables::of(mesh.degree), net_of(mesh, t),
                          mesh.domain[v[1]] - mesh.domain[v[0]],
                          mesh.domain[v[2]] - mesh.domain[v[0]]);
}

namespace {

bool check_indices(const CurvedMesh& mesh, std::vector<std::string>& wrong) {
  const std::size_t before = wrong.size();
  const int vertices = mesh.vertex_count(), controls = static_cast<int>(mesh.control.size());
  if (mesh.degree < 1) wrong.push_back("degree below 1");
  if (controls < vertices) wrong.push_back("fewer control points than vertices");
  if (mesh.nets.size() != mesh.triangles.size() * mesh.net_size())
    wrong.push_back("nets and triangles differ in number");
  if (mesh.warped.size() != mesh.triangles.size())
    wrong.push_back("warped flags and triangles differ in number");
  if (wrong.size() > before) return false;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto& v = mesh.triangles[t];
    if (std::any_of(v.begin(), v.end(), [&](int i) { return i < 0 || i >= vertices; }) ||
        v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      wrong.push_back(fmt::format("triangle {}: bad vertex ids", t));
    const int* net = &mesh.nets[t * mesh.net_size()];
    if (std::any_of(net, net + mesh.net_size(), [&](int i) { return i < 0 || i >= controls; }))
      wrong.push_back(fmt::format("triangle {}: control id out of range", t));
  }
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& e : loop)
      if (e.a < 0 || e.b < 0 || e.a >= vertices || e.b >= vertices)
        wrong.push_back("boundary edge: vertex id out of range");
  return wrong.size() == before;
}

void check_triangles(const CurvedMesh& mesh, std::vector<std::string>& wrong) {
  const int n = mesh.degree;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto& v = mesh.triangles[t];
    if (mesh.control_id(t, 0, 0) != v[0] || mesh.control_id(t, n, 0) != v[1] ||
        mesh.control_id(t, 0, n) != v[2])
      wrong.push_back(fmt::format("triangle {}: the net's corners are not its vertices", t));
    if (!(cross(mesh.domain[v[1]] - mesh.domain[v[0]], mesh.domain[v[2]] - mesh.domain[v[0]]) > 0))
      wrong.push_back(fmt::format("triangle {}: domain area not positive", t));
    const double least = det_coefficients(JacobianTables::of(n), net_of(mesh, t)).minCoeff();
    if (!(least > 0))
      wrong.push_back(fmt::format("triangle {}: det coefficient {} not positive", t, least));
  }
}

void check_edges(const CurvedMesh& mesh, const MeshTopology& topology,
                 std::vector<std::string>& wrong) {
  const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
  for (std::size_t i = 2; i < halves.size(); ++i)
    if (halves[i].same_edge(halves[i - 2]))
      wrong.push_back(fmt::format("edge {}-{}: three triangles", halves[i].low, halves[i].high));
  for (const MeshEdge& e : topology.edges) {
    if (e.triangle[1] < 0) continue;
    if (mesh.triangles[e.triangle[1]][(e.corner[1] + 1) % 3] != e.b)
      wrong.push_back(fmt::format("edge {}-{}: both triangles on one side", e.a, e.b));
    std::vector<int> first = edge_controls(mesh, e.triangle[0], e.corner[0]);
    std::vector<int> second = edge_controls(mesh, e.triangle[1], e.corner[1]);
    std::reverse(second.begin(), second.end());
    if (first != second) wrong.push_back(fmt::format("edge {}-{}: control ids differ", e.a, e.b));
  }
}

// Each vertex must have one fan: a disk around it inside, a half disk on the boundary.
void check_fans(const CurvedMesh& mesh, const MeshTopology& topology,
                std::vector<std::string>& wrong) {
  std::vector<int> degree(mesh.domain.size(), 0);
  for (const MeshEdge& e : topology.edges) ++degree[e.a], ++degree[e.b];
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const int triangles = static_cast<int>(topology.vertex_triangles[v].size());
    if (triangles == 0)
      wrong.push_back(fmt::format("vertex {}: in no triangle", v));
    else if (degree[v] - triangles != (topology.on_boundary[v] ? 1 : 0))
      wrong.push_back(fmt::format("vertex {}: more than one fan", v));
  }
}

void check_loops(const CurvedMesh& mesh, const MeshTopology& topology,
                 std::vector<std::string>& wrong) {
  std::vector<std::array<int, 2>> from_loops, from_triangles;
  for (std::size_t k = 0; k < mesh.loops.size(); ++k) {
    const auto& loop = mesh.loops[k];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i].b != loop[(i + 1) % loop.size()].a)
        wrong.push_back(fmt::format("loop {}: edge {} does not meet the next one", k, i));
      if (loop[i].curve < 0 || loop[i].t0 == loop[i].t1)
        wrong.push_back(fmt::format("loop {}: edge {} lies on no curve", k, i));
      from_loops.push_back({loop[i].a, loop[i].b});
    }
  }
  for (const MeshEdge& e : topology.edges)
    if (e.triangle[1] < 0) from_triangles.push_back({e.a, e.b});
  std::sort(from_loops.begin(), from_loops.end());
  std::sort(from_triangles.begin(), from_triangles.end());
  if (from_loops != from_triangles)
    wrong.push_back("the loops are not the edges that have one triangle");
}

// Feature edges are interior edges, each on one feature, and follow one another.
void check_features(const CurvedMesh& mesh, const MeshTopology& topology,
                    std::vector<std::string>& wrong) {
  std::vector<std::array<int, 2>> interior, seen;
  for (const MeshEdge& e : topology.edges)
    if (e.triangle[1] >= 0) interior.push_back({std::min(e.a, e.b), std::max(e.a, e.b)});
  std::sort(interior.begin(), interior.end());
  for (std::size_t f = 0; f < mesh.features.size(); ++f) {
    const auto& edges = mesh.features[f].edges;
    if (edges.empty()) wrong.push_back(fmt::format("feature {}: no edges", f));
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const std::array<int, 2> key{std::min(edges[i].a, edges[i].b),
                                   std::max(edges[i].a, edges[i].b)};
      if (!std::binary_search(interior.begin(), interior.end(), key))
        wrong.push_back(fmt::format("feature {}: edge {} is no interior edge", f, i));
      if (edges[i].curve < 0 || edges[i].t0 == edges[i].t1)
        wrong.push_back(fmt::format("feature {}: edge {} lies on no curve", f, i));
      const bool last = i + 1 == edges.size();
      if ((!last || mesh.features[f].closed) && edges[i].b != edges[last ? 0 : i + 1].a)
        wrong.push_back(fmt::format("feature {}: edge {} does not meet the next one", f, i));
      seen.push_back(key);
    }
  }
  std::sort(seen.begin(), seen.end());
  if (std::adjacent_find(seen.begin(), seen.end()) != seen.end())
    wrong.push_back("an edge lies on two features");
}

void check_connected(const CurvedMesh& mesh, const MeshTopology& topology,
                     std::vector<std::string>& wrong) {
  std::vector<int> root(mesh.domain.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  int pieces = mesh.vertex_count();
  for (const MeshEdge& e : topology.edges) {
    const int a = find(e.a), b = find(e.b);
    if (a != b) root[std::max(a, b)] = std::min(a, b), --pieces;
  }
  if (pieces != 1) wrong.push_back(fmt::format("{} connected pieces", pieces));
  const int euler =
      mesh.vertex_count() - static_cast<int>(topology.edges.size()) + mesh.triangle_count();
  if (euler != 2 - static_cast<int>(mesh.loops.size()))
    wrong.push_back(fmt::format("Euler characteristic {} with {} loops", euler, mesh.loops.size()));
}

}  // namespace

std::vector<std::string> check_mesh(const CurvedMesh& mesh) {
  std::vector<std::string> wrong;
  if (!check_indices(mesh, wrong)) return wrong;
  const MeshTopology topology(mesh);
  check_triangles(mesh, wrong);
  check_edges(mesh, topology, wrong);
  check_fans(mesh, topology, wrong);
  check_loops(mesh, topology, wrong);
  check_features(mesh, topology, wrong);
  check_connected(mesh, topology, wrong);
  return wrong;
}

}  // namespace c1mesh
