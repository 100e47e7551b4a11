// SPDX-License-Identifier: GPL-3.0-or-later
// Functions whose bits are the same on every machine: sums, products and square roots only, which
// IEEE 754 fixes; a library's cosine or power is not.
#pragma once

#include "c1mesh/types.h"

namespace c1mesh::generate_detail {

/// (cos, sin) of an angle in degrees, to a few units in the last place; exact at multiples of 90.
Point unit_at(double degrees);

/// From `first` at t = 0 to `last` at t = 1 (both exactly) in equal ratios; both positive.
double in_equal_ratios(double first, double last, double t);

/// sqrt(x² + y²), without the library's hypot.
double length(const Point& v);

}  // namespace c1mesh::generate_detail
