// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/straighten.h"

#include <algorithm>
#include <cmath>

#include "bernstein/jacobian.h"
#include "domain/apart.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

// One path's straightening; `chain` is a run of positions, ends included.
class Straightener {
 public:
  Straightener(const CurvedMesh& initial, const Joints& joints, const Pair& state,
               const StraightenOptions& options)
      : initial_(initial),
        joints_(joints),
        state_(state),
        options_(options),
        tables_(JacobianTables::of(initial.degree)),
        around_(MeshTopology(initial).vertex_triangles) {
    out_.domain = state.domain;
    out_.corner.assign(initial.vertex_count(), 0);
  }

  Straightened run() {
    for (const auto& path : joints_)
      for (const Joint& joint : path)
        if (is_shape_corner(joint)) out_.corner[joint.vertex] = 1;
    for (std::size_t l = 0; l < joints_.size(); ++l) straighten_path(l);
    const Point low = out_.domain.colwise().minCoeff(), high = out_.domain.colwise().maxCoeff();
    out_.largest_move /= (high - low).maxCoeff();
    return std::move(out_);
  }

 private:
  bool is_loop(std::size_t l) const {
    return l < initial_.loops.size() || initial_.features[l - initial_.loops.size()].closed;
  }
  Point at(int v) const { return out_.domain.row(v).transpose(); }

  // The exterior angle, positive where the boundary turns left.
  double turn(const Joint& j) const {
    if (j.previous < 0 || j.next < 0) return 0;
    const Point before = at(j.vertex) - at(j.previous), after = at(j.next) - at(j.vertex);
    return std::atan2(cross(before, after), before.dot(after));
  }

  // A closed polygon needs three corners that turn the way it turns as a whole.
  void mark_sharpest(const std::vector<Joint>& path) {
    double whole = 0;
    int marked = 0;
    for (const Joint& j : path) whole += turn(j);
    std::vector<std::pair<double, int>> sharp;
    for (const Joint& j : path) {
      const double t = std::copysign(1.0, whole) * turn(j);
      if (out_.corner[j.vertex])
        marked += t > 0;
      else
        sharp.emplace_back(-t, j.vertex);
    }
    std::sort(sharp.begin(), sharp.end());
    for (std::size_t k = 0; k < sharp.size() && marked < 3; ++k, ++marked)
      out_.corner[sharp[k].second] = 1;
  }

  void straighten_path(std::size_t l) {
    const auto& path = joints_[l];
    const int count = static_cast<int>(path.size());
    std::vector<int> chain;  // positions
    if (!is_loop(l)) {
      for (int k = 0; k < count; ++k) chain.push_back(k);
      out_.corner[path.front().vertex] = out_.corner[path.back().vertex] = 1;
      cut(path, chain);
      return;
    }
    mark_sharpest(path);
    int first = 0;
    while (!out_.corner[path[first].vertex]) ++first;
    for (int k = 0; k <= count; ++k) chain.push_back((first + k) % count);
    cut(path, chain);
  }

  // At the corners marked so far.
  void cut(const std::vector<Joint>& path, const std::vector<int>& chain) {
    std::vector<int> part{chain.front()};
    for (std::size_t k = 1; k < chain.size(); ++k) {
      part.push_back(chain[k]);
      if (!out_.corner[path[chain[k]].vertex]) continue;
      straighten_chain(path, part);
      part = {chain[k]};
    }
  }

