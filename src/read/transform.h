// SPDX-License-Identifier: GPL-3.0-or-later
// Affine maps of the plane and the `transform` attribute.
#pragma once

#include <string_view>

#include "c1mesh/types.h"

namespace c1mesh::detail {

/// p -> linear * p + shift.
struct Affine {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Point shift = Point::Zero();

  Point operator()(const Point& p) const { return linear * p + shift; }
  /// First `inner`, then this one.
  Affine operator*(const Affine& inner) const;
  /// The factor by which lengths grow at most: the larger singular value.
  double stretch() const;
};

Affine translation(double x, double y);
Affine scaling(double x, double y);
/// Counter-clockwise in a frame with x right and y up. Exact for multiples of 90 degrees.
Affine rotation(double degrees);

/// The value of a `transform` attribute: functions applied from right to left. Throws SyntaxError.
Affine parse_transform(std::string_view text);

}  // namespace c1mesh::detail
