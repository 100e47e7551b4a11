// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/bisect.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
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
    std::vector<std::pair<int, int>> inner;
    std::map<std::pair<int, int>, bool> boundary;
    for (int edge : edges_) {
      const MeshEdge& e = topology_.edges[edge];
      if (e.triangle[1] >= 0)
        inner.emplace_back(e.a, e.b);
      else
        boundary[{e.a, e.b}] = true;
    }
    std::vector<std::pair<int, int>>
        places;  // from the last to the first: splits shift what follows
    for (int l = static_cast<int>(mesh.loops.size()); l-- > 0;)
      for (int k = static_cast<int>(mesh.loops[l].size()); k-- > 0;)
        if (boundary.contains({mesh.loops[l][k].a, mesh.loops[l][k].b})) places.emplace_back(l, k);
    MeshSplitter splitter(mesh);
    for (const auto& [a, b] : inner) splitter.split_edge(a, b);
    for (const auto& [loop, index] : places) splitter.split_boundary_edge(loop, index);
  }

 private:
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
  // Halving does not always shorten an edge whose image is curved, so the walks may go on for ever;
  // after a few passes what is left is cut directly, at least one triangle a pass.
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
