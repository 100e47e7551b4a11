// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meeting.h"

#include <algorithm>
#include <cmath>

namespace c1mesh::detail {
namespace {

constexpr int kMostPerPair = 8;
constexpr double kSamePlace = 1e-6;
// Safety only: flatness is reached after about 20 halvings.
constexpr int kDeepest = 64;
// Overlaps give up early through kMostPerPair; this bounds curves that run side by side just
// farther apart than the resolution. What is left undecided then counts as meeting.
constexpr int kMostSteps = 4'000'000;

struct Interval {
  double low, high;
};

Interval shadow(const Poles2& poles, const Point& axis) {
  Interval out{INFINITY, -INFINITY};
  for (const Point& p : poles) {
    const double x = axis.dot(p);
    out.low = std::min(out.low, x);
    out.high = std::max(out.high, x);
  }
  return out;
}

bool apart_along(const Poles2& a, const Poles2& b, const Point& axis) {
  const Interval x = shadow(a, axis), y = shadow(b, axis);
  return std::max(x.low - y.high, y.low - x.high) > kResolution;
}

// Are the hulls apart along the coordinate axes or across either chord?
bool apart(const Poles2& a, const Poles2& b) {
  if (apart_along(a, b, {1, 0}) || apart_along(a, b, {0, 1})) return true;
  for (const Poles2* poles : {&a, &b}) {
    const Point chord = poles->back() - poles->front();
    const double length = chord.norm();
    if (length > 0 && apart_along(a, b, Point(-chord.y(), chord.x()) / length)) return true;
  }
  return false;
}

double distance_to_segment(const Point& p, const Point& a, const Point& b, double& s) {
  const Point chord = b - a;
  const double square = chord.squaredNorm();
  s = square > 0 ? std::clamp((p - a).dot(chord) / square, 0.0, 1.0) : 0;
  return (a + s * chord - p).norm();
}

bool flat(const Poles2& poles) {
  double s;
  for (std::size_t i = 1; i + 1 < poles.size(); ++i)
    if (distance_to_segment(poles[i], poles.front(), poles.back(), s) > kResolution / 8)
      return false;
  return true;
}

// The closest pair of points of two segments, as fractions of each; returns the distance.
double closest(const Poles2& a, const Poles2& b, double& s, double& t) {
  const Point u = a.back() - a.front(), v = b.back() - b.front(), w = b.front() - a.front();
  const double det = cross(u, v);
  if (det != 0) {
    s = cross(w, v) / det;
    t = cross(w, u) / det;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return 0;
  }
  double best = INFINITY, x;
  const auto offer = [&](double d, double at_a, double at_b) {
    if (d < best) best = d, s = at_a, t = at_b;
  };
  double d = distance_to_segment(a.front(), b.front(), b.back(), x);
  offer(d, 0, x);
  d = distance_to_segment(a.back(), b.front(), b.back(), x);
  offer(d, 1, x);
  d = distance_to_segment(b.front(), a.front(), a.back(), x);
  offer(d, x, 0);
  d = distance_to_segment(b.back(), a.front(), a.back(), x);
  offer(d, x, 1);
  return best;
}

class Search {
 public:
  Search(std::vector<Meeting>& out, long& effort)
      : out_(out), effort_(effort), first_(out.size()) {}

  // Pieces without a common end.
  void apart_pieces(const Piece& a, const Piece& b, int depth = 0) {
    if (full() || apart(a.poles, b.poles)) return;
    const bool flat_a = flat(a.poles), flat_b = flat(b.poles);
    if ((flat_a && flat_b) || depth >= kDeepest || ++steps_ > kMostSteps) return segments(a, b);
    --effort_;
    const bool cut_a = !flat_a && (flat_b || size(a) >= size(b));
    Piece first, second;
    halve(cut_a ? a : b, first, second);
    for (const Piece* half : {&first, &second})
      cut_a ? apart_pieces(*half, b, depth + 1) : apart_pieces(a, *half, depth + 1);
  }

  // Pieces that both start at their common end.
  void from_common_start(const Piece& a, const Piece& b, int depth = 0) {
    if (full() || disjoint(hodograph_cone(a.poles), hodograph_cone(b.poles))) return;
    if (depth >= kDeepest || std::max(size(a), size(b)) < 4 * kResolution) return;
    Piece near_a, far_a, near_b, far_b;
    halve(a, near_a, far_a);
    halve(b, near_b, far_b);
    from_common_start(near_a, near_b, depth + 1);
    apart_pieces(far_a, near_b);
    apart_pieces(near_a, far_b);
    apart_pieces(far_a, far_b);
  }

 private:
  static double size(const Piece& piece) {
    return std::max((piece.end() - piece.start()).cwiseAbs().maxCoeff(),
                    (piece.poles[piece.poles.size() / 2] - piece.start()).cwiseAbs().maxCoeff());
  }

  bool full() const { return effort_ <= 0 || out_.size() - first_ >= kMostPerPair; }

  void segments(const Piece& a, const Piece& b) {
    double s, t;
    if (closest(a.poles, b.poles, s, t) > kResolution && steps_ <= kMostSteps) return;
    Meeting found;
    found.curve_a = a.curve;
    found.curve_b = b.curve;
    found.t_a = a.t0 + s * (a.t1 - a.t0);
    found.t_b = b.t0 + t * (b.t1 - b.t0);
    found.where = a.start() + s * (a.end() - a.start());
    for (std::size_t i = first_; i < out_.size(); ++i)
      if ((out_[i].where - found.where).norm() < kSamePlace) return;
    out_.push_back(found);
  }

  std::vector<Meeting>& out_;
  long& effort_;
  std::size_t first_;
  int steps_ = 0;
};

Piece turned(const Piece& piece) {
  Piece out = piece;
  std::reverse(out.poles.begin(), out.poles.end());
  std::swap(out.t0, out.t1);
  std::swap(out.node0, out.node1);
  return out;
}

}  // namespace

void find_meetings(const Piece& a, const Piece& b, std::vector<Meeting>& out, long& effort) {
  Search search(out, effort);
  const bool start_a = a.node0 == b.node0 || a.node0 == b.node1;
  const bool end_a = a.node1 == b.node0 || a.node1 == b.node1;
  if (!start_a && !end_a) return search.apart_pieces(a, b);
  if (start_a && end_a) {
    // Common at both ends: each half of `a` is common with the half of `b` at its own end.
    Piece a0, a1, b0, b1;
    halve(a, a0, a1);
    halve(a.node0 == b.node0 ? b : turned(b), b0, b1);
    search.from_common_start(a0, b0);
    search.from_common_start(turned(a1), turned(b1));
    search.apart_pieces(a0, b1);
    search.apart_pieces(a1, b0);
    return;
  }
  const Piece from = start_a ? a : turned(a);
  search.from_common_start(from, from.node0 == b.node0 ? b : turned(b));
}

bool near_piece(const Piece& piece, const Point& p) {
  Piece point;
  point.poles = {p, p};
  std::vector<Meeting> found;
  long effort = kMostSteps;
  Search(found, effort).apart_pieces(piece, point);
  return !found.empty();
}

}  // namespace c1mesh::detail
