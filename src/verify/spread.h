// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "c1mesh/result.h"

namespace c1mesh::verification {

/// Median, 99th percentile and maximum by nearest rank; zeros for an empty sample.
/// Precondition: no NaN.
Spread spread_of(std::vector<double> sample);

}  // namespace c1mesh::verification
