// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles that bound exact values from one side, whatever the rounding mode.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/bernstein_forms.h"
#include "verify/interval.h"

namespace c1mesh::verification {

/// Not below |x|. GMP truncates.
inline double magnitude_above(const mpq_class& x) {
  if (sgn(x) == 0) return 0;
  const double truncated = std::abs(x.get_d());
  if (truncated < std::numeric_limits<double>::min()) return std::numeric_limits<double>::min();
  return std::nextafter(truncated, std::numeric_limits<double>::infinity());
}

/// Not above x; precondition: x >= 0.
inline double below(const mpq_class& x) {
  return std::min(x.get_d(), std::numeric_limits<double>::max());
}
inline double below(const Interval& x) {
  return x.inf();
}

/// Not below x; precondition: x >= 0.
inline double above(const mpq_class& x) {
  return magnitude_above(x);
}
inline double above(const Interval& x) {
  return x.sup();
}

/// Not below |v|. The library's hypot is off by one unit in the last place at most.
inline double length_above(const Vec<mpq_class>& v) {
  const double length = std::hypot(magnitude_above(v[0]), magnitude_above(v[1]));
  if (length == 0) return 0;
  const double most = std::numeric_limits<double>::infinity();
  return std::nextafter(std::nextafter(length, most), most);
}

/// Not below length / extent; precondition: both are not negative.
inline double relative_above(double length, double extent) {
  const double ratio = length / extent;
  if (length == 0) return 0;
  return std::nextafter(ratio, std::numeric_limits<double>::infinity());
}

}  // namespace c1mesh::verification
