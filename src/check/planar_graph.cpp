// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/planar_graph.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "check/winding.h"

namespace c1mesh::detail {
namespace {

// Tarjan's biconnected components, without recursion: drawings may have a million curves.
class Blocks {
 public:
  Blocks(const Arrangement& arrangement, const Nodes& nodes, const std::vector<char>& use)
      : nodes_(nodes),
        use_(use),
        seen_(arrangement.curves.size(), 0),
        order_(nodes.ends.size(), 0),
        low_(nodes.ends.size(), 0) {}

  std::vector<std::vector<int>> run() {
    for (std::size_t node = 0; node < nodes_.ends.size(); ++node)
      if (order_[node] == 0) search(static_cast<int>(node));
    return std::move(blocks_);
  }

 private:
  struct Visit {
    int node, curve;       // the curve by which the node was reached, or -1
    std::size_t next = 0;  // of its ends
  };

  void search(int root) {
    std::vector<Visit> path{{root, -1}};
    order_[root] = low_[root] = ++count_;
    while (!path.empty()) {
      Visit& here = path.back();
      if (here.next < nodes_.ends[here.node].size()) {
        step(nodes_.ends[here.node][here.next++], path);
        continue;
      }
      const Visit done = here;
      path.pop_back();
      if (path.empty()) continue;
      const int parent = path.back().node;
      low_[parent] = std::min(low_[parent], low_[done.node]);
      if (low_[done.node] >= order_[parent]) close_block(done.curve);
    }
  }

  void step(const CurveEnd& end, std::vector<Visit>& path) {
    if (!use_[end.curve] || seen_[end.curve]) return;
    seen_[end.curve] = 1;
    const int from = nodes_.of_curve[end.curve][end.at_end];
    const int to = nodes_.of_curve[end.curve][!end.at_end];
    if (to == from) {
      blocks_.push_back({end.curve});
      return;
    }
    stack_.push_back(end.curve);
    if (order_[to] > 0) {
      low_[from] = std::min(low_[from], order_[to]);
      return;
    }
    order_[to] = low_[to] = ++count_;
    path.push_back({to, end.curve});
  }

  void close_block(int curve) {
    auto& block = blocks_.emplace_back();
    while (true) {
      block.push_back(stack_.back());
      stack_.pop_back();
      if (block.back() == curve) break;
    }
    std::sort(block.begin(), block.end());
  }

  const Nodes& nodes_;
  const std::vector<char>& use_;
  std::vector<char> seen_;
  std::vector<int> order_, low_, stack_;
  std::vector<std::vector<int>> blocks_;
  int count_ = 0;
};

// The direction in which a curve leaves one of its ends.
Point leaving(const Arrangement& arrangement, const CurveEnd& end) {
  const auto& poles = arrangement.curves[end.curve].poles;
  const std::size_t n = poles.size() - 1;
  for (std::size_t i = 1; i <= n; ++i) {
    const Point d = end.at_end ? arrangement.difference(poles[n - i], poles[n])
                               : arrangement.difference(poles[i], poles[0]);
    if (!d.isZero(0)) return d;
  }
  return Point::Zero();
}

}  // namespace

std::vector<std::vector<int>> blocks_of(const Arrangement& arrangement, const Nodes& nodes,
                                        const std::vector<char>& use) {
  return Blocks(arrangement, nodes, use).run();
}

std::vector<int> rim_of(const Arrangement& arrangement, const Nodes& nodes,
                        const std::vector<int>& block) {
  std::map<int, std::vector<CurveEnd>> around;  // per node: ends of the block, counter-clockwise
  for (const int curve : block)
    for (const bool at_end : {false, true})
      around[nodes.of_curve[curve][at_end]].push_back({curve, at_end});
  // A simple loop, which may be too thin or too entangled to have an area.
  if (around.size() == block.size()) return block;
  for (auto& [node, ends] : around) {
    const auto angle = [&](const CurveEnd& end) {
      const Point d = leaving(arrangement, end);
      return std::atan2(d.y(), d.x());
    };
    std::stable_sort(ends.begin(), ends.end(),
                     [&](const CurveEnd& a, const CurveEnd& b) { return angle(a) < angle(b); });
  }
  // A face lies to the left: on arriving at a node its boundary goes on with the end that is next
  // clockwise. The unbounded face is the one to whose left the enclosed area is negative.
  std::map<std::pair<int, bool>, bool> walked;
  std::vector<int> rim;
  double least = 0;
  for (const int curve : block)
    for (const bool reversed : {false, true}) {
      Loop face;
      for (CurveUse use{curve, reversed}; !walked[{use.curve, use.reversed}];) {
        walked[{use.curve, use.reversed}] = true;
        face.push_back(use);
        const auto& ends = around[nodes.of_curve[use.curve][!use.reversed]];
        std::size_t k = 0;
        while (ends[k].curve != use.curve || ends[k].at_end != !use.reversed) ++k;
        const CurveEnd& next = ends[(k + ends.size() - 1) % ends.size()];
        use = {next.curve, next.at_end};
      }
      if (face.empty()) continue;
      const double area = signed_area(face, arrangement);
      if (area >= least) continue;
      least = area;
      rim.clear();
      for (const CurveUse& use : face) rim.push_back(use.curve);
    }
  return rim;
}

}  // namespace c1mesh::detail
