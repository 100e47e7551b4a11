// SPDX-License-Identifier: GPL-3.0-or-later
// From exact rationals back to doubles.
#pragma once

#include <gmpxx.h>

#include <cmath>

namespace c1mesh {

/// The nearest double. mpq_class::get_d truncates, which would bias every stored coordinate.
inline double round_to_double(const mpq_class& value) {
  const double low = value.get_d();
  const double next = std::nextafter(low, value > 0 ? HUGE_VAL : -HUGE_VAL);
  const mpq_class below = abs(value - mpq_class(low)), above = abs(value - mpq_class(next));
  return above < below ? next : low;
}

}  // namespace c1mesh
