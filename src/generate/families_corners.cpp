// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of every angle, and joints that almost are smooth.
#include <cmath>
#include <utility>

#include "generate/families.h"

namespace c1mesh::generate_detail {

// Straight flanks, tips and roots on circles.
Curves gear(double teeth, Random&) {
  const double pitch = 360 / teeth;
  std::vector<Stop> stops;
  for (int k = 0; k < teeth; ++k) {
    const auto at = [&](double part, double radius, bool line) {
      const Point u = unit_at((k + part) * pitch);
      Stop stop{radius * u, turned(u), turned(u), line};
      // Curves meet lines here: a corner, its headings need not be on the grid of directions.
      (line ? stop.out : stop.in) = u;
      return stop;
    };
    stops.push_back(at(0.15, 1, false));
    stops.push_back(at(0.35, 1, true));
    stops.push_back(at(0.5, 0.8, false));
    stops.push_back(at(1, 0.8, true));
  }
  return closed_loop(stops);
}

namespace {

std::vector<Point> koch(int level) {
  std::vector<Point> points = {unit_at(90), unit_at(210), unit_at(330)};
  for (; level > 0; --level) {
    std::vector<Point> finer;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point p = points[i], third = (points[(i + 1) % points.size()] - p) / 3;
      finer.push_back(p);
      finer.push_back(p + third);
      finer.push_back(p + 1.5 * third -
                      std::sqrt(0.75) * turned(third));  // outside is on the right
      finer.push_back(p + 2 * third);
    }
    points = finer;
  }
  return points;
}

}  // namespace

Curves snowflake(double level, Random&) {
  return polygon(koch(static_cast<int>(level)));
}

Curves rounded_snowflake(double level, Random&) {
  return rounded_polygon(koch(static_cast<int>(level)));
}

// A corner at the origin, its two sides swinging out to a round body.
Curves spike(double degrees, Random&) {
  const double body = 0.35;
  return closed_loop({{{0, 0}, -unit_at(degrees / 2), unit_at(-degrees / 2)},
                      through({1, -body}, {1, 0}),
                      through({1 + body, 0}, {0, 1}),
                      through({1, body}, {-1, 0})});
}

// A disc without a sector: the interior angle at the centre is 360 - `degrees`.
Curves notch(double degrees, Random&) {
  std::vector<Stop> stops = {corner({0, 0})};
  constexpr int kArcs = 4;
  for (int k = 0; k <= kArcs; ++k) {
    const Point u = unit_at(degrees / 2 + (360 - degrees) * k / kArcs);
    stops.push_back(through(u, turned(u)));
  }
  stops[1].in = unit_at(degrees / 2);
  stops.back().out = -unit_at(-degrees / 2);
  stops.back().line = true;
  return closed_loop(stops);
}

// A circle whose joints all turn a little more or a little less than not at all: by angles in equal
// ratios from 1e-12 to 15 degrees, shuffled.
Curves mild(double joints, Random& random) {
  const int count = static_cast<int>(joints);
  std::vector<Stop> stops;
  std::vector<double> turns;
  for (int k = 0; k < count; ++k) {
    const Point u = unit_at(360.0 * k / count);
    stops.push_back(through(u, turned(u)));
    turns.push_back((random.coin() ? 1 : -1) * in_equal_ratios(1e-12, 15, k / (count - 1.0)));
  }
  for (int k = count - 1; k > 0; --k) std::swap(turns[k], turns[random.below(k + 1)]);
  Curves loop = closed_loop(stops);
  // Smooth so far. The outgoing handle moves sideways, not to the grid: that would be too coarse.
  for (int k = 0; k < count; ++k) {
    auto& poles = loop[k].poles;
    const Point u = unit_at(turns[k]);
    poles[1] += u.y() / u.x() * turned(poles[1] - poles[0]);
  }
  return loop;
}

}  // namespace c1mesh::generate_detail
