// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/winding.h"

#include <algorithm>
#include <limits>

#include "bernstein/curve.h"
#include "check/box_pairs.h"

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

WindingIndex::WindingIndex(const std::vector<Loop>& loops, const Pieces& pieces) : pieces_(pieces) {
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (const CurveUse& use : loops[l])
      for (int i = pieces.first[use.curve]; i < pieces.first[use.curve + 1]; ++i) {
        const Box box = box_of(pieces.all[i].poles, 0);
        entries_.push_back(
            {box.low.y(), box.high.y(), box.high.x(), 0, static_cast<int>(l), i, use.reversed});
      }
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.low < b.low; });
  arrange(0, static_cast<int>(entries_.size()));
}

double WindingIndex::arrange(int first, int last) {
  if (first >= last) return -std::numeric_limits<double>::infinity();
  const int middle = first + (last - first) / 2;
  Entry& root = entries_[middle];
  root.highest = std::max({root.high, arrange(first, middle), arrange(middle + 1, last)});
  return root.highest;
}

void WindingIndex::search(int first, int last, const Point& p,
                          const std::function<bool(int)>& wanted,
                          std::vector<std::pair<int, int>>& out) const {
  if (first >= last) return;
  const int middle = first + (last - first) / 2;
  const Entry& root = entries_[middle];
  if (root.highest < p.y()) return;
  search(first, middle, p, wanted, out);
  if (root.low > p.y()) return;
  if (root.high >= p.y() && root.right >= p.x() && wanted(root.loop))
    if (const int here = crossings(pieces_.all[root.piece].poles, p); here != 0)
      out.emplace_back(root.loop, root.reversed ? -here : here);
  search(middle + 1, last, p, wanted, out);
}

std::vector<std::pair<int, int>> WindingIndex::around(
    const Point& p, const std::function<bool(int)>& wanted) const {
  std::vector<std::pair<int, int>> found, out;
  search(0, static_cast<int>(entries_.size()), p, wanted, found);
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < found.size();) {
    std::pair<int, int> sum(found[i].first, 0);
    for (; i < found.size() && found[i].first == sum.first; ++i) sum.second += found[i].second;
    if (sum.second != 0) out.push_back(sum);
  }
  return out;
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
