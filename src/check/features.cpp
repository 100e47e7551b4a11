// SPDX-License-Identifier: GPL-3.0-or-later
// Which curves bound nothing, how they follow one another, and whether they lie inside.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bernstein/curve.h"
#include "check/box_pairs.h"
#include "check/planar_graph.h"
#include "check/stages.h"
#include "check/winding.h"

namespace c1mesh::detail {
namespace {

// An open chain whose ends are nearer than this part of its size was meant to close.
constexpr double kNearlyClosed = 0.1;

int node_of(const Nodes& nodes, const CurveUse& use, bool after) {
  return nodes.of_curve[use.curve][after != use.reversed];
}

const Point& end_of(const Arrangement& arrangement, const CurveUse& use, bool after) {
  const BezierCurve& curve = arrangement.curves[use.curve];
  return after != use.reversed ? curve.end() : curve.start();
}

std::vector<int> curves_of(const FeaturePath& path) {
  std::vector<int> out;
  for (const CurveUse& use : path.curves) out.push_back(use.curve);
  return out;
}

class FeatureCheck {
 public:
  FeatureCheck(Arrangement& arrangement, const Nodes& nodes, const std::vector<Loop>& loops,
               const Pieces& pieces)
      : arrangement_(arrangement), nodes_(nodes), loops_(loops), winding_(loops, pieces) {}

  void check(const FeaturePath& path) {
    if (was_meant_to_close(path) || (!path.closed && loops_.empty()))
      report_open(path);
    else if (!inside(path))
      report_outside(path);
  }

 private:
  bool dangles(const FeaturePath& path, bool after) const {
    return nodes_.ends[node_of(nodes_, after ? path.curves.back() : path.curves.front(), after)]
               .size() == 1;
  }

  double gap_of(const FeaturePath& path) const {
    return (end_of(arrangement_, path.curves.back(), true) -
            end_of(arrangement_, path.curves.front(), false))
        .norm();
  }

  bool was_meant_to_close(const FeaturePath& path) const {
    if (path.closed || path.curves.size() < 2 || !dangles(path, false) || !dangles(path, true))
      return false;
    std::vector<Point> points;
    for (const CurveUse& use : path.curves) {
      if (marked(use.curve)) return false;
      const auto& poles = arrangement_.curves[use.curve].poles;
      points.insert(points.end(), poles.begin(), poles.end());
    }
    const Box box = box_of(points, 0);
    return gap_of(path) < kNearlyClosed * (box.high - box.low).maxCoeff();
  }

  bool marked(int curve) const { return arrangement_.feature[curve] == kMarked; }

  // Curves do not cross loops (else that is reported), so one inner point tells.
  bool inside(const FeaturePath& path) const {
    const Point p =
        evaluate(arrangement_.normalised(path.curves[path.curves.size() / 2].curve), 0.5);
    int sum = 0;
    for (const auto& [loop, number] : winding_.around(p, [](int) { return true; })) sum += number;
    return arrangement_.fill_rule == FillRule::nonzero ? sum != 0 : sum % 2 != 0;
  }

  void report_open(const FeaturePath& path) {
    arrangement_.report(
        DefectKind::open_loop, curves_of(path),
        {end_of(arrangement_, path.curves.front(), false),
         end_of(arrangement_, path.curves.back(), true)},
        fmt::format("a chain of {} curve{} does not close; its ends are {:.3g} apart",
                    path.curves.size(), path.curves.size() == 1 ? "" : "s", gap_of(path)),
        "close it, or remove it; a curve that bounds nothing must lie inside the shape");
  }

  void report_outside(const FeaturePath& path) {
    if (!path.closed && !marked(path.curves[0].curve) &&
        (dangles(path, false) || dangles(path, true)))
      report_open(path);
    else
      arrangement_.report(DefectKind::open_loop, curves_of(path),
                          {end_of(arrangement_, path.curves.front(), false)},
                          "curves that bound nothing lie outside the shape", "remove them");
    for (const bool after : {false, true}) {
      const int node = node_of(nodes_, after ? path.curves.back() : path.curves.front(), after);
      if (nodes_.ends[node].size() < 3 || !told_.insert(node).second) continue;
      std::vector<int> about;
      for (const CurveEnd& end : nodes_.ends[node])
        if (about.empty() || about.back() != end.curve) about.push_back(end.curve);
      arrangement_.report(
          DefectKind::branching, about,
          {end_of(arrangement_, after ? path.curves.back() : path.curves.front(), after)},
          fmt::format("{} curve ends meet in one point", nodes_.ends[node].size()),
          "remove the curves that lie outside the shape");
    }
  }

