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
constexpr std::size_t kMostPairs = 50'000'000;

struct Foot {
  double t = 0, distance = INFINITY;
};

// Points in square cells: those nearer than a cell's size are in the 3 x 3 cells around.
class Cells {
 public:
  Cells(const Point& origin, double size) : origin_(origin), size_(size) {}
  void add(const Point& p, int item) { items_[cell(p)].push_back(item); }

  /// The items of the cells at most `reach` from p's, by increasing number.
  std::vector<int> near(const Point& p, int reach) const {
    std::vector<int> out;
    const auto [x, y] = cell(p);
    for (int dx = -reach; dx <= reach; ++dx)
      for (int dy = -reach; dy <= reach; ++dy)
        if (const auto found = items_.find({x + dx, y + dy}); found != items_.end())
          out.insert(out.end(), found->second.begin(), found->second.end());
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  std::pair<double, double> cell(const Point& p) const {
    return {std::floor((p.x() - origin_.x()) / size_), std::floor((p.y() - origin_.y()) / size_)};
  }

  Point origin_;
  double size_;
  std::map<std::pair<double, double>, std::vector<int>> items_;
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
        nodes_(nodes),
        node_cells_(arrangement.frame.origin, radius_),
        dangling_cells_(arrangement.frame.origin, radius_),
        parts_(arrangement.curves.size()) {
    for (const auto& ends : nodes_.ends) {
      place_.push_back(point_of(ends[0]));
      if (ends.size() == 1) dangling_.push_back(ends[0]);
      if (ends.size() > 1) node_cells_.add(place_.back(), static_cast<int>(place_.size()) - 1);
    }
    std::sort(dangling_.begin(), dangling_.end(), [](const CurveEnd& a, const CurveEnd& b) {
      return std::pair(a.curve, a.at_end) < std::pair(b.curve, b.at_end);
    });
    std::vector<Point> points;
    for (const CurveEnd& end : dangling_) {
      points.push_back(point_of(end));
      if (end.at_end) dangling_at_end_[end.curve] = static_cast<int>(points.size()) - 1;
      dangling_cells_.add(points.back(), static_cast<int>(points.size()) - 1);
    }
    // A curve is near where its box was, as far as ends are moved: at most two, by the radius.
    around_ends_ = boxes_around(points, curve_boxes(4 * radius_));
  }

  bool run() {
    bool any = false;
    for (std::size_t k = 0; k < dangling_.size(); ++k)
      any |= to_node(dangling_[k]) || to_end(k) || to_curve(k);
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

  std::vector<Box> curve_boxes(double margin) const {
    std::vector<Box> boxes;
    for (const BezierCurve& curve : arrangement_.curves)
      boxes.push_back(box_of(curve.poles, margin));
    return boxes;
  }

  // The curves and what was cut from them since, by increasing number.
  std::vector<int> with_parts(const std::vector<int>& curves) const {
    std::vector<int> out = curves;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::vector<int>& parts = parts_[out[i]];
      out.insert(out.end(), parts.begin(), parts.end());
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  // Curves are cut where others meet on them, to the resolution: these are not moved.
  bool cut_at_nodes() {
    const double distance = 8 * kResolution * arrangement_.extent;
    std::vector<Box> boxes = curve_boxes(distance);
    // A part's box lies in its whole's but for roundings.
    const std::vector<std::vector<int>> around = boxes_around(place_, curve_boxes(2 * distance));
    parts_.assign(arrangement_.curves.size(), {});
    bool any = false;
    for (std::size_t k = 0; k < nodes_.ends.size(); ++k) {
      if (nodes_.ends[k].size() < 2) continue;
      const Point& p = place_[k];
      std::vector<int> curves = with_parts(around[k]);
      for (std::size_t at = 0; at < curves.size(); ++at) {
        const int i = curves[at];
        const Box& box = boxes[i];
        if ((p.array() < box.low.array()).any() || (p.array() > box.high.array()).any()) continue;
        const Foot foot = nearest(arrangement_.curves[i], p);
        if (foot.distance > distance || !well_inside(i, foot)) continue;
        const int part = cut_off(i, foot.t);
        boxes.push_back(box_of(arrangement_.curves[part].poles, distance));
        curves.push_back(part);
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
    for (const int k : node_cells_.near(p, 1)) {
      const auto& ends = nodes_.ends[k];
      if (ends[0].curve == end.curve || ends[1].curve == end.curve) continue;
      const double d = (place_[k] - p).norm();
      if (d <= best) best = d, found = k;
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
    // They may have been moved, as this one, each by one cell at most.
    for (const int index : dangling_cells_.near(point_of(end), 2)) {
      const CurveEnd& other = dangling_[index];
      if (other.curve == end.curve) continue;
      const double d = (point_of(other) - point_of(end)).norm();
      if (d <= best) best = d, found = other;
    }
    if (found.curve < 0) return false;
    if (best > 0) attach(end, point_of(found), found.curve, false);
    return true;
  }

  bool to_curve(std::size_t k) {
    const CurveEnd end = dangling_[k];
    const Point p = point_of(end);
    double best = reach(end), at = -1;
    int found = -1;
    for (const int i : with_parts(around_ends_[k])) {
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
    const int part = cut_off(curve, t);
    const auto found = dangling_at_end_.find(curve);
    if (found == dangling_at_end_.end()) return;
    dangling_[found->second].curve = part;
    dangling_at_end_[part] = found->second;
    dangling_at_end_.erase(found);
  }

  // Returns the new curve, the second part.
  int cut_off(int curve, double t) {
    cut_curve(arrangement_, curve, t);
    const int part = arrangement_.size() - 1;
    parts_[curve].push_back(part);
    parts_.emplace_back();
    return part;
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
  std::map<int, int> dangling_at_end_;         // curve -> its end's place in dangling_
  Cells node_cells_, dangling_cells_;          // where two curves meet or more; dangling ends
  std::vector<std::vector<int>> around_ends_;  // per dangling end: curves that may be near
  std::vector<std::vector<int>> parts_;        // per curve: those cut from it
};

// Where features cross, per curve: parameter and point.
using Cuts = std::map<int, std::map<double, Point>>;

class Crosser {
 public:
  Crosser(Arrangement& arrangement, const Nodes& nodes)
      : arrangement_(arrangement),
        cells_(arrangement.frame.origin, 8 * kResolution * arrangement.extent) {
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
    for (const int known : cells_.near(where, 2))
      if ((places_[known] - where).norm() < 8 * kResolution * arrangement_.extent)
        where = places_[known];
    cells_.add(where, static_cast<int>(places_.size()));
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
  Cells cells_;  // of places_
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
