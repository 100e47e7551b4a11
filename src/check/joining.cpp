// SPDX-License-Identifier: GPL-3.0-or-later
// From curves to loops, by their end points.
#include <fmt/format.h>

#include <algorithm>

#include "check/stages.h"

namespace c1mesh::detail {
namespace {

class Joiner {
 public:
  Joiner(Arrangement& arrangement, const Nodes& nodes)
      : arrangement_(arrangement), nodes_(nodes), used_(arrangement.feature) {}

  std::vector<Loop> join() {
    report_branchings();
    use_chains();
    std::vector<Loop> loops;
    for (int i = 0; i < arrangement_.size(); ++i)
      if (!used_[i]) loops.push_back(directed(walk({i, false})));
    return loops;
  }

 private:
  int node_after(const CurveUse& use) const { return nodes_.of_curve[use.curve][!use.reversed]; }

  void report_branchings() {
    for (const auto& ends : nodes_.boundary) {
      if (ends.size() <= 2) continue;
      std::vector<int> about;
      for (const CurveEnd& end : ends)
        if (about.empty() || about.back() != end.curve) about.push_back(end.curve);
      const BezierCurve& curve = arrangement_.curves[ends[0].curve];
      const Point where = ends[0].at_end ? curve.end() : curve.start();
      arrangement_.report(DefectKind::touching, about, {where},
                          fmt::format("{} curve ends meet in one point", ends.size()),
                          "move the loops apart, so that each passes through its points once");
    }
  }

  // What hangs between branchings forms no loop; the branchings account for it. Without features
  // there are no single ends.
  void use_chains() {
    for (const auto& ends : nodes_.boundary) {
      if (ends.size() == 2) continue;
      for (const CurveEnd& end : ends)
        if (!used_[end.curve]) walk({end.curve, end.at_end});
    }
  }

  // Follows curves from `use` on until the loop closes or the next node is no plain joint.
  Loop walk(CurveUse use) {
    Loop out;
    while (!used_[use.curve]) {
      used_[use.curve] = 1;
      out.push_back(use);
      const auto& ends = nodes_.boundary[node_after(use)];
      if (ends.size() != 2) break;
      const bool arrived_first = ends[0].curve == use.curve && ends[0].at_end == !use.reversed;
      const CurveEnd next = arrived_first ? ends[1] : ends[0];
      use = {next.curve, next.at_end};
    }
    return out;
  }

  // In the direction of most of its curves, starting with its first curve; those stored against it
  // are noted.
  Loop directed(Loop loop) {
    const auto backward =
        std::count_if(loop.begin(), loop.end(), [](const CurveUse& use) { return use.reversed; });
    if (2 * backward > static_cast<long>(loop.size())) loop = reversed_loop(loop);
    std::vector<int> about;
    std::vector<Point> where;
    for (const CurveUse& use : loop)
      if (use.reversed) {
        about.push_back(use.curve);
        where.push_back(arrangement_.curves[use.curve].start());
      }
    if (!about.empty())
      arrangement_.mend(DefectKind::note, about, where,
                        fmt::format("{} curve{} stored against the direction of the loop and used "
                                    "reversed",
                                    about.size(), about.size() == 1 ? " is" : "s are"));
    return loop;
  }

  static Loop reversed_loop(const Loop& loop) {
    Loop out = {loop.front()};
    out.insert(out.end(), loop.rbegin(), loop.rend() - 1);
    for (CurveUse& use : out) use.reversed = !use.reversed;
    return out;
  }

  Arrangement& arrangement_;
  const Nodes& nodes_;
  std::vector<char> used_;
};

}  // namespace

std::vector<Loop> join(Arrangement& arrangement, const Nodes& nodes) {
  return Joiner(arrangement, nodes).join();
}

}  // namespace c1mesh::detail
