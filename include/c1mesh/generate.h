// SPDX-License-Identifier: GPL-3.0-or-later
// Random piecewise smooth shapes and families of hard shapes for experiments, and Drawings as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "c1mesh/shape.h"

namespace c1mesh {

/// `count` random shapes of Khanteimouri & Campen, section 5.3: set 'A', 'B' or 'C' has one closed
/// outer loop (counter-clockwise) of 10, 20 or 30 cubics; the fraction of its joints that are not
/// smooth is uniform in [0 %, 20 %]. Every shape is simple and regular, keeps a distance between
/// its parts, and at every other joint the handles are collinear in exact arithmetic. Named
/// "A-0001" and so on. Coordinates are multiples of 2^-6 below 2048 in size.
/// Shape number i depends on (set, seed, i) alone and is the same on every machine.
/// Throws std::invalid_argument for another set or a negative count.
std::vector<Drawing> generate(char set, int count, std::uint64_t seed);

/// A family of hard shapes. Its parameter runs from pleasant to nasty.
struct Family {
  std::string name;                ///< as `generate_family` takes it
  std::string parameter;           ///< what it says about a shape
  double pleasant = 0, nasty = 0;  ///< where the parameter runs from and to
  int highest_degree = 1;          ///< of any curve of any shape
};

/// One shape of a family.
struct FamilyShape {
  double parameter = 0;  ///< its value, in the family's own unit
  Drawing drawing;       ///< not checked
};

/// Every family there is.
std::vector<Family> families();

/// `count` shapes of a family, named "comb-0001" and so on; the parameter is `pleasant` for the
/// first and `nasty` for the last (and for a single one), in equal steps or equal ratios between.
/// Every shape is valid input, though `check` may have repairs to say. The same on every machine;
/// `seed` matters where a family has chance in it. Throws std::invalid_argument for another name or
/// a negative count.
std::vector<FamilyShape> generate_family(const std::string& name, int count, std::uint64_t seed);

/// The drawing as JSON input text; doubles read back bit for bit, but -0 as 0.
std::string drawing_json(const Drawing& drawing);

/// The drawing as one SVG path, y downward. Throws std::invalid_argument for degrees above 3, which
/// SVG cannot say.
std::string drawing_svg(const Drawing& drawing);

}  // namespace c1mesh
