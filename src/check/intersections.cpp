// SPDX-License-Identifier: GPL-3.0-or-later
// All places where curves meet other than in joints, and what kind of meeting each is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bernstein/curve.h"
#include "check/box_pairs.h"
#include "check/meeting.h"
#include "check/stages.h"

namespace c1mesh::detail {
namespace {

constexpr std::size_t kMostPairs = 20'000'000, kMostReports = 1000;
// Meetings this near (normalised) are told once.
constexpr double kSamePlace = 1e-6;
// Where curves touch they are within the resolution over about its square root, and turn by as
// much.
constexpr double kParallel = 1e-4;
// A curve that meets itself within so small a parameter range turns sharply rather than loops.
constexpr double kSharpTurn = 1e-4;

class Intersections {
 public:
  Intersections(Arrangement& arrangement, const Nodes& nodes, const Pieces& pieces,
                const std::vector<char>& cusp)
      : arrangement_(arrangement), nodes_(nodes), pieces_(pieces), cusp_(cusp) {}

  void run() {
    std::vector<std::pair<int, int>> pairs;
    std::vector<Box> boxes;
    for (const Piece& piece : pieces_.all) boxes.push_back(box_of(piece.poles, kResolution));
    if (!overlapping_pairs(boxes, kMostPairs, pairs)) {
      arrangement_.report(DefectKind::limit, {}, {}, "too many curves overlap each other",
                          "give the boundary of one shape at a time");
      return;
    }
    for (const auto& [i, j] : pairs) {
      const Piece &a = pieces_.all[i], &b = pieces_.all[j];
      if (meet_at_cusp(a, b)) continue;
      const std::size_t before = found_.size();
      find_meetings(a, b, found_, effort_);
      if (effort_ <= 0) {
        report_effort(a, b);
        break;
      }
      forget_branchings(a, b, before);
      if (found_.size() > 4 * kMostReports) break;
    }
    report_all();
  }

 private:
  // Beside a cusp everything is closer than any resolution; the cusp itself has been reported.
  bool meet_at_cusp(const Piece& a, const Piece& b) const {
    for (const int node : {a.node0, a.node1})
      if (node < static_cast<int>(cusp_.size()) && cusp_[node] &&
          (node == b.node0 || node == b.node1))
        return true;
    return false;
  }

  // Curves that share a point with others are often tangent there; the point has been reported.
  void forget_branchings(const Piece& a, const Piece& b, std::size_t from) {
    for (int end = 0; end < 2; ++end) {
      const int node = end ? a.node1 : a.node0;
      if (node >= static_cast<int>(nodes_.boundary.size()) || nodes_.boundary[node].size() <= 2)
        continue;
      if (node != b.node0 && node != b.node1) continue;
      const Point p = end ? a.end() : a.start();
      found_.erase(
          std::remove_if(found_.begin() + static_cast<std::ptrdiff_t>(from), found_.end(),
                         [&](const Meeting& m) { return (m.where - p).norm() < kSamePlace; }),
          found_.end());
    }
  }

  void report_effort(const Piece& a, const Piece& b) {
    std::vector<int> about = {a.curve};
    if (b.curve != a.curve) about.push_back(b.curve);
    arrangement_.report(DefectKind::limit, about, {arrangement_.frame.restore(a.start())},
                        "too many curves run too close side by side to be told apart",
                        "remove copies of curves, or move them apart");
  }

  void report_all() {
    std::stable_sort(found_.begin(), found_.end(), [](const Meeting& a, const Meeting& b) {
      return std::pair(a.curve_a, a.curve_b) < std::pair(b.curve_a, b.curve_b);
    });
    std::size_t reports = 0, first = 0;
    for (std::size_t i = 0; i < found_.size() && reports < kMostReports; ++i) {
      if (found_[i].curve_a != found_[first].curve_a || found_[i].curve_b != found_[first].curve_b)
        first = i;
      bool told = false;
      for (std::size_t k = first; k < i; ++k)
        told |= (found_[k].where - found_[i].where).norm() < kSamePlace;
      if (told) continue;
      report(found_[i]);
      ++reports;
    }
    if (reports == kMostReports)
      arrangement_.report(DefectKind::limit, {}, {}, "more intersections than are worth listing",
                          "give the boundary of one shape at a time");
  }

