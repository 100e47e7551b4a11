// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> a few Bezier curves, more often than not nearly a valid shape.
#pragma once

#include <string>

#include "c1mesh/shape.h"

namespace c1mesh::fuzz {

/// At most 12 curves of degrees 1 to 4: star-shaped loops whose control points the bytes displace,
/// sometimes with a hole, a feature, a curve given twice, a gap, an extreme scale, offset or
/// aspect. Missing bytes count as 0, which displaces nothing; the same bytes give the same drawing.
Drawing soup(const std::string& bytes);

}  // namespace c1mesh::fuzz
