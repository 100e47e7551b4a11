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
        index_(loops, pieces),
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

  bool find_parents() {
    // Loops do not meet, so one point of a loop tells whether all of it is inside another.
    std::vector<std::vector<int>> around(count_);
    std::size_t total = 0;
    for (int i = 0; i < count_; ++i) {
      const Point& p = pieces_.all[pieces_.first[loops_[i].front().curve]].start();
      for (const auto& [loop, number] : index_.around(p, [i](int other) { return other != i; }))
        around[i].push_back(loop);
      total += around[i].size();
      if (total <= kMostPairs) continue;
      arrangement_.report(DefectKind::limit, {}, {}, "too many loops lie within each other",
                          "give the boundary of one shape at a time");
      return false;
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
    region_of_ = std::move(region_of);
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

  // To the region that has a point of the path inside; features meet loops in end points only. The
  // innermost loop that bounds and has the point inside is the region's outer one.
  void assign(const FeaturePath& path, std::vector<Region>& regions) const {
    const Point p =
        evaluate(arrangement_.normalised(path.curves[path.curves.size() / 2].curve), 0.5);
    int innermost = -1;
    for (const auto& [loop, number] : index_.around(p, [&](int l) { return bounds_[l] != 0; }))
      if (innermost < 0 || depth_[loop] > depth_[innermost]) innermost = loop;
    if (innermost >= 0 && region_of_[innermost] >= 0)
      regions[region_of_[innermost]].features.push_back(path);
  }

  Arrangement& arrangement_;
  const std::vector<Loop>& loops_;
  std::vector<FeaturePath> features_;
  const Nodes& nodes_;
  const Pieces& pieces_;
  const WindingIndex index_;
  int count_;
  std::vector<double> areas_;
  std::vector<int> parent_, depth_, order_, winding_;
  std::vector<char> bounds_;
  std::vector<int> region_of_;  // per loop; -1: no outer loop
};

}  // namespace

std::vector<Region> nest(Arrangement& arrangement, const std::vector<Loop>& loops,
                         const std::vector<FeaturePath>& features, const Nodes& nodes,
                         const Pieces& pieces) {
  return Nesting(arrangement, loops, features, nodes, pieces).run();
}

}  // namespace c1mesh::detail
