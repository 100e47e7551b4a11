// SPDX-License-Identifier: GPL-3.0-or-later
// First look: can these numbers be worked with?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/stages.h"

namespace c1mesh::detail {
namespace {

// Squares and fourth powers of lengths must neither overflow nor underflow, in any later stage.
constexpr double kSmallest = 1e-60, kLargest = 1e60;
// A shape must span this many of its coordinates' rounding steps.
constexpr double kLeastSteps = 1e5;
// De Casteljau takes the square of the degree; nobody draws beyond this.
constexpr int kHighestDegree = 30;

bool usable_curve(const BezierCurve& curve, int index, Arrangement& out) {
  if (curve.poles.size() < 2) {
    out.report(DefectKind::malformed, {index}, {}, "a curve has fewer than two control points",
               "give at least two control points");
    return false;
  }
  if (curve.degree() > kHighestDegree) {
    out.report(DefectKind::limit, {index}, {},
               fmt::format("a curve has degree {}; at most {} is supported", curve.degree(),
                           kHighestDegree),
               "approximate it by curves of lower degree");
    return false;
  }
  for (const Point& p : curve.poles)
    if (!std::isfinite(p.x()) || !std::isfinite(p.y())) {
      out.report(DefectKind::non_finite, {index}, {}, "a control point is not a finite number",
                 "repair the coordinate");
      return false;
    }
  return true;
}

double largest_coordinate(const std::vector<BezierCurve>& curves) {
  double largest = 0;
  for (const BezierCurve& curve : curves)
    for (const Point& p : curve.poles) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

bool usable_extent(Arrangement& out) {
  const double largest = largest_coordinate(out.curves);
  // Beyond this even the extent would overflow.
  if (largest > kLargest) {
    out.report(DefectKind::non_finite, {}, {},
               fmt::format("coordinates up to {:.3g} are too large to work with", largest),
               "scale the drawing");
    return false;
  }
  out.frame = frame_of(out.curves, out.extent);
  if (out.extent == 0) {
    out.report(DefectKind::zero_length, {}, {out.curves[0].start()}, "all control points coincide",
               "draw a shape that has an area");
    return false;
  }
  if (out.extent < kSmallest) {
    out.report(DefectKind::non_finite, {}, {out.curves[0].start()},
               fmt::format("the drawing's extent {:.3g} is too small to work with", out.extent),
               "scale the drawing");
    return false;
  }
  const double rounding = largest * 0x1p-52;
  if (out.extent < kLeastSteps * rounding) {
    out.report(DefectKind::non_finite, {}, {out.curves[0].start()},
               fmt::format("the drawing's extent {:.3g} is within the rounding of its coordinates "
                           "({:.3g})",
                           out.extent, largest),
               "move the drawing closer to the origin before it is rounded");
    return false;
  }
  return true;
}

}  // namespace

BezierCurve Arrangement::normalised(int curve) const {
  BezierCurve out = curves[curve];
  for (Point& p : out.poles) p = frame.normalise(p);
  return out;
}

Point Arrangement::difference(const Point& a, const Point& b) const {
  const Point d = a - b;
  return {std::ldexp(d.x(), -frame.exponent), std::ldexp(d.y(), -frame.exponent)};
}

Defect& Arrangement::report(DefectKind kind, const std::vector<int>& about,
                            std::vector<Point> where, std::string message, std::string remedy) {
  Defect defect;
  defect.kind = kind;
  for (const int curve : about) defect.curves.push_back(ids[curve]);
  defect.where = std::move(where);
  defect.message = std::move(message);
  defect.remedy = std::move(remedy);
  defects.push_back(std::move(defect));
  return defects.back();
}

Defect& Arrangement::mend(DefectKind kind, const std::vector<int>& about, std::vector<Point> where,
                          std::string message) {
  Defect& defect = report(kind, about, std::move(where), std::move(message), "");
  defect.repaired = kind != DefectKind::note;
  return defect;
}

Frame frame_of(const std::vector<BezierCurve>& curves, double& extent) {
  Point low = curves.front().start(), high = low;
  for (const BezierCurve& curve : curves)
    for (const Point& p : curve.poles) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  extent = (high - low).maxCoeff();
  Frame frame;
  frame.origin = low;
  // extent = m 2^e with m in [0.5, 1); a power of two becomes 1 rather than 0.5.
  const double m = std::frexp(extent, &frame.exponent);
  if (m == 0.5) --frame.exponent;
  return frame;
}

double size_of(const BezierCurve& curve) {
  Point low = curve.start(), high = low;
  for (const Point& p : curve.poles) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

bool screen(const Drawing& drawing, Arrangement& out) {
  out.fill_rule = drawing.fill_rule;
  for (const InputCurve& input : drawing.curves) {
    out.ids.push_back(input.id);
    out.curves.push_back(input.curve);
    out.feature.push_back(input.feature ? kMarked : kBounds);
    out.copies.emplace_back();
    // Negative zero equals zero but has other bits; loops are to close bit for bit.
    for (Point& p : out.curves.back().poles) p.array() += 0.0;
  }
  if (out.curves.empty()) {
    out.report(DefectKind::empty, {}, {}, "there are no curves", "give at least one closed loop");
    return false;
  }
  bool usable = true;
  for (int i = 0; i < out.size(); ++i) usable &= usable_curve(out.curves[i], i, out);
  return usable && usable_extent(out);
}

}  // namespace c1mesh::detail
