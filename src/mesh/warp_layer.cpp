// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/warp_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "bernstein/curve.h"
#include "c1mesh/cost.h"
#include "mesh/box_pairs.h"
#include "mesh/no_mesh.h"

namespace c1mesh::meshing {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kShareBesideWarp = 0.4;  // of a joint's angle, where both sides are warped
constexpr double kShareBesideLine = 0.5;  // where the other side has no warp triangle
constexpr double kShrinkStep = 0.75;
constexpr double kMargin = 0.6;  // least gap, in heights of the lower warp triangle
constexpr double kFlattestBaseAngle = 0.35 * kDegree;
constexpr int kBoundDepth = 24;  // beyond, a bound above mu is accepted and noted
constexpr int kMaxDepth = 44;    // s stays exact in a double with room for later splits

// A segment's place in the ring of its loop and what the current round wants of it.
struct Node {
  WarpSegment segment;
  int next = -1, previous = -1;
  int twin = -1;  // the same piece of a feature from its other side
  double wished_shrink = 1;
  bool wished_split = false;
  bool changed = true;
};

class Layer {
 public:
  Layer(const Walks& walks, int degree, double mips_bound, const Thrift& thrift, MeshReport& report,
        const Stop& stop)
      : walks_(walks),
        degree_(degree),
        bound_(mips_bound),
        thrift_(thrift),
        report_(report),
        stop_(stop) {
    for (const auto& walk : walks_)
      for (const WalkStep& step : walk) {
        points_ = std::max({points_, step.start + 1, step.end + 1});
        features_ |= step.feature;
      }
  }

  /// False if more than `limit` segments would be needed.
  bool build(std::size_t limit) {
    for (std::size_t k = 0; k < walks_.size(); ++k) add_loop(static_cast<int>(k));
    if (features_) start_with_features();
    while (nodes_.size() <= limit) {
      if (stop_) stop_();
      if (!resolve_conflicts()) return true;
    }
    return false;
  }

  std::vector<std::vector<WarpSegment>> collect() {
    std::vector<std::vector<WarpSegment>> loops;
    for (int first : first_) {
      std::vector<WarpSegment> loop;
      int i = first;
      do {
        loop.push_back(nodes_[i].segment);
        note(loop.back());
        i = nodes_[i].next;
      } while (i != first);
      loops.push_back(std::move(loop));
    }
    number(loops);
    return loops;
  }

 private:
  // Twins by flat number, points by first appearance.
  void number(std::vector<std::vector<WarpSegment>>& loops) const {
    std::vector<int> flat(nodes_.size(), -1), point(points_, -1);
    int count = 0, points = 0;
    for (int first : first_) {
      int i = first;
      do flat[i] = count++;
      while ((i = nodes_[i].next) != first);
    }
    for (std::size_t l = 0; l < loops.size(); ++l) {
      int i = first_[l];
      for (WarpSegment& s : loops[l]) {
        if (nodes_[i].twin >= 0) s.twin = flat[nodes_[i].twin];
        if (point[s.start] < 0) point[s.start] = points++;
        i = nodes_[i].next;
      }
    }
    for (auto& loop : loops)
      for (WarpSegment& s : loop) s.start = point[s.start], s.end = point[s.end];
  }

  double impatience(int depth) const {
    return std::pow(thrift_.impatience, std::max(0, depth - thrift_.patient_depth));
  }

  double least_base_angle(int depth) const {
    return std::max(kFlattestBaseAngle, thrift_.base_angle * impatience(depth));
  }

  BezierCurve piece(const WarpSegment& s) const {
    const BezierCurve& whole = walks_[s.loop][s.source].curve.bezier;
    if (s.s0 == 0 && s.s1 == 1) return whole;
    return restrict_exactly(whole, s.s0, s.s1, degree_);
  }

  void add_loop(int loop) {
    const auto& steps = walks_[loop];
    const int first = static_cast<int>(nodes_.size()), count = static_cast<int>(steps.size());
    for (int i = 0; i < count; ++i) {
      Node node;
      WarpSegment& s = node.segment;
      s.loop = loop;
      s.source = i;
      s.curve = steps[i].curve.bezier;
      s.start = steps[i].start;
      s.end = steps[i].end;
      s.straight = is_straight(s.curve);
      node.next = first + (i + 1) % count;
      node.previous = first + (i + count - 1) % count;
      nodes_.push_back(std::move(node));
    }
    first_.push_back(first);
    for (int i = first; i < first + count; ++i) set_joints(i);
    if (features_) return;
    make_three(first);
    pending_.clear();
    for (int i = first; i < static_cast<int>(nodes_.size()); ++i) pending_.push_back(i);
    settle();
  }

