// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/curve_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "verify/bernstein_forms.h"
#include "verify/interval.h"

namespace c1mesh::verification {
namespace {

using Curve = std::vector<Vec<Interval>>;

Curve enclosed(const std::vector<Point>& poles) {
  Curve curve;
  for (const Point& p : poles) curve.push_back({Interval(p.x()), Interval(p.y())});
  return curve;
}

Curve turned(Curve curve) {
  std::reverse(curve.begin(), curve.end());
  return curve;
}

std::array<Curve, 2> halved(const Curve& curve) {
  const std::size_t n = curve.size() - 1;
  std::array<Curve, 2> out{curve, curve};
  Curve row = curve;
  for (std::size_t level = 0; level <= n; ++level) {
    out[0][level] = row[0];
    out[1][n - level] = row[n - level];
    for (std::size_t i = 0; i + level < n; ++i)
      for (int k = 0; k < 2; ++k) row[i][k] = (row[i][k] + row[i + 1][k]) * Interval(0.5);
  }
  return out;
}

double middle(const Interval& x) {
  return 0.5 * (x.inf() + x.sup());
}

/// A direction is any pair of doubles: what is proven with it holds whatever it is.
using Direction = std::array<double, 2>;

Direction from_to(const Vec<Interval>& a, const Vec<Interval>& b) {
  return {middle(b[0]) - middle(a[0]), middle(b[1]) - middle(a[1])};
}

Direction unit(const Direction& d) {
  const double length = std::hypot(d[0], d[1]);
  if (!(length > 0)) return {0, 0};
  return {d[0] / length, d[1] / length};
}

Interval along(const Vec<Interval>& p, const Direction& d) {
  return p[0] * Interval(d[0]) + p[1] * Interval(d[1]);
}

/// Range of a linear function over the control polygon, hence over the curve.
Interval range(const Curve& curve, const Direction& d) {
  Interval out = along(curve[0], d);
  for (const auto& p : curve) {
    const Interval x = along(p, d);
    out = Interval(std::min(out.inf(), x.inf()), std::max(out.sup(), x.sup()));
  }
  return out;
}

bool separated(const Curve& a, const Curve& b, const Direction& d) {
  const Interval ra = range(a, d), rb = range(b, d);
  return ra.sup() < rb.inf() || rb.sup() < ra.inf();
}

Direction normal_of(const Curve& curve) {
  const Direction chord = from_to(curve.front(), curve.back());
  return {-chord[1], chord[0]};
}

bool hulls_apart(const Curve& a, const Curve& b) {
  return separated(a, b, {1, 0}) || separated(a, b, {0, 1}) || separated(a, b, normal_of(a)) ||
         separated(a, b, normal_of(b)) || separated(a, b, from_to(a.front(), b.front())) ||
         separated(a, b, from_to(a.back(), b.back()));
}

/// The ends of b lie on different sides of the strip (between parallels to a's chord) that holds a.
bool straddles(const Curve& a, const Curve& b) {
  const Direction d = normal_of(a);
  const Interval strip = range(a, d), start = along(b.front(), d), end = along(b.back(), d);
  return (start.sup() < strip.inf() && end.inf() > strip.sup()) ||
         (end.sup() < strip.inf() && start.inf() > strip.sup());
}

/// Each crosses the other's strip from side to side: within the parallelogram of the two strips one
/// joins the left side to the right and the other the top to the bottom, so they meet.
bool certainly_cross(const Curve& a, const Curve& b) {
  return straddles(a, b) && straddles(b, a);
}

bool is_zero(const Vec<Interval>& v) {
  return v[0].inf() == 0 && v[0].sup() == 0 && v[1].inf() == 0 && v[1].sup() == 0;
}

Vec<Interval> difference(const Vec<Interval>& a, const Vec<Interval>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

/// All control vectors from the curve's start have a positive (sign > 0) or negative component
/// along d. Vectors that are exactly zero do not matter as long as one is not.
bool leaves_along(const Curve& curve, const Direction& d, int sign) {
  bool moves = false;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Vec<Interval> v = difference(curve[i], curve[0]);
    if (is_zero(v)) continue;
    const Interval x = along(v, d);
    if (sign > 0 ? !certainly_positive(x) : !certainly_negative(x)) return false;
    moves = true;
  }
  return moves;
}

/// Direction in which the curve leaves its start: the first control vector that is not zero.
Direction tangent(const Curve& curve) {
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (!is_zero(difference(curve[i], curve[0]))) return unit(from_to(curve[0], curve[i]));
  return {0, 0};
}

/// A line through the common start keeps the two curves strictly apart everywhere else.
bool cones_apart(const Curve& a, const Curve& b) {
  const Direction ta = tangent(a), tb = tangent(b);
  const Direction ca = unit(from_to(a.front(), a.back())), cb = unit(from_to(b.front(), b.back()));
  for (const Direction& d :
       {Direction{tb[0] - ta[0], tb[1] - ta[1]}, Direction{cb[0] - ca[0], cb[1] - ca[1]}})
    if (leaves_along(a, d, -1) && leaves_along(b, d, 1)) return true;
  return false;
}

/// One comparison of two curves; `tree` has the budget for all its pieces.
class Comparison {
 public:
  explicit Comparison(ProofTree& tree) : tree_(tree) {}

