// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/bisect.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "mesh/split.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

constexpr double kWide = 0.44;  // radians: 25 degrees

// One pass: a set of edges no two of which touch the same triangle.
class Pass {
 public:
  Pass(const CurvedMesh& mesh, const std::vector<char>& wide_at)
      : mesh_(mesh), topology_(mesh), wide_at_(wide_at), taken_(mesh.triangle_count(), 0) {}

  // Follows longest edges from the triangle to one that is longest on both sides (or stays, if not
  // `far`), and takes it unless another edge of its triangles is taken.
  void choose(int t, bool far) {
    int edge = cut_through_corner(t);
    if (edge < 0) {
      edge = longest(t);
      while (far) {
        const int other = across(edge, t);
        if (other < 0 || longest(other) == edge) break;
        t = other;
        edge = longest(t);
      }
    }
    const MeshEdge& e = topology_.edges[edge];
    for (int side : e.triangle)
      if (side >= 0 && taken_[side]) return;
    for (int side : e.triangle)
      if (side >= 0) taken_[side] = 1;
    edges_.push_back(edge);
  }

  bool was_cut(int t) const { return taken_[t]; }

  void apply(CurvedMesh& mesh) const {
    std::set<std::pair<int, int>> left;  // of the chosen edges, those on no curve
    for (int edge : edges_) left.insert(ends(topology_.edges[edge].a, topology_.edges[edge].b));
    const auto loops = places_of(
        mesh.loops.size(), left, [&](std::size_t l) -> auto& { return mesh.loops[l]; });
    const auto features = places_of(
        mesh.features.size(), left, [&](std::size_t l) -> auto& { return mesh.features[l].edges; });
    MeshSplitter splitter(mesh);
    for (const auto& [a, b] : left) splitter.split_edge(a, b);
    for (const auto& [loop, indices] : loops) splitter.halve_all(mesh.loops[loop], indices, false);
    for (const auto& [line, indices] : features)
      splitter.halve_all(mesh.features[line].edges, indices, true);
  }

 private:
  static std::pair<int, int> ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

  // Takes the edges on these paths out of `chosen`; (path, its edges' indices), all from the last
  // to the first.
  template <class EdgesOf>
  static std::vector<std::pair<int, std::vector<int>>> places_of(
      std::size_t paths, std::set<std::pair<int, int>>& chosen, const EdgesOf& edges_of) {
    std::vector<std::pair<int, std::vector<int>>> places;
    for (std::size_t l = paths; l-- > 0;) {
      std::vector<int> indices;
      for (std::size_t k = edges_of(l).size(); k-- > 0;)
        if (chosen.erase(ends(edges_of(l)[k].a, edges_of(l)[k].b)))
          indices.push_back(static_cast<int>(k));
      if (!indices.empty()) places.emplace_back(static_cast<int>(l), std::move(indices));
    }
    return places;
  }

  double length(int edge) const {
    const MeshEdge& e = topology_.edges[edge];
    return (mesh_.domain[e.a] - mesh_.domain[e.b]).norm() *
           (mesh_.control[e.a] - mesh_.control[e.b]).norm();
  }
  // Ties go to the lower edge number, so that the walk ends.
  int longest(int t) const {
    int best = -1;
    for (int edge : topology_.triangle_edges[t])
      if (best < 0 || std::make_pair(length(edge), -edge) > std::make_pair(length(best), -best))
        best = edge;
    return best;
  }
  int across(int edge, int t) const {
    const auto& sides = topology_.edges[edge].triangle;
    return sides[0] == t ? sides[1] : sides[0];
  }
  int cut_through_corner(int t) const {
    const auto& v = mesh_.triangles[t];
    for (int k = 0; k < 3; ++k) {
      if (!wide_at_[v[k]]) continue;
      const Point a = mesh_.domain[v[(k + 1) % 3]] - mesh_.domain[v[k]];
      const Point b = mesh_.domain[v[(k + 2) % 3]] - mesh_.domain[v[k]];
      if (std::atan2(cross(a, b), a.dot(b)) > kWide) return topology_.triangle_edges[t][k];
    }
    return -1;
  }

  const CurvedMesh& mesh_;
  const MeshTopology topology_;
  const std::vector<char>& wide_at_;
  std::vector<char> taken_;
  std::vector<int> edges_;
};

}  // namespace

void bisect_triangles(CurvedMesh& mesh, const std::vector<int>& chosen,
                      const std::vector<char>& wide_at) {
  std::vector<int> left = chosen;
  std::vector<char> wide = wide_at;
  // A walk may cut far away many times before it comes back to the chosen triangle; after a few
  // passes what is left is cut directly, at least one triangle a pass.
  constexpr int kPatience = 4;
  for (int round = 0; !left.empty(); ++round) {
    wide.resize(mesh.vertex_count(), 0);
    Pass pass(mesh, wide);
    for (int t : left) pass.choose(t, round < kPatience);
    std::erase_if(left, [&](int t) { return pass.was_cut(t); });
    pass.apply(mesh);
  }
}

}  // namespace c1mesh
