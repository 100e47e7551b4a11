// SPDX-License-Identifier: GPL-3.0-or-later
// The working state that the stages of `check` pass along.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "c1mesh/shape.h"

namespace c1mesh::detail {

/// Points closer than this, relative to the extent, are the same point: a few thousand times the
/// rounding error of coordinates in the normalised frame.
inline constexpr double kResolution = 1e-12;

/// Values of Arrangement::feature.
inline constexpr char kBounds = 0, kMarked = 1, kBoundsNothing = 2;

/// Curves under examination and what was found so far.
struct Arrangement {
  std::vector<BezierCurve> curves;  ///< input units, repaired as the stages go
  std::vector<std::string> ids;
  std::vector<char> feature;  ///< per curve: kBounds, or a feature as the input or check says
  std::vector<std::vector<std::string>> copies;  ///< per curve: ids of curves equal to it
  FillRule fill_rule = FillRule::even_odd;
  Frame frame;
  double extent = 0;  ///< larger side of the control points' bounding box, input units
  std::vector<Defect> defects;

  int size() const { return static_cast<int>(curves.size()); }
  /// The curve in the normalised frame.
  BezierCurve normalised(int curve) const;
  /// a - b of two input points as a normalised vector; exact where the subtraction is, which it is
  /// for points close together.
  Point difference(const Point& a, const Point& b) const;
  /// Appends a defect about these curves at these places (input units).
  Defect& report(DefectKind kind, const std::vector<int>& about, std::vector<Point> where,
                 std::string message, std::string remedy);
  /// Appends a note or, with a kind, a repair that was made.
  Defect& mend(DefectKind kind, const std::vector<int>& about, std::vector<Point> where,
               std::string message);
};

/// The frame of these curves, and the larger side of their bounding box.
Frame frame_of(const std::vector<BezierCurve>& curves, double& extent);

/// Moves an end of a curve to `target`. A straight curve stays straight; another takes its handle
/// along, so that its tangent at the joint stays.
void move_end(BezierCurve& curve, bool at_end, const Point& target);

/// The larger side of the bounding box of a curve's control points.
double size_of(const BezierCurve& curve);

/// The directed end of a curve.
struct CurveEnd {
  int curve = -1;
  bool at_end = false;  ///< false: t = 0
};

/// Where curve ends coincide, bit for bit.
struct Nodes {
  std::vector<std::array<int, 2>> of_curve;     ///< node of the start and of the end
  std::vector<std::vector<CurveEnd>> ends;      ///< per node, by curve index
  std::vector<std::vector<CurveEnd>> boundary;  ///< the same without features (tell_features)
};

}  // namespace c1mesh::detail
