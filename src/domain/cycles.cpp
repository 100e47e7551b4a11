// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/cycles.h"

#include <array>
#include <map>

namespace c1mesh {
namespace {

using Directed = std::array<int, 2>;

class Faces {
 public:
  explicit Faces(const CurvedMesh& mesh) : mesh_(mesh) {
    for (int t = 0; t < mesh.triangle_count(); ++t)
      for (int k = 0; k < 3; ++k)
        opposite_[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] =
            mesh.triangles[t][(k + 2) % 3];
    int path = 0;
    for (const auto& loop : mesh.loops) add_path(path++, loop, true, false);
    for (const FeatureLine& line : mesh.features) add_path(path++, line.edges, line.closed, true);
  }

  std::vector<Cycle> run() {
    std::map<Directed, bool> walked;
    for (const Directed& first : order_) {
      std::vector<Directed> open;  // the walk since it was last at each of these vertices
      std::map<int, int> place;    // of each vertex in it
      for (Directed at = first; !walked[at]; at = next(at)) {
        walked[at] = true;
        place[at[0]] = static_cast<int>(open.size());
        open.push_back(at);
        cut_back(open, place);
      }
    }
    return std::move(cycles_);
  }

 private:
  void add_path(int path, const std::vector<BoundaryEdge>& edges, bool closed, bool feature) {
    const int m = static_cast<int>(edges.size());
    for (int k = 0; k < m; ++k) {
      const BoundaryEdge& e = edges[k];
      stops_[{e.a, e.b}] = {e.a, path, k, true};
      order_.push_back({e.a, e.b});
      if (!feature) continue;
      stops_[{e.b, e.a}] = {e.b, path, closed ? (k + 1) % m : k + 1, false};
      order_.push_back({e.b, e.a});
    }
  }

  // Around the head of the edge, through the triangles on its left, to the next edge on a curve.
  Directed next(const Directed& at) const {
    for (Directed spoke = at;;) {
      const int c = opposite_.at(spoke);
      if (stops_.count({at[1], c})) return {at[1], c};
      spoke = {c, at[1]};
    }
  }

  // If the walk is back at a vertex, what came since is a cycle, or one edge to and fro.
  void cut_back(std::vector<Directed>& open, std::map<int, int>& place) {
    const auto back = place.find(open.back()[1]);
    if (back == place.end()) return;
    const auto from = open.begin() + back->second;
    if (open.end() - from > 2) add_cycle({from, open.end()});
    for (auto edge = from; edge != open.end(); ++edge) place.erase((*edge)[0]);
    open.erase(from, open.end());
  }

  void add_cycle(const std::vector<Directed>& edges) {
    Cycle cycle;
    double area = 0;
    for (const Directed& edge : edges) {
      cycle.stops.push_back(stops_.at(edge));
      const Point& origin = mesh_.control[edges[0][0]];
      area += cross(mesh_.control[edge[0]] - origin, mesh_.control[edge[1]] - origin);
    }
    cycle.inside = area > 0;
    cycles_.push_back(std::move(cycle));
  }

  const CurvedMesh& mesh_;
  std::map<Directed, int> opposite_;  // of each directed edge, the third corner on its left
  std::map<Directed, CycleStop> stops_;
  std::vector<Directed> order_;
  std::vector<Cycle> cycles_;
};

}  // namespace

std::vector<Cycle> face_cycles(const CurvedMesh& mesh) {
  return Faces(mesh).run();
}

}  // namespace c1mesh
