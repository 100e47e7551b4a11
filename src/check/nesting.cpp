// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops bound the shape, which is inside which.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "bernstein/curve.h"
#include "check/box_pairs.h"
#include "check/stages.h"
#include "check/winding.h"

namespace c1mesh::detail {
namespace {

constexpr std::size_t kMostPairs = 50'000'000;

Loop turned(const Loop& loop) {
  Loop out = {loop.front()};
  out.insert(out.end(), loop.rbegin(), loop.rend() - 1);
  for (CurveUse& use : out) use.reversed = !use.reversed;
  return out;
}

class Nesting {
 public:
  Nesting(Arrangement& arrangement, const std::vector<Loop>& loops,
          const std::vector<FeaturePath>& features, const Nodes& nodes, const Pieces& pieces)
      : arrangement_(arrangement),
        loops_(loops),
        features_(features),
        nodes_(nodes),
        pieces_(pieces),
        count_(static_cast<int>(loops.size())) {}

  std::vector<Region> run() {
    if (!measure() || !find_parents()) return {};
    return regions();
  }

 private:
  bool measure() {
    for (const Loop& loop : loops_) {
      areas_.push_back(signed_area(loop, arrangement_));
      // Twice the rounding error of the sum: less says nothing about the direction.
      if (std::abs(areas_.back()) > 1e-14 * box_area(loop) && areas_.back() != 0) continue;
      std::vector<int> about;
      for (const CurveUse& use : loop) about.push_back(use.curve);
      arrangement_.report(DefectKind::empty, about,
                          {arrangement_.curves[loop.front().curve].start()},
                          "a loop encloses no measurable area", "remove it");
      return false;
    }
    return true;
  }

  Box loop_box(const Loop& loop) const {
    std::vector<Point> points;
    for (const CurveUse& use : loop)
      for (int i = pieces_.first[use.curve]; i < pieces_.first[use.curve + 1]; ++i)
        points.insert(points.end(), pieces_.all[i].poles.begin(), pieces_.all[i].poles.end());
    return box_of(points, 0);
  }

  double box_area(const Loop& loop) const {
    const Box box = loop_box(loop);
    const Point side = box.high - box.low;
    return side.x() * side.y();
  }

  // Loops do not meet, so one point of a loop tells whether all of it is inside another.
  bool inside(int inner, int outer, const std::vector<Box>& boxes) const {
    const Point& p = pieces_.all[pieces_.first[loops_[inner].front().curve]].start();
    const Box& box = boxes[outer];
    if ((p.array() < box.low.array()).any() || (p.array() > box.high.array()).any()) return false;
    return winding_number(loops_[outer], pieces_, p) != 0;
  }

  bool find_parents() {
    std::vector<Box> boxes;
    for (const Loop& loop : loops_) boxes.push_back(loop_box(loop));
    std::vector<std::pair<int, int>> pairs;
    if (!overlapping_pairs(boxes, kMostPairs, pairs)) {
      arrangement_.report(DefectKind::limit, {}, {}, "too many loops overlap each other",
                          "give the boundary of one shape at a time");
      return false;
    }
    std::vector<std::vector<int>> around(count_);
    for (const auto& [a, b] : pairs) {
      if (inside(a, b, boxes)) around[a].push_back(b);
      if (inside(b, a, boxes)) around[b].push_back(a);
    }
    parent_.assign(count_, -1);
    depth_.assign(count_, 0);
    for (int i = 0; i < count_; ++i) depth_[i] = static_cast<int>(around[i].size());
    for (int i = 0; i < count_; ++i)
      for (const int j : around[i])
        if (parent_[i] < 0 || depth_[j] > depth_[parent_[i]]) parent_[i] = j;
    return true;
  }

  // Fills the winding number just inside every loop, from the outermost inward, and tells which
  // loops separate inside from outside.
  void apply_fill_rule() {
    order_.resize(count_);
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int a, int b) { return depth_[a] < depth_[b]; });
    winding_.assign(count_, 0);
    bounds_.assign(count_, 1);
    for (const int i : order_) {
      const int outside = parent_[i] < 0 ? 0 : winding_[parent_[i]];
      winding_[i] = outside + (areas_[i] > 0 ? 1 : -1);
      bounds_[i] = filled(outside) != filled(winding_[i]);
    }
  }

  // Every loop crossed on the way in changes the winding number by one, so its parity is the
  // depth's.
  bool filled(int winding) const {
    return arrangement_.fill_rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
  }

  std::vector<Region> regions() {
    apply_fill_rule();
    std::vector<int> region_of(count_, -1);
    std::vector<Region> out;
    for (int i = 0; i < count_; ++i) {
      if (!bounds_[i]) take_idle(i);
      if (!bounds_[i] || !filled(winding_[i])) continue;
      region_of[i] = static_cast<int>(out.size());
      out.push_back({areas_[i] > 0 ? loops_[i] : turned(loops_[i]), {}, {}});
    }
    for (int i = 0; i < count_; ++i) {
      if (!bounds_[i] || filled(winding_[i])) continue;
      int outer = parent_[i];
      while (!bounds_[outer]) outer = parent_[outer];
      out[region_of[outer]].holes.push_back(areas_[i] < 0 ? loops_[i] : turned(loops_[i]));
    }
    for (const FeaturePath& path : features_) assign(path, out);
    return out;
  }

  void take_idle(int i) {
    std::vector<int> about;
    for (const CurveUse& use : loops_[i]) about.push_back(use.curve);
    arrangement_.mend(
        DefectKind::note, about, {arrangement_.curves[about.front()].start()},
        "a loop lies within filled area and bounds nothing by the nonzero rule; it is a feature");
    for (FeaturePath& path : paths_of(loops_[i], nodes_)) features_.push_back(std::move(path));
  }

  // To the region that has a point of the path inside; features meet loops in end points only.
  void assign(const FeaturePath& path, std::vector<Region>& regions) const {
    const Point p =
        evaluate(arrangement_.normalised(path.curves[path.curves.size() / 2].curve), 0.5);
    for (Region& region : regions) {
      bool inside = winding_number(region.outer, pieces_, p) != 0;
      for (const Loop& hole : region.holes) inside &= winding_number(hole, pieces_, p) == 0;
      if (!inside) continue;
      region.features.push_back(path);
      return;
    }
  }

  Arrangement& arrangement_;
  const std::vector<Loop>& loops_;
  std::vector<FeaturePath> features_;
  const Nodes& nodes_;
  const Pieces& pieces_;
  int count_;
  std::vector<double> areas_;
  std::vector<int> parent_, depth_, order_, winding_;
  std::vector<char> bounds_;
};

}  // namespace

std::vector<Region> nest(Arrangement& arrangement, const std::vector<Loop>& loops,
                         const std::vector<FeaturePath>& features, const Nodes& nodes,
                         const Pieces& pieces) {
  return Nesting(arrangement, loops, features, nodes, pieces).run();
}

}  // namespace c1mesh::detail
