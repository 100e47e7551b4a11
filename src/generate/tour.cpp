// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "generate/loop.h"

// Written out by coordinates: only + - * / and sqrt, whose rounding IEEE 754 fixes, so the same
// bits come out everywhere.

namespace c1mesh::generate_detail {
namespace {

constexpr double kRadius = 900;

double distance(const Point& a, const Point& b) {
  const double x = a.x() - b.x(), y = a.y() - b.y();
  return std::sqrt(x * x + y * y);
}

Point random_in_disc(Random& random) {
  for (;;) {
    const int side = static_cast<int>(2 * kRadius / kUnit);
    const double x = random.below(side + 1) * kUnit - kRadius;
    const double y = random.below(side + 1) * kUnit - kRadius;
    if (x * x + y * y <= kRadius * kRadius) return {x, y};
  }
}

// Dart throwing; the spacing yields a little at each miss, so that it ends.
std::vector<Point> spaced_points(Random& random, int count) {
  double spacing = 1.45 * kRadius / std::sqrt(static_cast<double>(count));
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count) {
    const Point p = random_in_disc(random);
    const bool clear = std::all_of(points.begin(), points.end(),
                                   [&](const Point& q) { return distance(p, q) >= spacing; });
    if (clear)
      points.push_back(p);
    else
      spacing *= 0.999;
  }
  return points;
}

// Reverses parts of the tour while that shortens it. A tour that crosses itself can be shortened,
// so the end state has no crossing. The margin keeps rounding from looping forever.
void shorten(std::vector<Point>& tour) {
  const int n = static_cast<int>(tour.size());
  bool improved = true;
  while (improved) {
    improved = false;
    for (int i = 0; i + 2 < n; ++i)
      for (int j = i + 2; j < n; ++j) {
        const Point &a = tour[i], &b = tour[i + 1], &c = tour[j], &d = tour[(j + 1) % n];
        if (distance(a, c) + distance(b, d) + 1e-6 >= distance(a, b) + distance(c, d)) continue;
        std::reverse(tour.begin() + i + 1, tour.begin() + j + 1);
        improved = true;
      }
  }
}

double signed_area(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

}  // namespace

std::vector<Point> random_tour(Random& random, int count) {
  std::vector<Point> tour = spaced_points(random, count);
  shorten(tour);
  if (signed_area(tour) < 0) std::reverse(tour.begin(), tour.end());
  return tour;
}

}  // namespace c1mesh::generate_detail
