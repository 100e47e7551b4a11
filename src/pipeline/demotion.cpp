// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/demotion.h"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "mesh/nearest_point.h"
#include "mesh/split.h"

namespace c1mesh {
namespace {

// What giving up a vertex is worth, as a factor on its distance: a smooth vertex must be much
// nearer than a corner to be chosen, because it adds a corner to the domain.
double reluctance(const Joint& joint, Role role) {
  if (role == Role::flat) return 8;
  if (joint.kind == JointKind::corner) return joint.convex() == (joint.loop == 0) ? 2 : 1;
  return 1;
}

// Halves all edges at a vertex, at a cost that does not depend on the mesh.
class Grader {
 public:
  explicit Grader(CurvedMesh& mesh) : mesh_(mesh), splitter_(mesh), at_(mesh.vertex_count()) {
    for (auto& loop : mesh.loops) add_path(loop, false);
    for (FeatureLine& line : mesh.features) add_path(line.edges, true);
  }

  /// Puts the paths together again.
  ~Grader() {
    for (const Path& path : paths_) {
      path.edges->clear();
      for (int i = path.first; i >= 0; i = links_[i].next) path.edges->push_back(links_[i].edge);
    }
  }
  Grader(const Grader&) = delete;
  Grader& operator=(const Grader&) = delete;

  void halve_fan(int corner) {
    std::vector<int> on_features, on_loops;
    std::set<int> along;  // the other ends of edges on curves
    for (const int link : at_[corner])
      (paths_[links_[link].path].feature ? on_features : on_loops).push_back(link);
    // Feature by feature, loop by loop, from the last edge to the first.
    for (auto* links : {&on_features, &on_loops}) {
      std::sort(links->begin(), links->end(), [&](int i, int j) {
        const Link &a = links_[i], &b = links_[j];
        return a.path != b.path ? a.path < b.path : a.order > b.order;
      });
      for (const int link : *links) along.insert(halve(link));
    }
    for (const int end : inner_ends(corner, along)) splitter_.split_edge(corner, end);
  }

 private:
  struct Path {
    std::vector<BoundaryEdge>* edges;
    bool feature;
    int first;
  };
  // An edge in the list of its path; `order` is the place of the edge of which it is a part.
  struct Link {
    BoundaryEdge edge;
    int path, order, next;
  };

  void add_path(std::vector<BoundaryEdge>& edges, bool feature) {
    const int path = static_cast<int>(paths_.size()), first = static_cast<int>(links_.size());
    const int count = static_cast<int>(edges.size());
    paths_.push_back({&edges, feature, first});
    for (int k = 0; k < count; ++k) {
      at_[edges[k].a].push_back(first + k);
      at_[edges[k].b].push_back(first + k);
      links_.push_back({edges[k], path, k, k + 1 < count ? first + k + 1 : -1});
    }
  }

  // Returns the new vertex. The first half stays where it is in the list.
  int halve(int link) {
    const auto parts = splitter_.halve(links_[link].edge, paths_[links_[link].path].feature);
    const int second = static_cast<int>(links_.size());
    std::vector<int>& at_end = at_[links_[link].edge.b];
    *std::find(at_end.begin(), at_end.end(), link) = second;
    links_.push_back({parts[1], links_[link].path, links_[link].order, links_[link].next});
    links_[link].edge = parts[0];
    links_[link].next = second;
    at_.resize(parts[0].b + 1);
    at_[parts[0].b] = {link, second};
    return parts[0].b;
  }

  // Ends of the edges at the corner that are on no curve, in the order in which MeshTopology
  // numbers edges.
  std::vector<int> inner_ends(int corner, const std::set<int>& along) const {
    std::vector<int> triangles = splitter_.triangles_at(corner), ends;
    std::sort(triangles.begin(), triangles.end());
    for (const int t : triangles)
      for (const int k : {2, 0, 1}) {
        const auto& v = mesh_.triangles[t];
        const int a = v[(k + 1) % 3], b = v[(k + 2) % 3];
        if (a != corner && b != corner) continue;
        const int end = a == corner ? b : a;
        if (!along.count(end) && std::find(ends.begin(), ends.end(), end) == ends.end())
          ends.push_back(end);
      }
    return ends;
  }

  CurvedMesh& mesh_;
  MeshSplitter splitter_;
  std::vector<std::vector<int>> at_;  // per vertex: its edges on curves
  std::vector<Path> paths_;
  std::vector<Link> links_;
};

}  // namespace

int demote_near(const CurvedMesh& mesh, const Joints& joints, const std::vector<int>& trouble,
                int count, Roles& roles) {
  std::vector<Point> where;
  for (int v : trouble) where.push_back(mesh.domain[v]);
  const NearestPoint places(std::move(where));
  // (distance, loop, position), so that ties are settled the same way every time.
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      if (gives_up_c1(roles[l][k])) continue;
      const double nearest = places.distance(mesh.domain[joints[l][k].vertex]) + 1e-3;
      order.emplace_back(nearest * reluctance(joints[l][k], roles[l][k]), l, k);
    }
  std::sort(order.begin(), order.end());
  const int changed = std::min(count, static_cast<int>(order.size()));
  for (int i = 0; i < changed; ++i)
    roles[std::get<1>(order[i])][std::get<2>(order[i])] = Role::released;
  return changed;
}

void grade_corners(CurvedMesh& mesh, const Joints& joints, const Roles& roles, int levels) {
  std::vector<int> corners;
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if (joints[l][k].kind == JointKind::corner && roles[l][k] == Role::anchor)
        corners.push_back(joints[l][k].vertex);
  Grader grader(mesh);
  for (; levels > 0; --levels)
    for (const int corner : corners) grader.halve_fan(corner);
}

void demote_all_joints(const Joints& joints, Roles& roles) {
  for (std::size_t l = 0; l < joints.size(); ++l)
    for (std::size_t k = 0; k < joints[l].size(); ++k)
      if ((joints[l][k].kind == JointKind::corner || joints[l][k].kind == JointKind::mild) &&
          !joints[l][k].branch)
        roles[l][k] = Role::released;
}

}  // namespace c1mesh
