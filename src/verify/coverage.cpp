// SPDX-License-Identifier: GPL-3.0-or-later
// Coverage: the edges on a curve tile it exactly once. Input curves: they are the shape's, bit by
// bit.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <set>

#include "verify/checks.h"

namespace c1mesh::verification {
namespace {

/// An edge on a curve in the direction of growing parameter.
struct Span {
  double low, high;
  int from, to;
  bool backward;
};

std::map<int, std::vector<Span>> spans_by_curve(const std::vector<CurveEdge>& edges) {
  std::map<int, std::vector<Span>> spans;
  for (const CurveEdge& e : edges) {
    const bool backward = e.t0 > e.t1;
    if (backward)
      spans[e.curve].push_back({e.t1, e.t0, e.b, e.a, true});
    else
      spans[e.curve].push_back({e.t0, e.t1, e.a, e.b, false});
  }
  for (auto& [curve, list] : spans)
    std::sort(list.begin(), list.end(), [](const Span& a, const Span& b) { return a.low < b.low; });
  return spans;
}

/// The spans of one curve must run from 0 to 1 without gap or overlap, vertex to vertex.
void check_tiling(int curve, const std::vector<Span>& spans, bool one_direction, Faults& faults) {
  if (spans.front().low != 0 || spans.back().high != 1)
    faults.add(fmt::format("curve {} is covered from {} to {} only", curve, spans.front().low,
                           spans.back().high));
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
    const Span &now = spans[i], &next = spans[i + 1];
    if (now.high != next.low)
      faults.add(fmt::format("curve {} has a gap or an overlap between {} and {}", curve, now.high,
                             next.low));
    else if (now.to != next.from)
      faults.add(fmt::format("the edges of curve {} do not share a vertex at {}", curve, now.high));
    if (one_direction && now.backward != next.backward)
      faults.add(fmt::format("curve {} is run in both directions", curve));
  }
}

using Bits = std::vector<std::uint64_t>;

Bits bits_of(const BezierCurve& curve) {
  Bits bits;
  for (const Point& p : curve.poles)
    for (const double x : {p.x(), p.y()}) bits.push_back(std::bit_cast<std::uint64_t>(x));
  return bits;
}

}  // namespace

VerifyItem check_coverage(const Subject& subject) {
  Faults faults;
  const auto boundary = spans_by_curve(subject.result.boundary_edges);
  const auto features = spans_by_curve(subject.result.feature_edges);
  for (const auto& [curve, spans] : boundary) check_tiling(curve, spans, true, faults);
  for (const auto& [curve, spans] : features) {
    check_tiling(curve, spans, false, faults);
    if (boundary.count(curve))
      faults.add(fmt::format("curve {} is both on the boundary and inside", curve));
  }
  const std::size_t unused = subject.result.curves.size() - boundary.size() - features.size();
  std::string good =
      fmt::format("{} curves covered exactly once", boundary.size() + features.size());
  if (unused > 0) good += fmt::format("; {} listed curves bound nothing", unused);
  return faults.item("coverage", good);
}

VerifyItem check_input_curves(const Subject& subject, const Shape& shape) {
  Faults faults;
  std::multiset<Bits> wanted;
  for (const BezierCurve& curve : shape.curves) wanted.insert(bits_of(curve));
  for (std::size_t c = 0; c < subject.result.curves.size(); ++c) {
    const auto found = wanted.find(bits_of(subject.result.curves[c]));
    if (found == wanted.end())
      faults.add(fmt::format("curve {} is not one of the input's", c));
    else
      wanted.erase(found);
  }
  if (!wanted.empty()) faults.add(fmt::format("{} curves of the input are missing", wanted.size()));

  std::set<Bits> used;
  for (const CurveEdge& e : subject.result.boundary_edges)
    used.insert(bits_of(subject.result.curves[e.curve]));
  std::set<Bits> features;
  for (const CurveEdge& e : subject.result.feature_edges)
    features.insert(bits_of(subject.result.curves[e.curve]));
  const auto want = [&](const std::vector<CurveUse>& uses, const std::set<Bits>& where,
                        const char* message) {
    for (const CurveUse& use : uses)
      if (!where.count(bits_of(shape.curves[use.curve])))
        faults.add(fmt::format(fmt::runtime(message), use.curve));
  };
  const char* no_boundary = "curve {} of the input bounds a region but not the result";
  for (const Region& region : shape.regions) {
    want(region.outer, used, no_boundary);
    for (const Loop& hole : region.holes) want(hole, used, no_boundary);
    for (const FeaturePath& path : region.features)
      want(path.curves, features, "curve {} of the input is a feature but not of the result");
  }
  return faults.item("input curves", fmt::format("{} curves as in the input", shape.curves.size()));
}

}  // namespace c1mesh::verification
