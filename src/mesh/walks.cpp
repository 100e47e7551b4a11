// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/walks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "bernstein/curve.h"
#include "mesh/warp_segment.h"

namespace c1mesh::meshing {
namespace {

class Walker {
 public:
  explicit Walker(const MeshInput& input) {
    for (std::size_t l = 0; l < input.loops.size(); ++l)
      for (std::size_t k = 0; k < input.loops[l].size(); ++k)
        add(input.loops[l][k], false, static_cast<int>(l), static_cast<int>(k), true);
    for (std::size_t f = 0; f < input.features.size(); ++f)
      for (std::size_t k = 0; k < input.features[f].curves.size(); ++k) {
        const LoopCurve& curve = input.features[f].curves[k];
        const int first = static_cast<int>(steps_.size());
        add(curve, true, static_cast<int>(f), static_cast<int>(k), true);
        add({reversed(curve.bezier), curve.curve, !curve.reversed}, true, static_cast<int>(f),
            static_cast<int>(k), false);
        twin_[first] = first + 1;
        twin_[first + 1] = first;
      }
  }

  Walks run() {
    Walks walks;
    std::vector<std::pair<int, int>> place(steps_.size(), {-1, -1});
    for (int first = 0; first < static_cast<int>(steps_.size()); ++first) {
      if (place[first].first >= 0) continue;
      auto& walk = walks.emplace_back();
      for (int at = first; place[at].first < 0; at = next(at)) {
        place[at] = {static_cast<int>(walks.size()) - 1, static_cast<int>(walk.size())};
        walk.push_back(steps_[at]);
        std::tie(walk.back().walk, walk.back().index) = place[at];
      }
    }
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (twin_[i] >= 0)
        std::tie(walks[place[i].first][place[i].second].twin_walk,
                 walks[place[i].first][place[i].second].twin_index) = place[twin_[i]];
    return walks;
  }

 private:
  int point(const Point& p) {
    return points_.emplace(std::pair(p.x(), p.y()), static_cast<int>(points_.size())).first->second;
  }

  void add(const LoopCurve& curve, bool feature, int path, int position, bool forward) {
    WalkStep step;
    step.curve = curve;
    step.feature = feature;
    step.path = path;
    step.position = position;
    step.forward = forward;
    step.start = point(curve.bezier.start());
    step.end = point(curve.bezier.end());
    leaving_[step.start].push_back(static_cast<int>(steps_.size()));
    steps_.push_back(std::move(step));
    twin_.push_back(-1);
  }

  // The step that leaves along the sector to the left: the next one clockwise from where the walk
  // comes from.
  int next(int at) const {
    const std::vector<int>& leaving = leaving_.at(steps_[at].end);
    if (leaving.size() == 1) return leaving[0];
    const Point in = end_direction(steps_[at].curve.bezier);
    int best = -1;
    double least = INFINITY;
    for (const int other : leaving) {
      const double sector = other == twin_[at]
                                ? INFINITY
                                : interior_angle(in, start_direction(steps_[other].curve.bezier));
      if (best < 0 || sector < least) best = other, least = sector;
    }
    return best;
  }

  std::vector<WalkStep> steps_;
  std::vector<int> twin_;
  std::map<std::pair<double, double>, int> points_;
  std::map<int, std::vector<int>> leaving_;
};

}  // namespace

Walks walks_of(const MeshInput& input) {
  return Walker(input).run();
}

}  // namespace c1mesh::meshing
