// SPDX-License-Identifier: GPL-3.0-or-later
// Features that end on a curve, or cross each other: the curves are cut there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bernstein/curve.h"
#include "check/box_pairs.h"
#include "check/meeting.h"
#include "check/stages.h"

namespace c1mesh::detail {
namespace {

// An end is moved only if that is small against its curve.
constexpr double kLargestGapOfCurve = 0.25;
constexpr double kParallel = 1e-4;
constexpr std::size_t kMostPairs = 50'000'000, kMostEnds = 10'000, kMostTests = 200'000'000;

struct Foot {
  double t = 0, distance = INFINITY;
};

// The nearest point of a curve: the best of some samples, then Newton on (c - p).c'.
Foot nearest(const BezierCurve& curve, const Point& p) {
  constexpr int samples = 32;
  Foot best;
  for (int k = 0; k <= samples; ++k) {
    const double t = double(k) / samples, d = (evaluate(curve, t) - p).norm();
    if (d < best.distance) best = {t, d};
  }
  double low = std::max(0.0, best.t - 1.0 / samples), high = std::min(1.0, best.t + 1.0 / samples);
  for (int k = 0; k < 80; ++k) {
    const double middle = 0.5 * (low + high);
    ((evaluate(curve, middle) - p).dot(derivative(curve, middle)) > 0 ? high : low) = middle;
  }
  for (const double t : {low, high}) {
    const double d = (evaluate(curve, t) - p).norm();
    if (d < best.distance) best = {t, d};
  }
  return best;
}

class Attacher {
 public:
  Attacher(Arrangement& arrangement, const Nodes& nodes, double tolerance)
      : arrangement_(arrangement),
        radius_(std::max(tolerance, kResolution) * arrangement.extent),
        nodes_(nodes) {
    for (const auto& ends : nodes_.ends) {
      place_.push_back(point_of(ends[0]));
      if (ends.size() == 1) dangling_.push_back(ends[0]);
    }
    std::sort(dangling_.begin(), dangling_.end(), [](const CurveEnd& a, const CurveEnd& b) {
      return std::pair(a.curve, a.at_end) < std::pair(b.curve, b.at_end);
    });
  }

  bool run() {
    if (dangling_.size() > kMostEnds) return false;
    bool any = false;
    for (std::size_t k = 0; k < dangling_.size(); ++k)
      any |= to_node(dangling_[k]) || to_end(k) || to_curve(dangling_[k]);
    return cut_at_nodes() || any;
  }

 private:
  Point point_of(const CurveEnd& end) const {
    const BezierCurve& curve = arrangement_.curves[end.curve];
    return end.at_end ? curve.end() : curve.start();
  }

  double reach(const CurveEnd& end) const {
    return std::min(radius_, kLargestGapOfCurve * size_of(arrangement_.curves[end.curve]));
  }

  // Curves are cut where others meet on them, to the resolution: these are not moved.
  bool cut_at_nodes() {
    if (nodes_.ends.size() * arrangement_.curves.size() > kMostTests) return false;
    std::vector<Box> boxes;
    const double distance = 8 * kResolution * arrangement_.extent;
    const auto add_box = [&](int i) {
      boxes.push_back(box_of(arrangement_.curves[i].poles, distance));
    };
    for (int i = 0; i < arrangement_.size(); ++i) add_box(i);
    bool any = false;
    for (std::size_t k = 0; k < nodes_.ends.size(); ++k) {
      if (nodes_.ends[k].size() < 2) continue;
      const Point& p = place_[k];
      for (int i = 0; i < arrangement_.size(); ++i) {
        const Box& box = boxes[i];
        if ((p.array() < box.low.array()).any() || (p.array() > box.high.array()).any()) continue;
        const Foot foot = nearest(arrangement_.curves[i], p);
        if (foot.distance > distance || !well_inside(i, foot)) continue;
        cut_curve(arrangement_, i, foot.t);
        add_box(arrangement_.size() - 1);
        arrangement_.curves[i].poles.back() = arrangement_.curves.back().poles.front() = p;
        arrangement_.mend(DefectKind::note, {i, nodes_.ends[k][0].curve}, {p},
                          "curves meet on the inside of another, which is cut there");
        any = true;
      }
    }
    return any;
  }

