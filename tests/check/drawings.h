// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings and questions that the tests of check share.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "c1mesh/shape.h"

namespace c1mesh {

/// Curves "0", "1", … from lists of poles.
inline Drawing drawing_of(const std::vector<std::vector<Point>>& curves,
                          FillRule rule = FillRule::even_odd) {
  Drawing out;
  out.name = "test";
  out.fill_rule = rule;
  for (const auto& poles : curves)
    out.curves.push_back({std::to_string(out.curves.size()), {poles}});
  return out;
}

inline std::vector<std::vector<Point>> polygon(const std::vector<Point>& corners) {
  std::vector<std::vector<Point>> out;
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return out;
}

/// Counter-clockwise square with this lower left corner.
inline std::vector<std::vector<Point>> square(double x, double y, double side) {
  return polygon({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

inline std::vector<std::vector<Point>> backward(const std::vector<std::vector<Point>>& curves) {
  std::vector<std::vector<Point>> out(curves.rbegin(), curves.rend());
  for (auto& poles : out) std::reverse(poles.begin(), poles.end());
  return out;
}

inline std::vector<std::vector<Point>> operator+(std::vector<std::vector<Point>> a,
                                                 const std::vector<std::vector<Point>>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The defects that make a drawing unusable.
inline std::vector<Defect> faults(const Drawing& drawing) {
  std::vector<Defect> out;
  for (const Defect& defect : check(drawing).defects)
    if (!defect.repaired && defect.kind != DefectKind::note) out.push_back(defect);
  return out;
}

inline std::multiset<DefectKind> fault_kinds(const Drawing& drawing) {
  std::multiset<DefectKind> out;
  for (const Defect& defect : faults(drawing)) out.insert(defect.kind);
  return out;
}

using Kinds = std::multiset<DefectKind>;

/// All that Shape promises about itself: loops close bit for bit, outer ones turn
/// counter-clockwise, holes clockwise, no curve is used twice. Empty if it holds.
std::string broken_promise(const Shape& shape);

/// Twice the area under a polyline of `samples` points per curve.
double sampled_area(const Shape& shape, const Loop& loop, int samples = 64);

}  // namespace c1mesh