  Arrangement& arrangement_;
  const Nodes& nodes_;
  const std::vector<Loop>& loops_;
  const WindingIndex winding_;
  std::set<int> told_;
};

}  // namespace

void tell_features(Arrangement& arrangement, Nodes& nodes) {
  std::vector<char> use(arrangement.curves.size());
  for (int i = 0; i < arrangement.size(); ++i) {
    if (arrangement.feature[i] != kMarked) arrangement.feature[i] = kBounds;
    use[i] = arrangement.feature[i] == kBounds;
  }
  const bool plain =
      std::all_of(use.begin(), use.end(), [](char c) { return c; }) &&
      std::all_of(nodes.ends.begin(), nodes.ends.end(),
                  [](const std::vector<CurveEnd>& ends) { return ends.size() == 2; });
  if (!plain)
    for (const std::vector<int>& block : blocks_of(arrangement, nodes, use)) {
      const bool closed =
          block.size() > 1 || nodes.of_curve[block[0]][0] == nodes.of_curve[block[0]][1];
      for (const int curve : block) arrangement.feature[curve] = kBoundsNothing;
      if (!closed) continue;
      for (const int curve : rim_of(arrangement, nodes, block))
        arrangement.feature[curve] = kBounds;
    }
  nodes.boundary = nodes.ends;
  for (auto& ends : nodes.boundary)
    std::erase_if(ends, [&](const CurveEnd& end) { return arrangement.feature[end.curve]; });
}

void report_copies(Arrangement& arrangement) {
  for (int i = 0; i < arrangement.size(); ++i) {
    if (arrangement.copies[i].empty()) continue;
    Defect& defect =
        arrangement.feature[i]
            ? arrangement.mend(DefectKind::note, {i}, {arrangement.curves[i].start()},
                               "a curve between two parts is given by both; it is used once")
            : arrangement.report(DefectKind::duplicate, {i}, {arrangement.curves[i].start()},
                                 "a curve is given twice", "remove one of the two");
    defect.curves.insert(defect.curves.end(), arrangement.copies[i].begin(),
                         arrangement.copies[i].end());
  }
}

std::vector<FeaturePath> paths_of(const std::vector<CurveUse>& loop, const Nodes& nodes) {
  const auto branches = [&](const CurveUse& use) {
    return nodes.ends[node_of(nodes, use, false)].size() != 2;
  };
  std::size_t first = 0;
  while (first < loop.size() && !branches(loop[first])) ++first;
  if (first == loop.size()) return {{loop, true}};
  std::vector<FeaturePath> out;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const CurveUse& use = loop[(first + k) % loop.size()];
    if (branches(use)) out.emplace_back();
    out.back().curves.push_back(use);
  }
  return out;
}

std::vector<FeaturePath> feature_paths(const Arrangement& arrangement, const Nodes& nodes) {
  std::vector<FeaturePath> out;
  std::vector<char> used(arrangement.curves.size(), 0);
  const auto walk = [&](CurveUse use) {
    std::vector<CurveUse> curves;
    while (!used[use.curve]) {
      used[use.curve] = 1;
      curves.push_back(use);
      const auto& ends = nodes.ends[node_of(nodes, use, true)];
      if (ends.size() != 2) break;
      const bool arrived_first = ends[0].curve == use.curve && ends[0].at_end == !use.reversed;
      const CurveEnd next = arrived_first ? ends[1] : ends[0];
      use = {next.curve, next.at_end};
    }
    return curves;
  };
  // Open paths begin at every end that is no plain joint; what is left is closed.
  for (int i = 0; i < arrangement.size(); ++i)
    for (const bool at_end : {false, true})
      if (arrangement.feature[i] && !used[i] && nodes.ends[nodes.of_curve[i][at_end]].size() != 2)
        out.push_back({walk({i, at_end}), false});
  for (int i = 0; i < arrangement.size(); ++i)
    if (arrangement.feature[i] && !used[i]) out.push_back({walk({i, false}), true});
  return out;
}

void check_features(Arrangement& arrangement, const Nodes& nodes, const std::vector<Loop>& loops,
                    const std::vector<FeaturePath>& features, const Pieces& pieces) {
  // Loops that touch in a point are reported and missing here: inside and outside are not known.
  if (std::any_of(nodes.boundary.begin(), nodes.boundary.end(),
                  [](const std::vector<CurveEnd>& ends) { return ends.size() > 2; }))
    return;
  FeatureCheck check(arrangement, nodes, loops, pieces);
  for (const FeaturePath& path : features) check.check(path);
}

}  // namespace c1mesh::detail
