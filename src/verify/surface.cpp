// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace c1mesh::verification {
namespace {

void gather_edges(const Result& result, Surface& surface) {
  std::map<std::array<int, 2>, SurfaceEdge> edges;
  for (std::size_t t = 0; t < result.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int from = result.triangles[t][k], to = result.triangles[t][(k + 1) % 3];
      SurfaceEdge& edge = edges[{std::min(from, to), std::max(from, to)}];
      edge.a = std::min(from, to);
      edge.b = std::max(from, to);
      Side& side = edge.side[from < to ? 0 : 1];
      if (side.present())
        surface.faults.push_back(fmt::format("triangles {} and {} both run from vertex {} to {}",
                                             side.triangle, t, from, to));
      else
        side = {static_cast<int>(t), k};
    }
  for (const auto& [key, edge] : edges) surface.edges.push_back(edge);
}

void gather_vertices(const Result& result, Surface& surface) {
  surface.vertex_triangles.resize(result.domain_vertices.size());
  surface.on_boundary.assign(result.domain_vertices.size(), 0);
  for (std::size_t t = 0; t < result.triangles.size(); ++t)
    for (const int v : result.triangles[t])
      surface.vertex_triangles[v].push_back(static_cast<int>(t));
  for (const SurfaceEdge& edge : surface.edges)
    if (!edge.interior()) surface.on_boundary[edge.a] = surface.on_boundary[edge.b] = 1;
  for (std::size_t v = 0; v < surface.vertex_triangles.size(); ++v)
    if (surface.vertex_triangles[v].empty())
      surface.faults.push_back(fmt::format("vertex {} is in no triangle", v));
}

/// Union-find over the triangles.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) { parent_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

 private:
  std::vector<int> parent_;
};

void gather_components(const Result& result, Surface& surface) {
  Groups groups(result.triangles.size());
  for (const SurfaceEdge& edge : surface.edges)
    if (edge.interior()) groups.join(edge.side[0].triangle, edge.side[1].triangle);
  surface.component.assign(result.triangles.size(), -1);
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const int root = groups.root(static_cast<int>(t));
    surface.component[t] =
        root == static_cast<int>(t) ? surface.components++ : surface.component[root];
  }
}

/// The triangles of a vertex must be one fan: going around over shared edges reaches all of them.
void check_fans(const Result& result, Surface& surface) {
  for (std::size_t v = 0; v < surface.vertex_triangles.size(); ++v) {
    std::map<int, int> after;  // within the fan: first spoke's far vertex -> second spoke's
    std::set<int> ends;
    for (const int t : surface.vertex_triangles[v]) {
      const auto& corner = result.triangles[t];
      const int k = static_cast<int>(std::find(corner.begin(), corner.end(), v) - corner.begin());
      after[corner[(k + 1) % 3]] = corner[(k + 2) % 3];
      ends.insert(corner[(k + 2) % 3]);
    }
    if (after.empty()) continue;
    int start = after.begin()->first;
    for (const auto& [from, to] : after)
      if (!ends.count(from)) start = from;
    std::size_t reached = 0;
    for (int at = start; reached < after.size() && after.count(at); at = after[at]) {
      ++reached;
      if (after[at] == start) break;
    }
    if (reached != surface.vertex_triangles[v].size())
      surface.faults.push_back(fmt::format("the triangles at vertex {} are not one fan", v));
  }
}

void gather_loops(Surface& surface) {
  std::map<int, std::pair<int, int>> next;  // boundary: vertex -> (vertex after it, component)
  for (const SurfaceEdge& edge : surface.edges)
    for (int s = 0; s < 2; ++s)
      if (edge.side[s].present() && !edge.side[1 - s].present())
        next[s == 0 ? edge.a : edge.b] = {s == 0 ? edge.b : edge.a,
                                          surface.component[edge.side[s].triangle]};
  while (!next.empty()) {
    const int start = next.begin()->first;
    std::vector<int> loop;
    const int component = next.begin()->second.second;
    int at = start;
    for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
      loop.push_back(at);
      at = found->second.first;
      next.erase(found);
    }
    if (at != start)
      surface.faults.push_back(fmt::format("the boundary through vertex {} does not close", start));
    surface.loops.push_back(loop);
    surface.loop_component.push_back(component);
  }
}

/// Planar pieces without handles: V - E + F = 2 - loops for each component.
void check_euler(const Result& result, Surface& surface) {
  std::vector<int> count(surface.components, 0);
  for (const int c : surface.component) ++count[c];
  for (const SurfaceEdge& edge : surface.edges)
    --count[surface.component[edge.side[edge.side[0].present() ? 0 : 1].triangle]];
  for (std::size_t v = 0; v < result.domain_vertices.size(); ++v)
    if (!surface.vertex_triangles[v].empty())
      ++count[surface.component[surface.vertex_triangles[v][0]]];
  std::vector<int> loops(surface.components, 0);
  for (const int c : surface.loop_component) ++loops[c];
  for (int c = 0; c < surface.components; ++c)
    if (count[c] != 2 - loops[c])
      surface.faults.push_back(fmt::format(
          "component {} has Euler characteristic {} but {} boundary loops", c, count[c], loops[c]));
}

}  // namespace

int Surface::find_edge(int a, int b) const {
  const std::array<int, 2> key{std::min(a, b), std::max(a, b)};
  const auto found =
      std::lower_bound(edges.begin(), edges.end(), key, [](const SurfaceEdge& e, const auto& k) {
        return std::array<int, 2>{e.a, e.b} < k;
      });
  if (found == edges.end() || found->a != key[0] || found->b != key[1]) return -1;
  return static_cast<int>(found - edges.begin());
}

Surface surface_of(const Result& result) {
  Surface surface;
  gather_edges(result, surface);
  gather_vertices(result, surface);
  gather_components(result, surface);
  check_fans(result, surface);
  gather_loops(surface);
  if (surface.faults.empty()) check_euler(result, surface);
  return surface;
}

}  // namespace c1mesh::verification