  // A point where other curves meet already.
  bool to_node(const CurveEnd& end) {
    const Point p = point_of(end);
    double best = reach(end);
    int found = -1;
    for (std::size_t k = 0; k < nodes_.ends.size(); ++k) {
      const auto& ends = nodes_.ends[k];
      if (ends.size() < 2 || ends[0].curve == end.curve || ends[1].curve == end.curve) continue;
      const double d = (place_[k] - p).norm();
      if (d <= best) best = d, found = static_cast<int>(k);
    }
    if (found < 0) return false;
    attach(end, place_[found], nodes_.ends[found][0].curve, false);
    return true;
  }

  // Other single ends, of which there are several near: pairs have been closed before.
  bool to_end(std::size_t k) {
    const CurveEnd end = dangling_[k];
    double best = reach(end);
    CurveEnd found;
    for (const CurveEnd& other : dangling_) {
      if (other.curve == end.curve) continue;
      const double d = (point_of(other) - point_of(end)).norm();
      if (d <= best) best = d, found = other;
    }
    if (found.curve < 0) return false;
    if (best > 0) attach(end, point_of(found), found.curve, false);
    return true;
  }

  bool to_curve(const CurveEnd& end) {
    const Point p = point_of(end);
    double best = reach(end), at = -1;
    int found = -1;
    for (int i = 0; i < arrangement_.size(); ++i) {
      if (i == end.curve || !near_box(i, p, best)) continue;
      const Foot foot = nearest(arrangement_.curves[i], p);
      if (foot.distance > best || !well_inside(i, foot)) continue;
      best = foot.distance;
      at = foot.t;
      found = i;
    }
    if (found < 0) return false;
    cut(found, at);
    attach(end, arrangement_.curves[found].end(), found, true);
    return true;
  }

  // Nearer to an end of the curve than an end may be moved, the two ends are meant to meet.
  bool well_inside(int curve, const Foot& foot) const {
    const BezierCurve& c = arrangement_.curves[curve];
    const Point q = evaluate(c, foot.t);
    const double least = foot.distance <= 8 * kResolution * arrangement_.extent
                             ? 8 * kResolution * arrangement_.extent
                             : radius_;
    return (q - c.start()).norm() > least && (q - c.end()).norm() > least;
  }

  bool near_box(int curve, const Point& p, double distance) const {
    const Box box = box_of(arrangement_.curves[curve].poles, distance);
    return (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
  }

  // The curve keeps its first part, the second is appended; its dangling end goes with it.
  void cut(int curve, double t) {
    cut_curve(arrangement_, curve, t);
    for (CurveEnd& other : dangling_)
      if (other.curve == curve && other.at_end) other.curve = arrangement_.size() - 1;
  }

  void attach(const CurveEnd& end, const Point& target, int to, bool was_cut) {
    const Point p = point_of(end);
    const double moved = (target - p).norm();
    move_end(arrangement_.curves[end.curve], end.at_end, target);
    const char* there = was_cut ? "the inside of another, which is cut there" : "a joint of others";
    if (moved <= kResolution * arrangement_.extent)
      arrangement_.mend(DefectKind::note, {end.curve, to}, {target},
                        fmt::format("a curve ends on {}", there));
    else
      arrangement_.mend(DefectKind::gap, {end.curve, to}, {p, target},
                        fmt::format("a curve ended {:.3g} ({:.2g} of the extent) beside {}; its "
                                    "end was moved there",
                                    moved, moved / arrangement_.extent, there));
  }

  Arrangement& arrangement_;
  double radius_;
  const Nodes& nodes_;
  std::vector<Point> place_;  // per node, before any curve was cut
  std::vector<CurveEnd> dangling_;
};

// Where features cross, per curve: parameter and point.
using Cuts = std::map<int, std::map<double, Point>>;

class Crosser {
 public:
  Crosser(Arrangement& arrangement, const Nodes& nodes) : arrangement_(arrangement) {
    const Pieces pieces =
        detail::cut(arrangement, nodes, std::vector<char>(arrangement.curves.size(), 1));
    std::vector<Box> boxes;
    std::vector<const Piece*> of_features;
    for (const Piece& piece : pieces.all)
      if (arrangement.feature[piece.curve]) {
        of_features.push_back(&piece);
        boxes.push_back(box_of(piece.poles, kResolution));
      }
    std::vector<std::pair<int, int>> pairs;
    if (!overlapping_pairs(boxes, kMostPairs, pairs)) return;
    std::vector<Meeting> found;
    long effort = kMostEffort;  // whoever uses it up is refused when all curves are compared
    for (const auto& [i, j] : pairs)
      if (of_features[i]->curve != of_features[j]->curve)
        find_meetings(*of_features[i], *of_features[j], found, effort);
    for (const Meeting& m : found) add(m);
  }

