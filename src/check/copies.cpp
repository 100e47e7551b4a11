// SPDX-License-Identifier: GPL-3.0-or-later
// Sub-shapes that share a curve may give it with other rounding errors, or raised to another
// degree.
#include <algorithm>
#include <cmath>
#include <map>

#include "bernstein/curve.h"
#include "check/stages.h"

namespace c1mesh::detail {
namespace {

Point& end_of(Arrangement& arrangement, const CurveEnd& end) {
  auto& poles = arrangement.curves[end.curve].poles;
  return end.at_end ? poles.back() : poles.front();
}

// Ends in the order of x, y: those that are one point lie within a resolution of x of each other.
std::vector<CurveEnd> sorted_ends(Arrangement& arrangement) {
  std::vector<CurveEnd> ends;
  for (int i = 0; i < arrangement.size(); ++i)
    for (const bool at_end : {false, true}) ends.push_back({i, at_end});
  std::stable_sort(ends.begin(), ends.end(), [&](const CurveEnd& a, const CurveEnd& b) {
    const Point &p = end_of(arrangement, a), &q = end_of(arrangement, b);
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  });
  return ends;
}

bool equal(const Arrangement& arrangement, const BezierCurve& a, const BezierCurve& b) {
  for (std::size_t i = 0; i < a.poles.size(); ++i)
    if (arrangement.difference(a.poles[i], b.poles[i]).norm() > kResolution) return false;
  return true;
}

bool same_curve(const Arrangement& arrangement, int i, int j) {
  const BezierCurve &a = arrangement.curves[i], &b = arrangement.curves[j];
  const int degree = std::max(a.degree(), b.degree());
  const BezierCurve p = elevate(a, degree), q = elevate(b, degree);
  return equal(arrangement, p, q) || equal(arrangement, p, reversed(q));
}

}  // namespace

void unite_ends(Arrangement& arrangement) {
  const std::vector<CurveEnd> ends = sorted_ends(arrangement);
  const double distance = kResolution * arrangement.extent;
  // Of the many that may lie above each other, those of the next bands of y are near enough.
  const auto band = [&](const Point& p) {
    return std::floor((p.y() - arrangement.frame.origin.y()) / (4 * distance));
  };
  std::map<double, std::vector<std::size_t>> bands;
  for (std::size_t i = 0; i < ends.size(); ++i)
    bands[band(end_of(arrangement, ends[i]))].push_back(i);
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Point p = end_of(arrangement, ends[i]);
    near.clear();
    for (const double step : {-1.0, 0.0, 1.0}) {
      const auto found = bands.find(band(p) + step);
      if (found == bands.end()) continue;
      auto j = std::upper_bound(found->second.begin(), found->second.end(), i);
      for (; j != found->second.end(); ++j) {
        if (end_of(arrangement, ends[*j]).x() - p.x() > distance) break;
        near.push_back(*j);
      }
    }
    std::sort(near.begin(), near.end());
    for (const std::size_t j : near) {
      Point& q = end_of(arrangement, ends[j]);
      // The ends of one curve are apart, else it would have been left out.
      if (ends[i].curve != ends[j].curve && (q - p).norm() <= distance) q = p;
    }
  }
}

void remove_near_copies(Arrangement& arrangement) {
  const Nodes nodes = find_nodes(arrangement);
  std::map<std::pair<int, int>, std::vector<int>> between;
  for (int i = 0; i < arrangement.size(); ++i)
    between[std::minmax(nodes.of_curve[i][0], nodes.of_curve[i][1])].push_back(i);
  std::vector<char> keep(arrangement.curves.size(), 1);
  for (const auto& [ends, curves] : between)
    for (std::size_t k = 0; k < curves.size(); ++k)
      for (std::size_t l = k + 1; l < curves.size() && keep[curves[k]]; ++l) {
        if (!keep[curves[l]] || !same_curve(arrangement, curves[k], curves[l])) continue;
        keep[curves[l]] = 0;
        add_copy(arrangement, curves[k], curves[l]);
      }
  keep_only(arrangement, keep);
}

}  // namespace c1mesh::detail