  Meeting none(const Curve& a, const Curve& b, int depth) {
    bool cross = false;
    const auto apart = [&] {
      if (hulls_apart(a, b)) return true;
      cross = !tree_.follows() && certainly_cross(a, b);
      return false;
    };
    const ProofTree::Step step = tree_.step(depth, apart);
    if (cross) return Meeting::meet;
    if (step != ProofTree::Step::split) return end(step);
    const auto pa = halved(a), pb = halved(b);
    return worst([&] { return none(pa[0], pb[0], depth + 1); },
                 [&] { return none(pa[0], pb[1], depth + 1); },
                 [&] { return none(pa[1], pb[0], depth + 1); },
                 [&] { return none(pa[1], pb[1], depth + 1); });
  }

  Meeting start(const Curve& a, const Curve& b, int depth) {
    const ProofTree::Step step = tree_.step(depth, [&] { return cones_apart(a, b); });
    if (step != ProofTree::Step::split) return end(step);
    const auto pa = halved(a), pb = halved(b);
    return worst([&] { return start(pa[0], pb[0], depth + 1); },
                 [&] { return none(pa[0], pb[1], depth + 1); },
                 [&] { return none(pa[1], pb[0], depth + 1); },
                 [&] { return none(pa[1], pb[1], depth + 1); });
  }

  Meeting both_ends(const Curve& a, const Curve& b) {
    const ProofTree::Step step = tree_.step(0, [] { return false; });
    if (step != ProofTree::Step::split) return end(step);
    const auto pa = halved(a), pb = halved(b);
    return worst([&] { return start(pa[0], pb[0], 1); }, [&] { return none(pa[0], pb[1], 1); },
                 [&] { return none(pa[1], pb[0], 1); },
                 [&] { return start(turned(pa[1]), turned(pb[1]), 1); });
  }

  Meeting itself(const Curve& curve, int depth) {
    const ProofTree::Step step = tree_.step(depth, [&] { return monotone(curve); });
    if (step != ProofTree::Step::split) return end(step);
    const auto part = halved(curve);
    return worst([&] { return itself(part[0], depth + 1); },
                 [&] { return itself(part[1], depth + 1); },
                 [&] { return start(turned(part[0]), part[1], depth + 1); });
  }

 private:
  static Meeting end(ProofTree::Step step) {
    return step == ProofTree::Step::proven ? Meeting::apart : Meeting::unknown;
  }

  /// The curve moves on along some direction all the time, so it never comes back.
  static bool monotone(const Curve& curve) {
    const Direction chord = from_to(curve.front(), curve.back());
    const Direction first = tangent(curve), last = tangent(turned(curve));
    for (const Direction& d : {chord, Direction{first[0] - last[0], first[1] - last[1]}}) {
      bool moves = false, back = false;
      for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const Vec<Interval> v = difference(curve[i + 1], curve[i]);
        if (is_zero(v)) continue;
        moves = true;
        back = back || !certainly_positive(along(v, d));
      }
      if (moves && !back) return true;
    }
    return false;
  }

