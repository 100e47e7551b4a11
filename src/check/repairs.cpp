// SPDX-License-Identifier: GPL-3.0-or-later
// Repairs of single curves: those of no length, those straight but unevenly parametrised.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "check/stages.h"

namespace c1mesh::detail {
namespace {

// An end derivative below this, relative to the curve's size, counts as vanishing.
constexpr double kLeastSpeed = 1e-9;

// Straight, never turning back, but at rest at an end.
bool wants_respacing(const Arrangement& arrangement, const BezierCurve& curve) {
  const int n = curve.degree();
  if (n < 2) return false;
  const Point chord = arrangement.difference(curve.end(), curve.start());
  const double length = chord.norm();
  if (length == 0) return false;
  bool at_rest = false;
  for (int i = 0; i < n; ++i) {
    const Point step = arrangement.difference(curve.poles[i + 1], curve.poles[i]);
    if (std::abs(cross(chord, step)) > kResolution * length * length) return false;
    if (chord.dot(step) < -kResolution * length * length) return false;
    if ((i == 0 || i == n - 1) && step.norm() < kLeastSpeed * length) at_rest = true;
  }
  return at_rest;
}

// Orders curves by their poles, read in the direction whose reading is the smaller.
std::vector<double> key_of(const BezierCurve& curve) {
  std::vector<double> forward, backward;
  for (const Point& p : curve.poles) forward.insert(forward.end(), {p.x(), p.y()});
  for (auto p = curve.poles.rbegin(); p != curve.poles.rend(); ++p)
    backward.insert(backward.end(), {p->x(), p->y()});
  return std::min(forward, backward);
}

}  // namespace

void keep_only(Arrangement& arrangement, const std::vector<char>& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    if (kept != i) {
      arrangement.curves[kept] = std::move(arrangement.curves[i]);
      arrangement.ids[kept] = std::move(arrangement.ids[i]);
      arrangement.feature[kept] = arrangement.feature[i];
      arrangement.copies[kept] = std::move(arrangement.copies[i]);
    }
    ++kept;
  }
  arrangement.curves.resize(kept);
  arrangement.ids.resize(kept);
  arrangement.feature.resize(kept);
  arrangement.copies.resize(kept);
}

void add_copy(Arrangement& arrangement, int original, int copy) {
  auto& copies = arrangement.copies[original];
  copies.push_back(arrangement.ids[copy]);
  copies.insert(copies.end(), arrangement.copies[copy].begin(), arrangement.copies[copy].end());
  if (arrangement.feature[copy]) arrangement.feature[original] = kMarked;
}

void drop_zero_length(Arrangement& arrangement) {
  std::vector<char> keep(arrangement.curves.size(), 1);
  for (int i = 0; i < arrangement.size(); ++i) {
    const double size = size_of(arrangement.curves[i]);
    if (size >= kResolution * arrangement.extent) continue;
    keep[i] = 0;
    arrangement.mend(DefectKind::zero_length, {i}, {arrangement.curves[i].start()},
                     size == 0 ? "a curve of no length was left out"
                               : fmt::format("a curve of size {:.3g} was left out", size));
  }
  keep_only(arrangement, keep);
}

void respace_straight(Arrangement& arrangement) {
  for (int i = 0; i < arrangement.size(); ++i) {
    BezierCurve& curve = arrangement.curves[i];
    if (!wants_respacing(arrangement, curve)) continue;
    const int n = curve.degree();
    const Point start = curve.start(), end = curve.end();
    for (int k = 1; k < n; ++k) curve.poles[k] = ((n - k) * start + k * end) / n;
    arrangement.mend(DefectKind::handle, {i}, {start, end},
                     "a straight curve with a handle of no length was given an even speed; its "
                     "points are the same");
  }
}

void remove_duplicates(Arrangement& arrangement) {
  std::vector<std::vector<double>> keys;
  for (const BezierCurve& curve : arrangement.curves) keys.push_back(key_of(curve));
  std::vector<int> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
  std::vector<char> keep(keys.size(), 1);
  std::vector<int> original(keys.size(), -1);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const int before = order[k - 1], now = order[k];
    if (keys[before] != keys[now]) continue;
    original[now] = original[before] < 0 ? before : original[before];
    keep[now] = 0;
  }
  for (int i = 0; i < arrangement.size(); ++i)
    if (!keep[i]) add_copy(arrangement, original[i], i);
  keep_only(arrangement, keep);
}

}  // namespace c1mesh::detail
