// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers' targets do with what was read.
#pragma once

#include <string>
#include <vector>

#include "c1mesh/shape.h"
#include "fuzz/target.h"

namespace c1mesh::fuzz {

/// What every drawing promises that a reader returned. Those of few curves are also checked, and
/// the two ways of checking must agree.
inline void examine(const std::vector<Drawing>& drawings) {
  constexpr std::size_t kFewCurves = 24, kFewDrawings = 8;
  require(!drawings.empty(), "read without any drawing");
  for (std::size_t k = 0; k < drawings.size(); ++k) {
    const Drawing& drawing = drawings[k];
    for (const InputCurve& curve : drawing.curves)
      require(curve.curve.poles.size() >= 2, "a curve with fewer than two poles");
    if (drawing.curves.size() > kFewCurves || k >= kFewDrawings) continue;
    const bool usable = check(drawing).usable();
    const bool made = accepted([&] { make_shape(drawing); });
    require(usable == made, "check and make_shape disagree");
  }
}

}  // namespace c1mesh::fuzz
