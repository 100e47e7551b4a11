// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/winding.h"

#include <algorithm>
#include <limits>

#include "bernstein/curve.h"

namespace c1mesh::detail {
namespace {

// Below this (normalised) halving no longer makes pieces smaller: both halves hold the point again,
// and again, so that their number would double with every level.
constexpr double kPoint = 4 * std::numeric_limits<double>::epsilon();

// Signed crossings of the ray {p + (s, 0): s > 0} by the piece: +1 upward, -1 downward. On the
// piece itself there is no right answer.
int crossings(const Poles2& poles, const Point& p) {
  double low_y = poles[0].y(), high_y = low_y, low_x = poles[0].x(), high_x = low_x;
  for (const Point& q : poles) {
    low_y = std::min(low_y, q.y());
    high_y = std::max(high_y, q.y());
    low_x = std::min(low_x, q.x());
    high_x = std::max(high_x, q.x());
  }
  if (high_x < p.x() || low_y > p.y() || high_y < p.y()) return 0;
  const bool above0 = poles.front().y() > p.y(), above1 = poles.back().y() > p.y();
  const bool point = std::max(high_x - low_x, high_y - low_y) <= kPoint;
  // Wholly to the right: only on which side of the ray's line the ends are matters.
  if (low_x > p.x() || point) return int(above1) - int(above0);
  Poles2 first, second;
  halve(poles, first, second);
  return crossings(first, p) + crossings(second, p);
}

// Integral of cross(c, dc) over [0, 1] / 2 by Gauss's rule would need nodes for every degree; in
// Bernstein form cross(c, c') = sum_ij B_i^n B_j^(n-1) n cross(p_i, p_(j+1) - p_j), and the product
// B_i^n B_j^(n-1) integrates to C(n,i) C(n-1,j) / (C(2n-1,i+j) 2n).
double swept_area(const Poles2& poles) {
  const int n = static_cast<int>(poles.size()) - 1;
  const auto binomial = [](int m, int k) {
    double b = 1;
    for (int i = 1; i <= k; ++i) b = b * (m - k + i) / i;
    return b;
  };
  double sum = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j)
      sum += binomial(n, i) * binomial(n - 1, j) / binomial(2 * n - 1, i + j) *
             cross(poles[i], poles[j + 1] - poles[j]);
  return sum / 4;
}

}  // namespace

int winding_number(const Loop& loop, const Pieces& pieces, const Point& p) {
  int sum = 0;
  for (const CurveUse& use : loop)
    for (int i = pieces.first[use.curve]; i < pieces.first[use.curve + 1]; ++i) {
      const int here = crossings(pieces.all[i].poles, p);
      sum += use.reversed ? -here : here;
    }
  return sum;
}

double signed_area(const Loop& loop, const Arrangement& arrangement) {
  // About the loop's own first point: small loops far from the origin keep their digits.
  const Point about = arrangement.curves[loop.front().curve].start();
  double sum = 0;
  for (const CurveUse& use : loop) {
    Poles2 poles = arrangement.curves[use.curve].poles;
    for (Point& p : poles) p = arrangement.difference(p, about);
    const double area = swept_area(poles);
    sum += use.reversed ? -area : area;
  }
  return sum;
}

}  // namespace c1mesh::detail