  // The sides of a feature may belong to two walks: all must be there before anything is halved.
  void start_with_features() {
    for (std::size_t k = 0; k < walks_.size(); ++k)
      for (const WalkStep& step : walks_[k])
        if (step.twin_walk >= 0)
          nodes_[first_[k] + step.index].twin = first_[step.twin_walk] + step.twin_index;
    for (std::size_t i = 0; i < nodes_.size(); ++i) set_joints(static_cast<int>(i));
    make_simple();
    pending_.clear();
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) pending_.push_back(i);
    settle();
  }

  // No two pieces may have the same two ends: their chords would be one.
  void make_simple() {
    // By ends: the pieces between them, increasing. Only those that break the rule are visited, in
    // the order of the ends' numbers.
    using Ends = std::pair<int, int>;
    std::map<Ends, std::vector<int>> between;
    std::set<Ends> wrong;
    const auto counts = [&](int i) { return nodes_[i].twin < 0 || i < nodes_[i].twin; };
    const auto ends_of = [&](int i) -> Ends {
      return std::minmax(nodes_[i].segment.start, nodes_[i].segment.end);
    };
    const auto judge = [&](const Ends& ends) {
      const std::size_t pieces = between[ends].size();
      if (pieces > 1 || (pieces == 1 && ends.first == ends.second))
        wrong.insert(ends);
      else
        wrong.erase(ends);
    };
    const auto enter = [&](int i) {
      if (!counts(i)) return;
      std::vector<int>& pieces = between[ends_of(i)];
      pieces.insert(std::upper_bound(pieces.begin(), pieces.end(), i), i);
      judge(ends_of(i));
    };
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) enter(i);
    while (!wrong.empty()) {
      const Ends ends = *wrong.begin();
      int longest = -1;
      for (const int i : between[ends])
        if (!nodes_[i].segment.straight &&
            (longest < 0 || polygon_length(i) > polygon_length(longest)))
          longest = i;
      if (longest < 0) throw NoMesh("two straight curves have the same ends");
      const int twin = nodes_[longest].twin, count = static_cast<int>(nodes_.size());
      std::erase(between[ends], longest);
      split(longest);
      judge(ends);
      enter(longest);
      if (twin >= 0) enter(twin);
      for (int i = count; i < static_cast<int>(nodes_.size()); ++i) enter(i);
    }
  }

  void set_joints(int i) {
    Node& node = nodes_[i];
    const Node &before = nodes_[node.previous], &after = nodes_[node.next];
    WarpSegment& s = node.segment;
    // Around a dangling end the interior is all there is.
    const auto angle = [&](const Node& in, const Node& out) {
      if (in.twin >= 0 && &nodes_[in.twin] == &out) return 2 * std::numbers::pi;
      return interior_angle(end_direction(in.segment.curve), start_direction(out.segment.curve));
    };
    s.joint[0] = angle(before, node);
    s.joint[1] = angle(node, after);
    s.share[0] = before.segment.straight ? kShareBesideLine : kShareBesideWarp;
    s.share[1] = after.segment.straight ? kShareBesideLine : kShareBesideWarp;
  }

  // Two segments of one loop must share at most one joint.
  void make_three(int first) {
    for (int count = loop_size(first); count < 3; ++count) {
      int longest = -1;
      for (int i = first, k = 0; k < count; ++k, i = nodes_[i].next)
        if (!nodes_[i].segment.straight &&
            (longest < 0 || polygon_length(i) > polygon_length(longest)))
          longest = i;
      if (longest < 0) throw NoMesh("a loop of fewer than three straight curves");
      split(longest);
    }
  }

  int loop_size(int first) const {
    int count = 1;
    for (int i = nodes_[first].next; i != first; i = nodes_[i].next) ++count;
    return count;
  }

  double polygon_length(int i) const {
    double sum = 0;
    const auto& p = nodes_[i].segment.curve.poles;
    for (std::size_t k = 1; k < p.size(); ++k) sum += (p[k] - p[k - 1]).norm();
    return sum;
  }

  // Halves segment i: i keeps the first half, the new node takes the second. The other side of a
  // feature is halved with it. All halves become pending.
  void split(int i) {
    const int twin = nodes_[i].twin, middle = points_++;
    const int j = split_side(i, middle);
    if (twin < 0) return;
    const int k = split_side(twin, middle);
    nodes_[i].twin = k;
    nodes_[k].twin = i;
    nodes_[j].twin = twin;
    nodes_[twin].twin = j;
    pending_.push_back(twin);
    pending_.push_back(k);
  }

  int split_side(int i, int middle_point) {
    const int j = static_cast<int>(nodes_.size());
    Node second = nodes_[i];
    Node& left = nodes_[i];
    if (left.segment.depth >= kMaxDepth)
      throw NoMesh("the boundary comes too close to itself",
                   walks_[left.segment.loop][left.segment.source].curve.curve,
                   left.segment.curve.start());
    const double middle = 0.5 * (left.segment.s0 + left.segment.s1);
    left.segment.s1 = second.segment.s0 = middle;
    left.segment.end = second.segment.start = middle_point;
    for (WarpSegment* s : {&left.segment, &second.segment}) {
      ++s->depth;
      s->shrink = 1;
      s->curve = piece(*s);
      s->straight = is_straight(s->curve);
    }
    left.segment.joint[1] = second.segment.joint[0] = std::numbers::pi;
    left.segment.share[1] = second.segment.share[0] = kShareBesideWarp;
    second.previous = i;
    nodes_[left.next].previous = j;
    left.next = j;
    for (Node* node : {&left, &second})
      node->wished_split = false, node->wished_shrink = 1, node->changed = true;
    nodes_.push_back(std::move(second));
    ++report_.splits;
    pending_.push_back(i);
    pending_.push_back(j);
    return j;
  }

  // Gives every pending segment its highest apex, halving where the bound fails.
  void settle() {
    while (!pending_.empty()) {
      const int i = pending_.back();
      pending_.pop_back();
      WarpSegment& s = nodes_[i].segment;
      if (s.straight) continue;
      const bool valid = place_apex(s);
      if (valid && (s.bound <= bound_ || s.depth >= kBoundDepth)) continue;
      split(i);
    }
  }

  // Lowers the apex by one step, unless it becomes too flat or the bound fails.
  bool lower(WarpSegment& s) const {
    if (s.straight) return false;
    if (std::tan(s.base_angle) * kShrinkStep < std::tan(least_base_angle(s.depth))) return false;
    WarpSegment lower = s;
    lower.shrink *= kShrinkStep;
    if (!place_apex(lower) || lower.bound > std::max(bound_, s.bound)) return false;
    s = std::move(lower);
    return true;
  }

  bool share_point(int i, int j) const {
    const WarpSegment &a = nodes_[i].segment, &b = nodes_[j].segment;
    return a.start == b.start || a.start == b.end || a.end == b.start || a.end == b.end;
  }

  // Hulls that share a joint meet there only if their cones at the joint do; inside the shape the
  // shares see to that, outside the hulls' reach beyond the tangents must leave room.
  // A feature's hull reaches no further than the inner edges on its other side.
  void test_joint(int i, int j) {
    if (nodes_[i].twin >= 0 || nodes_[j].twin >= 0) return;
    if (nodes_[i].segment.end != nodes_[j].segment.start) std::swap(i, j);
    const WarpSegment &in = nodes_[i].segment, &out = nodes_[j].segment;
    // Where features end at the joint it has several sectors.
    const double inside = nodes_[i].next == j
                              ? in.joint[1]
                              : interior_angle(end_direction(in.curve), start_direction(out.curve));
    const double room = 2 * std::numbers::pi - inside;
    const double reach_in = outward_reach(in, 1), reach_out = outward_reach(out, 0);
    if (reach_in + reach_out < 0.9 * room) return;
    nodes_[reach_in > reach_out ? i : j].wished_split = true;
  }

  bool are_apart(const WarpSegment& a, const std::vector<Point>& hull_a, const WarpSegment& b,
                 const std::vector<Point>& hull_b) const {
    const double low = a.straight ? b.height : b.straight ? a.height : std::min(a.height, b.height);
    return separated(hull_a, hull_b, kMargin * impatience(std::max(a.depth, b.depth)) * low);
  }

  // Lowers copies of the two in turn, always the higher one, until they are apart or one must be
  // halved. By height, not length: a long flat neighbour is not in the way of a short one, a high
  // one is.
  void test_apart(int i, int j) {
    if (are_apart(nodes_[i].segment, hulls_[i], nodes_[j].segment, hulls_[j])) return;
    WarpSegment a = nodes_[i].segment, b = nodes_[j].segment;
    do {
      const bool first = b.straight || (!a.straight && a.height >= b.height);
      if (!lower(first ? a : b)) {
        nodes_[first ? i : j].wished_split = true;
        return;
      }
    } while (!are_apart(a, hull_of(a), b, hull_of(b)));
    nodes_[i].wished_shrink = std::min(nodes_[i].wished_shrink, a.shrink);
    nodes_[j].wished_shrink = std::min(nodes_[j].wished_shrink, b.shrink);
  }

  // One round: tests all pairs with a changed member, then shrinks and splits. False when at rest.
  bool resolve_conflicts() {
    std::vector<int> active;
    hulls_.resize(nodes_.size());
    boxes_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!nodes_[i].changed) continue;
      const WarpSegment& s = nodes_[i].segment;
      hulls_[i] = hull_of(s);
      boxes_[i].setEmpty();
      for (const Point& p : hulls_[i]) boxes_[i].extend(p);
      const double margin = kMargin * impatience(s.depth) * s.height;
      if (!s.straight) boxes_[i].min().array() -= margin, boxes_[i].max().array() += margin;
      active.push_back(static_cast<int>(i));
    }
    // The pairs' order does not matter: nothing a test reads is changed before all are done.
    for (const auto& [i, j] : meeting_pairs(boxes_, active)) {
      if (nodes_[i].segment.straight && nodes_[j].segment.straight) continue;
      if (nodes_[i].twin == j) continue;
      if (share_point(i, j))
        test_joint(i, j);
      else
        test_apart(i, j);
    }
    for (int i : active) nodes_[i].changed = false;
    return grant_wishes();
  }

  bool grant_wishes() {
    bool any = false;
    const int count = static_cast<int>(nodes_.size());
    for (int i = 0; i < count; ++i) {
      Node& node = nodes_[i];
      const double shrink = std::exchange(node.wished_shrink, 1);
      if (node.wished_split) {
        any = true;
        split(i);  // invalidates `node`
        settle();
      } else if (shrink < node.segment.shrink) {
        any = true;
        node.segment.shrink = shrink;
        node.changed = true;
        place_apex(node.segment);
      }
    }
    return any;
  }

  void note(const WarpSegment& s) {
    if (s.straight) return;
    ++report_.warp_triangles;
    if (s.bound > bound_)
      report_.notes.push_back(
          fmt::format("curve {}: bound {:.3g} instead of {:.3g} beside a joint of {:.3g} degrees",
                      walks_[s.loop][s.source].curve.curve, s.bound, bound_,
                      std::min(s.joint[0], s.joint[1]) / kDegree));
  }

  const Walks& walks_;
  int degree_;
  double bound_;
  const Thrift& thrift_;
  MeshReport& report_;
  const Stop& stop_;
  std::vector<Node> nodes_;
  std::vector<int> first_;  // per walk: the node that starts its first curve
  int points_ = 0;          // how many there are
  bool features_ = false;
  std::vector<int> pending_;  // segments whose apex is not placed yet
  std::vector<std::vector<Point>> hulls_;
  std::vector<Box> boxes_;
};

}  // namespace

Thrift usual_thrift() {
  return {17 * kDegree, 3, 0.4, 15 * kDegree, 12 * kDegree};
}

Thrift strict_thrift() {
  return {kDegree, 0, 0.3, 0, 0};
}

std::optional<std::vector<std::vector<WarpSegment>>> build_warp_layer(
    const Walks& walks, int degree, double mips_bound, const Thrift& thrift, std::size_t limit,
    MeshReport& report, const Stop& stop) {
  const StageTimer timer("mesh: warp triangles");
  Layer layer(walks, degree, mips_bound, thrift, report, stop);
  if (!layer.build(limit)) return std::nullopt;
  return layer.collect();
}

}  // namespace c1mesh::meshing
