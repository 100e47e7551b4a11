// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/pieces.h"

#include <cmath>
#include <numbers>

namespace c1mesh::detail {
namespace {

constexpr double kWidestCone = std::numbers::pi / 3;
// Regular curves need far fewer halvings: their derivative is at least 1e-9 of their size.
constexpr int kDeepestCut = 60;

double angle_between(const Point& from, const Point& to) {
  return std::atan2(cross(from, to), from.dot(to));
}

class Cutter {
 public:
  Cutter(Pieces& out, int first_free_node) : out_(out), next_node_(first_free_node) {}

  void cut(const Piece& piece, int depth) {
    if (depth >= kDeepestCut || hodograph_cone(piece.poles).width() < kWidestCone) {
      out_.all.push_back(piece);
      return;
    }
    Piece first, second;
    halve(piece, first, second);
    first.node1 = second.node0 = next_node_++;
    cut(first, depth + 1);
    cut(second, depth + 1);
  }

 private:
  Pieces& out_;
  int next_node_;
};

}  // namespace

Cone hodograph_cone(const Poles2& poles) {
  Cone cone;
  // The chord as axis keeps the angles of a curve that turns less than pi within (-pi, pi).
  cone.axis = poles.back() - poles.front();
  for (std::size_t i = 0; i + 1 < poles.size() && cone.axis.isZero(0); ++i)
    cone.axis = poles[i + 1] - poles[i];
  for (std::size_t i = 0; i + 1 < poles.size(); ++i) {
    const Point step = poles[i + 1] - poles[i];
    if (step.isZero(0)) continue;
    const double angle = angle_between(cone.axis, step);
    cone.low = std::min(cone.low, angle);
    cone.high = std::max(cone.high, angle);
  }
  return cone;
}

bool disjoint(const Cone& a, const Cone& b) {
  constexpr double pi = std::numbers::pi;
  if (a.width() >= pi || b.width() >= pi) return false;
  const double turn = angle_between(a.axis, b.axis);
  for (const double shift : {-2 * pi, 0.0, 2 * pi}) {
    const double low = turn + shift + b.low, high = turn + shift + b.high;
    if (low <= a.high && a.low <= high) return false;
  }
  return true;
}

void halve(const Poles2& poles, Poles2& first, Poles2& second) {
  first.clear();
  second = poles;
  const std::size_t n = poles.size() - 1;
  first.reserve(n + 1);
  first.push_back(second[0]);
  for (std::size_t last = n; last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i) second[i] = (second[i] + second[i + 1]) / 2;
    first.push_back(second[0]);
    // second[last] keeps its value: after all rounds `second` holds the right half in order.
  }
}

void halve(const Piece& piece, Piece& first, Piece& second) {
  const double middle = piece.t0 + (piece.t1 - piece.t0) / 2;
  first.curve = second.curve = piece.curve;
  halve(piece.poles, first.poles, second.poles);
  first.t0 = piece.t0;
  first.t1 = second.t0 = middle;
  second.t1 = piece.t1;
  first.node0 = piece.node0;
  second.node1 = piece.node1;
  first.node1 = second.node0 = -1;
}

Pieces cut(const Arrangement& arrangement, const Nodes& nodes, const std::vector<char>& regular) {
  Pieces out;
  int next_node = static_cast<int>(nodes.ends.size());
  for (int i = 0; i < arrangement.size(); ++i) {
    out.first.push_back(static_cast<int>(out.all.size()));
    Piece whole;
    whole.curve = i;
    whole.poles = arrangement.normalised(i).poles;
    whole.node0 = nodes.of_curve[i][0];
    whole.node1 = nodes.of_curve[i][1];
    if (regular[i])
      Cutter(out, next_node).cut(whole, 0);
    else
      out.all.push_back(whole);
    next_node += static_cast<int>(out.all.size()) - out.first.back();
  }
  out.first.push_back(static_cast<int>(out.all.size()));
  return out;
}

}  // namespace c1mesh::detail