  void report(const Meeting& m) {
    const Point where = arrangement_.frame.restore(m.where);
    if (m.curve_a == m.curve_b && std::abs(m.t_a - m.t_b) < kSharpTurn) {
      arrangement_.report(
          DefectKind::vanishing_derivative, {m.curve_a}, {where},
          fmt::format("the derivative nearly vanishes at t = {:.6g}: the curve turns "
                      "within less than the resolution",
                      m.t_a),
          "draw it without the cusp, or lengthen the handle");
      return;
    }
    if (m.curve_a == m.curve_b) {
      arrangement_.report(DefectKind::self_intersection, {m.curve_a}, {where},
                          "the curve meets itself", "draw it without the loop");
      return;
    }
    if (parallel(m) && overlap(m)) {
      // One overlap meets in many places; told once per pair of curves.
      if (last_overlap_ == std::pair(m.curve_a, m.curve_b)) return;
      last_overlap_ = {m.curve_a, m.curve_b};
      arrangement_.report(DefectKind::duplicate, {m.curve_a, m.curve_b}, {where},
                          "parts of two curves coincide", "remove one of the two parts");
      return;
    }
    if (parallel(m) || at_end(m.curve_a, m.where) || at_end(m.curve_b, m.where)) {
      arrangement_.report(DefectKind::touching, {m.curve_a, m.curve_b}, {where}, "two curves touch",
                          "move them apart");
      return;
    }
    arrangement_.report(DefectKind::crossing, {m.curve_a, m.curve_b}, {where}, "two curves cross",
                        "move them apart, or unite the shapes in the drawing program");
  }

  bool parallel(const Meeting& m) const {
    const Point a = derivative(arrangement_.normalised(m.curve_a), m.t_a);
    const Point b = derivative(arrangement_.normalised(m.curve_b), m.t_b);
    return std::abs(cross(a, b)) <= kParallel * a.norm() * b.norm();
  }

  Point end_point(int curve, int end) const {
    const BezierCurve& c = arrangement_.curves[curve];
    return arrangement_.frame.normalise(end ? c.end() : c.start());
  }

  bool at_end(int curve, const Point& where) const {
    return (end_point(curve, 0) - where).norm() < 8 * kResolution ||
           (end_point(curve, 1) - where).norm() < 8 * kResolution;
  }

  bool on_curve(int curve, const Point& p) const {
    for (int i = pieces_.first[curve]; i < pieces_.first[curve + 1]; ++i)
      if (near_piece(pieces_.all[i], p)) return true;
    return false;
  }

  // Curves overlap if they are parallel where they meet and an end of one, elsewhere, lies on the
  // other: polynomial curves that share an arc share it up to an end.
  bool overlap(const Meeting& m) const {
    for (const auto& [curve, other] : {std::pair(m.curve_a, m.curve_b), {m.curve_b, m.curve_a}})
      for (int end = 0; end < 2; ++end) {
        const int node = nodes_.of_curve[curve][end];
        const bool joint = node == nodes_.of_curve[other][0] || node == nodes_.of_curve[other][1];
        const Point p = end_point(curve, end);
        if (!joint && (p - m.where).norm() > kSamePlace && on_curve(other, p)) return true;
      }
    return false;
  }

  Arrangement& arrangement_;
  const Nodes& nodes_;
  const Pieces& pieces_;
  const std::vector<char>& cusp_;
  std::vector<Meeting> found_;
  long effort_ = kMostEffort;
  std::pair<int, int> last_overlap_ = {-1, -1};
};

}  // namespace

void check_intersections(Arrangement& arrangement, const Nodes& nodes, const Pieces& pieces,
                         const std::vector<char>& cusp) {
  Intersections(arrangement, nodes, pieces, cusp).run();
}

}  // namespace c1mesh::detail
