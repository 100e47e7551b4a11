// SPDX-License-Identifier: GPL-3.0-or-later
// Weights along a closed line, summed within a window around many places.
#pragma once

#include <cstddef>
#include <vector>

namespace c1mesh {

/// Per place the sum of weight_j (1 - d_j / window) over the points at[j] nearer than `window`, at
/// most a half of `length`, along a closed line of this length. All places are in [0, length), and
/// `at` increases. Where there are more than `few` pairs the sums are differences of running sums:
/// the cost is then near-linear, and the rounding relative to the sum of all.
std::vector<double> window_sums(const std::vector<double>& at, const std::vector<double>& weight,
                                const std::vector<double>& places, double window, double length,
                                std::size_t few = 4'000'000);

}  // namespace c1mesh
