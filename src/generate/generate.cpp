// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "generate/loop.h"

namespace c1mesh {
namespace {

using generate_detail::Random;

int curves_of_set(char set) {
  switch (set) {
    case 'A':
      return 10;
    case 'B':
      return 20;
    case 'C':
      return 30;
    default:
      throw std::invalid_argument(fmt::format("no such set: '{}' (A, B or C)", set));
  }
}

// A stream of its own for every shape, so that a longer series starts with the shorter one.
Random stream(char set, std::uint64_t seed, int index) {
  Random mix(seed);
  Random second(mix.next() ^ (static_cast<std::uint64_t>(set) << 32) ^
                static_cast<std::uint64_t>(index));
  return Random(second.next());
}

// `chosen` of `count` joints, every subset equally likely (selection sampling).
std::vector<bool> random_subset(Random& random, int count, int chosen) {
  std::vector<bool> subset(count, false);
  for (int i = 0; i < count; ++i)
    if (random.below(count - i) < chosen) {
      subset[i] = true;
      --chosen;
    }
  return subset;
}

std::vector<BezierCurve> random_shape(Random& random, int curves) {
  // Drawn once and kept while loops are redrawn: rejection must not prefer few corners.
  const int corners = random.below(curves / 5 + 1);
  for (;;) {
    const std::vector<Point> tour = generate_detail::random_tour(random, curves);
    for (int attempt = 0; attempt < 4; ++attempt) {
      const std::vector<bool> subset = random_subset(random, curves, corners);
      std::vector<BezierCurve> loop = generate_detail::random_handles(random, tour, subset);
      if (generate_detail::is_sound(loop, 60)) return loop;
    }
  }
}

}  // namespace

std::vector<Drawing> generate(char set, int count, std::uint64_t seed) {
  const int curves = curves_of_set(set);
  if (count < 0) throw std::invalid_argument("the number of shapes is negative");
  std::vector<Drawing> drawings;
  for (int index = 1; index <= count; ++index) {
    Random random = stream(set, seed, index);
    Drawing drawing;
    drawing.name = fmt::format("{}-{:04}", set, index);
    for (BezierCurve& curve : random_shape(random, curves))
      drawing.curves.push_back({fmt::format("{}", drawing.curves.size()), std::move(curve)});
    drawings.push_back(std::move(drawing));
  }
  return drawings;
}

}  // namespace c1mesh
