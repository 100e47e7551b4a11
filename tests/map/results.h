// SPDX-License-Identifier: GPL-3.0-or-later
// Computed results to try maps on.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "c1mesh/map.h"
#include "c1mesh/result.h"

namespace c1mesh::testing_map {

/// An example's first drawing, parametrized at this degree.
Result result_of(const std::string& example, int degree = 3);

/// The same numbers everywhere, in [0, 1).
class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double number() { return static_cast<double>(engine_()) / 4294967296.0; }
  int below(int count) { return static_cast<int>(number() * count); }

  /// A place in a triangle; every third near an edge or on it.
  Barycentric place() {
    double s = number(), t = number();
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    if (below(3) == 0) s *= near_[below(4)];
    return {1 - s - t, s, t};
  }

 private:
  std::mt19937 engine_;
  const double near_[4] = {0, 1e-12, 1e-8, 1e-4};
};

}  // namespace c1mesh::testing_map