  /// A proven meeting anywhere is one; else anything unknown leaves the whole unknown.
  template <class... Parts>
  static Meeting worst(const Parts&... parts) {
    Meeting out = Meeting::apart;
    const auto look = [&](const auto& part) {
      if (out == Meeting::meet) return;
      const Meeting found = part();
      if (found != Meeting::apart) out = found == Meeting::meet ? Meeting::meet : Meeting::unknown;
    };
    (look(parts), ...);
    return out;
  }

  ProofTree& tree_;
};

}  // namespace

Meeting curves_meet(const std::vector<Point>& a, const std::vector<Point>& b, Shared shared,
                    ProofTree& tree) {
  // The same curve twice would be subdivided for ever.
  if (a == b || std::equal(a.begin(), a.end(), b.rbegin(), b.rend())) return Meeting::meet;
  const RoundOutward rounding;
  Comparison comparison(tree);
  const Curve ca = enclosed(a), cb = enclosed(b);
  switch (shared) {
    case Shared::none:
      return comparison.none(ca, cb, 0);
    case Shared::start:
      return comparison.start(ca, cb, 0);
    case Shared::both_ends:
      return comparison.both_ends(ca, cb);
  }
  return Meeting::unknown;
}

Meeting meets_itself(const std::vector<Point>& curve, ProofTree& tree) {
  const RoundOutward rounding;
  return Comparison(tree).itself(enclosed(curve), 0);
}

Winding winding_around(const std::vector<std::vector<Point>>& loop, const Point& q, int max_depth) {
  const RoundOutward rounding;
  const Vec<Interval> centre{Interval(q.x()), Interval(q.y())};
  double angle = 0;
  bool known = true;
  // A curve in an open half plane at q turns around q by the angle of its ends, below pi.
  const auto add = [&](const auto& self, const Curve& curve, int depth) -> void {
    const Direction first = from_to(centre, curve.front()), last = from_to(centre, curve.back());
    const Direction uf = unit(first), ul = unit(last), d{uf[0] + ul[0], uf[1] + ul[1]};
    bool ahead = true;
    for (const auto& p : curve)
      ahead = ahead && certainly_positive(along(difference(p, centre), d));
    if (ahead) {
      angle += std::atan2(first[0] * last[1] - first[1] * last[0],
                          first[0] * last[0] + first[1] * last[1]);
    } else if (depth >= max_depth) {
      known = false;
    } else {
      for (const Curve& half : halved(curve)) self(self, half, depth + 1);
    }
  };
  for (const auto& poles : loop)
    if (known) add(add, enclosed(poles), 0);
  return {static_cast<int>(std::lround(angle / (2 * std::numbers::pi))), known};
}

int area_sign(const std::vector<std::vector<Point>>& loop) {
  const RoundOutward rounding;
  // Twice the area is the integral of p x p', summed over products of Bernstein polynomials:
  // B_i^n B_j^(n-1) integrates to C(n,i) C(n-1,j) / (C(2n-1,i+j) 2n).
  Interval sum(0);
  const auto binomial = [](int n, int k) { return multinomial(n, k, 0); };
  const Point origin = loop.at(0).at(0);
  for (const auto& poles : loop) {
    const int n = static_cast<int>(poles.size()) - 1;
    const Curve curve = enclosed(poles);
    const Vec<Interval> shift{Interval(origin.x()), Interval(origin.y())};
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j < n; ++j) {
        const Vec<Interval> p = difference(curve[i], shift), d = difference(curve[j + 1], curve[j]);
        const Interval weight = Interval(binomial(n, i)) * Interval(binomial(n - 1, j)) /
                                (Interval(binomial(2 * n - 1, i + j)) * Interval(2));
        sum += weight * (p[0] * d[1] - p[1] * d[0]);
      }
  }
  return certainly_positive(sum) ? 1 : certainly_negative(sum) ? -1 : 0;
}

}  // namespace c1mesh::verification
