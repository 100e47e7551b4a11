// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate/families.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "c1mesh/generate.h"

namespace c1mesh {
namespace {

using namespace generate_detail;

enum class Scale { even, whole, ratio, whole_ratio };

struct Row {
  Family family;
  Scale scale;  // how the parameter runs: in equal steps or in equal ratios, rounded or not
  Maker make;
};

// Families with curves inside a shape would stand here like any other: a maker returns all curves.
const std::vector<Row>& table() {
  static const std::vector<Row> rows = {
      {{"comb", "length of the six teeth over their width", 2, 200, 1}, Scale::ratio, comb},
      {{"serpentine", "slots, in turn from the right and from the left", 1, 20, 1},
       Scale::whole,
       serpentine},
      {{"maze", "cells along a side; the corridors are a random tree", 2, 9, 1},
       Scale::whole,
       maze},
      {{"spiral", "turns of a smooth band", 1, 10, 3}, Scale::even, spiral},
      {{"neck", "width of the straight neck between two discs", 1e-1, 1e-5, 3}, Scale::ratio, neck},
      {{"dumbbell", "least width of a smooth waist", 1e-1, 1e-5, 3}, Scale::ratio, dumbbell},
      {{"hairline", "length over width of a bent strip", 10, 1e4, 3}, Scale::ratio, hairline},
      {{"gear", "teeth, with two convex and two reflex corners each", 5, 60, 3},
       Scale::whole,
       gear},
      {{"snowflake", "level of Koch's polygon", 0, 4, 1}, Scale::whole, snowflake},
      {{"rounded-snowflake", "level of a smooth Koch curve", 0, 4, 2},
       Scale::whole,
       rounded_snowflake},
      {{"spike", "interior angle of the one corner, degrees", 60, 1, 3}, Scale::ratio, spike},
      {{"notch", "opening of a notch to a disc's centre, degrees", 60, 1, 3}, Scale::ratio, notch},
      {{"mild", "joints that turn by 1e-12 to 15 degrees", 6, 48, 3}, Scale::whole, mild},
      {{"plate", "round holes", 1, 100, 3}, Scale::whole_ratio, plate},
      {{"grate", "square holes", 1, 100, 1}, Scale::whole_ratio, grate},
      {{"rings", "nested loops, round and square in turn", 1, 12, 3}, Scale::whole, rings},
      {{"chords", "shortest central angle of two joints, radians", 1e-1, 1e-5, 3},
       Scale::ratio,
       chords},
      {{"pinched", "vertices; cubics with p1 = p2, lines without handles", 4, 40, 3},
       Scale::whole,
       pinched},
      {{"degrees", "highest degree; curves of every degree up to it", 1, 7, 7},
       Scale::whole,
       degrees},
      {{"drop", "interior angle of one closed cubic's corner, degrees", 150, 5, 3},
       Scale::ratio,
       drop},
      {{"lens", "interior angle of both corners of two cubics, degrees", 120, 2, 3},
       Scale::ratio,
       lens},
      {{"oval", "length over width of two smoothly joined cubics", 1, 100, 3}, Scale::ratio, oval},
      {{"single", "degree of one smooth closed curve", 4, 7, 7}, Scale::whole, single},
      {{"star", "curves of a rough smooth outline", 100, 2000, 3}, Scale::whole_ratio, star},
  };
  return rows;
}

const Row& row_of(const std::string& name) {
  for (const Row& row : table())
    if (row.family.name == name) return row;
  throw std::invalid_argument(fmt::format("no such family: '{}'", name));
}

double parameter_at(const Row& row, double t) {
  const auto& [family, scale, make] = row;
  const bool ratios = scale == Scale::ratio || scale == Scale::whole_ratio;
  const double value = ratios ? in_equal_ratios(family.pleasant, family.nasty, t)
                              : family.pleasant + t * (family.nasty - family.pleasant);
  const bool whole = scale == Scale::whole || scale == Scale::whole_ratio;
  return whole ? std::floor(value + 0.5) : value;
}

// A stream of its own for every shape of every family.
Random stream_of(const std::string& name, std::uint64_t seed, int index) {
  std::uint64_t key = static_cast<std::uint64_t>(index);
  for (const unsigned char c : name) key = (key ^ c) * 1099511628211u;  // FNV-1a
  Random mix(seed);
  return Random(Random(mix.next() ^ key).next());
}

}  // namespace

std::vector<Family> families() {
  std::vector<Family> all;
  for (const Row& row : table()) all.push_back(row.family);
  return all;
}

std::vector<FamilyShape> generate_family(const std::string& name, int count, std::uint64_t seed) {
  const Row& row = row_of(name);
  if (count < 0) throw std::invalid_argument("the number of shapes is negative");
  std::vector<FamilyShape> shapes;
  for (int index = 1; index <= count; ++index) {
    FamilyShape shape;
    shape.parameter = parameter_at(row, count > 1 ? (index - 1.0) / (count - 1) : 1);
    shape.drawing.name = fmt::format("{}-{:04}", name, index);
    Random random = stream_of(name, seed, index);
    for (BezierCurve& curve : row.make(shape.parameter, random))
      shape.drawing.curves.push_back(
          {fmt::format("{}", shape.drawing.curves.size()), std::move(curve)});
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace c1mesh
