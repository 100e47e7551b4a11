// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate/pen.h"

#include <algorithm>
#include <cmath>

namespace c1mesh::generate_detail {
namespace {

constexpr double kDirection = 16384;  // length of a smooth joint's vector in grid units

double nearest(double x) {
  return std::floor(x + 0.5);
}

// The handle at a stop, of about the length asked; `heading` points the way the loop runs.
Point handle(const Stop& stop, const Point& heading, double wanted) {
  const Point unit = heading / length(heading);
  if (stop.in != stop.out) return snapped(wanted * unit);
  const Point direction(nearest(unit.x() * kDirection), nearest(unit.y() * kDirection));
  const double times = std::max(1.0, nearest(wanted / (length(direction) * kGrid)));
  return times * kGrid * direction;
}

// A cubic's handles over a circular arc of angle phi are chord / (3 cos²(phi / 4)).
double arc_handle(const Point& from, const Point& to, double chord) {
  const double cosine = from.dot(to) / (length(from) * length(to));
  const double half = std::sqrt(std::max(0.0, (1 + cosine) / 2));
  return chord / (1.5 * (1 + half));
}

}  // namespace

Point snapped(const Point& p) {
  return {nearest(p.x() / kGrid) * kGrid, nearest(p.y() / kGrid) * kGrid};
}

Curves closed_loop(const std::vector<Stop>& stops) {
  Curves loop;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const Stop &from = stops[i], &to = stops[(i + 1) % stops.size()];
    const Point p = snapped(from.at), q = snapped(to.at);
    if (from.line) {
      loop.push_back({{p, q}});
      continue;
    }
    const double wanted = arc_handle(from.out, to.in, length(q - p));
    loop.push_back({{p, p + handle(from, from.out, wanted), q - handle(to, to.in, wanted), q}});
  }
  return loop;
}

Curves polygon(const std::vector<Point>& points) {
  std::vector<Stop> stops;
  for (const Point& p : points) stops.push_back(corner(p));
  return closed_loop(stops);
}

Curves rounded_polygon(const std::vector<Point>& points) {
  // Twice the grid: halves of sums stay on it.
  std::vector<Point> even;
  for (const Point& p : points) even.push_back(2 * snapped(p / 2));
  Curves loop;
  const std::size_t n = even.size();
  for (std::size_t i = 0; i < n; ++i)
    loop.push_back(
        {{(even[(i + n - 1) % n] + even[i]) / 2, even[i], (even[i] + even[(i + 1) % n]) / 2}});
  return loop;
}

Curves circle(const Point& centre, double radius, bool counter_clockwise) {
  std::vector<Stop> stops;
  for (int k = 0; k < 4; ++k) {
    const Point u = unit_at(counter_clockwise ? 90.0 * k : -90.0 * k);
    stops.push_back(
        through(centre + radius * u, counter_clockwise ? turned(u) : Point(-turned(u))));
  }
  return closed_loop(stops);
}

void append(Curves& to, const Curves& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace c1mesh::generate_detail
