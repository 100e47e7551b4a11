// SPDX-License-Identifier: GPL-3.0-or-later
// The makers of the hard shapes, a file per group. To add a family: a maker here, a line in the
// table of families.cpp, its promise in tests/generate/families_test.cpp.
#pragma once

#include "generate/pen.h"
#include "generate/random.h"

namespace c1mesh::generate_detail {

/// One shape for a value of the family's parameter, which runs from pleasant to nasty. Families
/// without chance ignore `random`.
using Maker = Curves (*)(double parameter, Random& random);

// Bands: families_bands.cpp.
Curves comb(double aspect, Random& random);
Curves serpentine(double slots, Random& random);
Curves maze(double cells, Random& random);
Curves spiral(double turns, Random& random);
Curves neck(double width, Random& random);
Curves dumbbell(double width, Random& random);
Curves hairline(double aspect, Random& random);

// Corners: families_corners.cpp.
Curves gear(double teeth, Random& random);
Curves snowflake(double level, Random& random);
Curves rounded_snowflake(double level, Random& random);
Curves spike(double degrees, Random& random);
Curves notch(double degrees, Random& random);
Curves mild(double joints, Random& random);

// Holes and islands: families_holes.cpp.
Curves plate(double holes, Random& random);
Curves grate(double holes, Random& random);
Curves rings(double loops, Random& random);

// Curves of every kind: families_curves.cpp.
Curves chords(double shortest, Random& random);
Curves pinched(double vertices, Random& random);
Curves degrees(double highest, Random& random);
Curves drop(double degrees, Random& random);
Curves lens(double degrees, Random& random);
Curves oval(double aspect, Random& random);
Curves single(double degree, Random& random);
Curves star(double curves, Random& random);

}  // namespace c1mesh::generate_detail
