// SPDX-License-Identifier: GPL-3.0-or-later
// Interval arithmetic with outward rounding. Expressions are certified only while a RoundOutward
// lives in an enclosing scope; comparisons here are of bounds, hence plain booleans.
#pragma once

#include <CGAL/Interval_nt.h>

namespace c1mesh::verification {

using Interval = CGAL::Interval_nt<false>;
using RoundOutward = CGAL::Protect_FPU_rounding<true>;

inline bool certainly_positive(const Interval& x) {
  return x.inf() > 0;
}
inline bool certainly_negative(const Interval& x) {
  return x.sup() < 0;
}

}  // namespace c1mesh::verification