  void straighten_chain(const std::vector<Joint>& path, const std::vector<int>& chain) {
    if (chain.size() < 3) return;
    std::vector<Point> before;
    for (int k : chain) before.push_back(at(path[k].vertex));
    const std::vector<Point> after = on_the_line(path, chain);
    for (std::size_t i = 0; i < chain.size(); ++i)
      out_.domain.row(path[chain[i]].vertex) = after[i].transpose();
    if (valid_around(path, chain)) {
      for (std::size_t i = 0; i < chain.size(); ++i)
        out_.largest_move = std::max(out_.largest_move, (after[i] - before[i]).norm());
      return;
    }
    for (std::size_t i = 0; i < chain.size(); ++i)
      out_.domain.row(path[chain[i]].vertex) = before[i].transpose();
    ++out_.restored;
    std::size_t sharpest = 1;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
      if (std::abs(turn(path[chain[i]])) > std::abs(turn(path[chain[sharpest]]))) sharpest = i;
    out_.corner[path[chain[sharpest]].vertex] = 1;
    const auto middle = chain.begin() + static_cast<std::ptrdiff_t>(sharpest);
    straighten_chain(path, {chain.begin(), middle + 1});
    straighten_chain(path, {middle, chain.end()});
  }

  std::vector<Point> on_the_line(const std::vector<Joint>& path,
                                 const std::vector<int>& chain) const {
    const Point start = at(path[chain.front()].vertex), end = at(path[chain.back()].vertex);
    const Point line = end - start;
    std::vector<double> where(chain.size(), 0);
    if (options_.how == Straightening::orthogonal) {
      for (std::size_t i = 0; i < chain.size(); ++i)
        where[i] = (at(path[chain[i]].vertex) - start).dot(line) / line.squaredNorm();
    } else {
      // Each edge is as long as the one before times the ratio of the boundary's derivatives.
      double length = 1, sum = 0;
      for (std::size_t i = 1; i < chain.size(); ++i) {
        sum += length;
        where[i] = sum;
        length *= path[chain[i]].ratio;
      }
      for (double& w : where) w /= sum;
    }
    std::vector<Point> points;
    for (double w : where) points.push_back(start + w * line);
    points.back() = end;
    return points;
  }

  bool valid_around(const std::vector<Joint>& path, const std::vector<int>& chain) const {
    Net net(tables_.net_size);
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
      for (int t : around_[path[chain[i]].vertex]) {
        const auto& corner = initial_.triangles[t];
        for (int k = 0; k < tables_.net_size; ++k)
          net[k] = state_.control[initial_.nets[t * tables_.net_size + k]];
        const double g = distortion_bound(tables_, net, at(corner[1]) - at(corner[0]),
                                          at(corner[2]) - at(corner[0]));
        if (!(g < options_.bound)) return false;
      }
    return !(options_.no_overlap && boundary_meets_itself(initial_, out_.domain));
  }

  const CurvedMesh& initial_;
  const Joints& joints_;
  const Pair& state_;
  const StraightenOptions& options_;
  const JacobianTables& tables_;
  std::vector<std::vector<int>> around_;
  Straightened out_;
};

}  // namespace

bool is_shape_corner(const Joint& joint) {
  return joint.branch || joint.kind == JointKind::end || joint.kind == JointKind::corner ||
         (joint.kind == JointKind::mild && std::abs(joint.turn) > kNegligibleTurn);
}

Straightened straighten(const CurvedMesh& initial, const Joints& joints, const Pair& state,
                        const StraightenOptions& options) {
  return Straightener(initial, joints, state, options).run();
}

std::vector<char> exceptional_corners(const CurvedMesh& initial, const Joints& joints,
                                      const Straightened& straightened) {
  std::vector<char> out(initial.vertex_count(), 0);
  for (const auto& path : joints)
    for (const Joint& j : path) {
      if (j.branch) out[j.vertex] = 1;
      if (!straightened.corner[j.vertex] || j.previous < 0 || j.next < 0) continue;
      if (!is_shape_corner(j)) {
        out[j.vertex] = 1;
        continue;
      }
      const auto& domain = straightened.domain;
      const Point before = (domain.row(j.vertex) - domain.row(j.previous)).transpose();
      const Point after = (domain.row(j.next) - domain.row(j.vertex)).transpose();
      if (!(cross(before, after) * j.turn > 0)) out[j.vertex] = 1;
    }
  return out;
}

}  // namespace c1mesh
