// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of all degrees, lengths and numbers.
#include <cmath>
#include <numbers>
#include <utility>

#include "generate/families.h"

namespace c1mesh::generate_detail {

// An ellipse with joints at very uneven distances: after each of eight long arcs two short ones, of
// which one has the least angle.
Curves chords(double shortest, Random& random) {
  constexpr int kGroups = 8;
  std::vector<double> gaps;
  double used = 0;
  for (int k = 0; k < 2 * kGroups; ++k) {
    gaps.push_back(in_equal_ratios(shortest, 0.1, k / (2 * kGroups - 1.0)));
    used += gaps.back();
  }
  for (int k = 2 * kGroups - 1; k > 0; --k) std::swap(gaps[k], gaps[random.below(k + 1)]);
  const double rest = (2 * std::numbers::pi - used) / kGroups;
  std::vector<Stop> stops;
  double angle = 0;
  for (int k = 0; k < 3 * kGroups; ++k) {
    const Point u = unit_at(angle * 180 / std::numbers::pi);
    stops.push_back(through({u.x(), 0.7 * u.y()}, {-u.y(), 0.7 * u.x()}));
    angle += k % 3 == 0 ? rest : gaps[2 * (k / 3) + k % 3 - 1];
  }
  return closed_loop(stops);
}

// A random star-like polygon rounded by cubics whose inner poles coincide; every fourth vertex
// stays a corner, between straight cubics whose handles have no length.
Curves pinched(double vertices, Random& random) {
  const int count = static_cast<int>(vertices);
  std::vector<Point> points;
  for (int k = 0; k < count; ++k)
    points.push_back(random.between(0.8, 1.2) * unit_at(360.0 * k / count));
  Curves loop;
  const Curves rounded = rounded_polygon(points);
  for (int k = 0; k < count; ++k) {
    const auto& p = rounded[k].poles;
    if (k % 4 != 3) {
      loop.push_back({{p[0], p[1], p[1], p[2]}});
    } else {
      loop.push_back({{p[0], p[0], p[1], p[1]}});
      loop.push_back({{p[1], p[1], p[2], p[2]}});
    }
  }
  return loop;
}

// Twelve or more curves, bulging in or out, of the degrees 1, 2, …, highest in turn.
Curves degrees(double highest, Random& random) {
  const int most = static_cast<int>(highest), count = most * ((11 + most) / most);
  std::vector<Point> points;
  for (int k = 0; k < count; ++k)
    points.push_back(snapped(random.between(0.85, 1.15) * unit_at(360.0 * k / count)));
  Curves loop;
  for (int k = 0; k < count; ++k) {
    const Point &p = points[k], &q = points[(k + 1) % count];
    const int degree = 1 + k % most;
    const double bulge = random.between(-0.8, 0.8);
    BezierCurve curve;
    for (int i = 0; i <= degree; ++i) {
      const double t = static_cast<double>(i) / degree;
      curve.poles.push_back(snapped(p + t * (q - p) - bulge * t * (1 - t) * turned(q - p)));
    }
    loop.push_back(curve);
  }
  return loop;
}

Curves drop(double degrees, Random&) {
  return {{{{0, 0}, snapped(unit_at(-degrees / 2)), snapped(unit_at(degrees / 2)), {0, 0}}}};
}

Curves lens(double degrees, Random&) {
  const Point down = unit_at(-degrees / 2), up = unit_at(degrees / 2);
  return closed_loop({{{-1, 0}, -up, down}, {{1, 0}, up, -down}});
}

Curves oval(double aspect, Random&) {
  // A cubic with level ends' tangents bulges by 3/4 of its handles.
  const double handle = snapped({4 / (3 * aspect), 0}).x();
  return {{{{-1, 0}, {-1, -handle}, {1, -handle}, {1, 0}}},
          {{{1, 0}, {1, handle}, {-1, handle}, {-1, 0}}}};
}

// Closed at the origin, where the tangent is level; the inner poles lie on an arch above.
Curves single(double degree, Random&) {
  const int n = static_cast<int>(degree);
  BezierCurve curve{{{0, 0}, {1, 0}}};
  for (int i = 2; i <= n - 2; ++i)
    curve.poles.push_back(snapped(Point(0, 1.5) + unit_at(180.0 * (i - 1) / (n - 2))));
  curve.poles.push_back({-1, 0});
  curve.poles.push_back({0, 0});
  return {curve};
}

namespace {

// Octaves of periodic noise, each with twice as many bumps of a little less than half the height.
class Roughness {
 public:
  Roughness(int curves, Random& random) {
    for (int bumps = 4; 8 * bumps <= curves; bumps *= 2) {
      auto& octave = heights_.emplace_back();
      for (int k = 0; k < bumps; ++k) octave.push_back(random.between(-1, 1));
    }
  }

  // t in turns.
  double at(double t) const {
    double sum = 0, weight = 0.3;
    for (const auto& octave : heights_) {
      const double place = t * octave.size(), cell = std::floor(place), x = place - cell;
      const std::size_t k = static_cast<std::size_t>(cell) % octave.size();
      const double blend = x * x * (3 - 2 * x);
      sum += weight * (octave[k] + blend * (octave[(k + 1) % octave.size()] - octave[k]));
      weight *= 0.45;
    }
    return sum;
  }

 private:
  std::vector<std::vector<double>> heights_;
};

}  // namespace

Curves star(double curves, Random& random) {
  const int count = static_cast<int>(curves);
  const Roughness rough(count, random);
  std::vector<Point> points;
  for (int k = 0; k < count; ++k)
    points.push_back((1 + rough.at(static_cast<double>(k) / count)) * unit_at(360.0 * k / count));
  std::vector<Stop> stops;
  for (int k = 0; k < count; ++k)
    stops.push_back(through(points[k], points[(k + 1) % count] - points[(k + count - 1) % count]));
  return closed_loop(stops);
}

}  // namespace c1mesh::generate_detail