  bool run() {
    for (const auto& [curve, cuts] : cuts_) {
      // From the end, so that the first part keeps its parameters: t of the part that is left.
      double last = 1;
      for (auto it = cuts.rbegin(); it != cuts.rend(); ++it) {
        cut_curve(arrangement_, curve, it->first / last);
        arrangement_.curves[curve].poles.back() = it->second;
        arrangement_.curves.back().poles.front() = it->second;
        last = it->first;
      }
    }
    return !cuts_.empty();
  }

 private:
  // Newton on a(s) = b(t) brings both parameters to rounding.
  void add(const Meeting& m) {
    const BezierCurve a = arrangement_.normalised(m.curve_a),
                      b = arrangement_.normalised(m.curve_b);
    double s = m.t_a, t = m.t_b;
    const Point da = derivative(a, s), db = derivative(b, t);
    if (std::abs(cross(da, db)) <= kParallel * da.norm() * db.norm()) return;
    for (int k = 0; k < 4; ++k) {
      const Point u = derivative(a, s), v = derivative(b, t), w = evaluate(b, t) - evaluate(a, s);
      s += cross(w, v) / cross(u, v);
      t += cross(w, u) / cross(u, v);
    }
    const auto within = [](double x) { return x > 1e-9 && x < 1 - 1e-9; };
    if (!within(s) || !within(t)) return;  // at an end: a touch, not a crossing
    Point where = arrangement_.frame.restore(evaluate(a, s));
    for (const Point& known : places_)
      if ((known - where).norm() < 8 * kResolution * arrangement_.extent) where = known;
    places_.push_back(where);
    enter(m.curve_a, s, where);
    enter(m.curve_b, t, where);
    arrangement_.mend(DefectKind::note, {m.curve_a, m.curve_b}, {where},
                      "two features cross; both are cut there");
  }

  void enter(int curve, double t, const Point& where) {
    for (const auto& [known, place] : cuts_[curve])
      if (place == where) return;
    cuts_[curve][t] = where;
  }

  Arrangement& arrangement_;
  Cuts cuts_;
  std::vector<Point> places_;
};

// Where nothing bounds, there is no shape whose features the others could be.
bool has_both(const Arrangement& arrangement) {
  const auto count = std::count(arrangement.feature.begin(), arrangement.feature.end(), kBounds);
  return count != 0 && count != arrangement.size();
}

}  // namespace

void cut_curve(Arrangement& arrangement, int curve, double t) {
  const BezierCurve whole = arrangement.curves[curve];
  arrangement.curves[curve] = restrict_exactly(whole, 0, t, whole.degree());
  arrangement.curves.push_back(restrict_exactly(whole, t, 1, whole.degree()));
  arrangement.ids.push_back(arrangement.ids[curve]);
  arrangement.feature.push_back(arrangement.feature[curve]);
  arrangement.copies.push_back(arrangement.copies[curve]);
}

bool attach_ends(Arrangement& arrangement, const Nodes& nodes, double tolerance) {
  return has_both(arrangement) && Attacher(arrangement, nodes, tolerance).run();
}

bool cut_crossings(Arrangement& arrangement, const Nodes& nodes, double) {
  return has_both(arrangement) && Crosser(arrangement, nodes).run();
}

}  // namespace c1mesh::detail
