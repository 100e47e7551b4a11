// SPDX-License-Identifier: GPL-3.0-or-later
// Long and narrow shapes.
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "generate/families.h"

namespace c1mesh::generate_detail {

// Teeth of length 1, gaps as wide as they are.
Curves comb(double aspect, Random&) {
  constexpr int kTeeth = 6;
  const double width = 1 / aspect;
  std::vector<Point> points = {{0, -0.1}, {(2 * kTeeth - 1) * width, -0.1}};
  for (int k = kTeeth - 1; k >= 0; --k) {
    const double left = 2 * k * width, right = (2 * k + 1) * width;
    if (k < kTeeth - 1) points.push_back({right, 0});
    points.push_back({right, 1});
    points.push_back({left, 1});
    if (k > 0) points.push_back({left, 0});
  }
  return polygon(points);
}

// A unit square with slots half as wide as the corridor they leave.
Curves serpentine(double slots, Random&) {
  const int count = static_cast<int>(slots);
  const double corridor = 1 / (1.5 * count + 1);
  const auto slot = [&](int k) { return (1.5 * k + 1) * corridor; };
  std::vector<Point> points = {{0, 0}, {1, 0}};
  for (int k = 0; k < count; k += 2)
    for (const Point& p :
         {Point(1, slot(k)), Point(corridor, slot(k)), Point(corridor, slot(k) + corridor / 2),
          Point(1, slot(k) + corridor / 2)})
      points.push_back(p);
  points.push_back({1, 1});
  points.push_back({0, 1});
  for (int k = count - 1 - count % 2; k > 0; k -= 2)
    for (const Point& p :
         {Point(0, slot(k) + corridor / 2), Point(1 - corridor, slot(k) + corridor / 2),
          Point(1 - corridor, slot(k)), Point(0, slot(k))})
      points.push_back(p);
  return polygon(points);
}

namespace {

// Rooms at even places of a (2n-1) × (2n-1) board, doors between them: a random spanning tree, made
// by a depth-first walk.
class Maze {
 public:
  Maze(int cells, Random& random) : side_(2 * cells - 1), open_(side_ * side_, false) {
    std::vector<std::pair<int, int>> path = {{0, 0}};
    open(0, 0);
    while (!path.empty()) {
      const auto [x, y] = path.back();
      std::vector<std::pair<int, int>> ways;
      for (const auto& [dx, dy] :
           {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)})
        if (inside(x + 2 * dx, y + 2 * dy) && !is_open(x + 2 * dx, y + 2 * dy))
          ways.push_back({dx, dy});
      if (ways.empty()) {
        path.pop_back();
        continue;
      }
      const auto [dx, dy] = ways[random.below(static_cast<int>(ways.size()))];
      open(x + dx, y + dy);
      open(x + 2 * dx, y + 2 * dy);
      path.push_back({x + 2 * dx, y + 2 * dy});
    }
  }

  // A tree's corridors have one boundary. Follows it with the open side on the left.
  std::vector<Point> outline() const {
    std::vector<Point> points;
    int x = 0, y = 0, dx = 1, dy = 0;
    do {
      x += dx, y += dy;
      // The two cells ahead, seen from the grid point: the left one is open as before, unless the
      // boundary turns left around its end; if the right one is open too, it turns right.
      const bool left = cell_ahead(x, y, dx, dy, true), right = cell_ahead(x, y, dx, dy, false);
      if (left && !right) continue;
      points.push_back(Point(x, y) / side_);
      if (right)
        std::tie(dx, dy) = std::pair(dy, -dx);
      else
        std::tie(dx, dy) = std::pair(-dy, dx);
    } while (x != 0 || y != 0);
    return points;
  }

 private:
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < side_ && y < side_; }
  bool is_open(int x, int y) const { return inside(x, y) && open_[y * side_ + x]; }
  void open(int x, int y) { open_[y * side_ + x] = true; }

  bool cell_ahead(int x, int y, int dx, int dy, bool left) const {
    const int sx = left ? -dy : dy, sy = left ? dx : -dx;  // sideways
    return is_open(x + (dx + sx - 1) / 2, y + (dy + sy - 1) / 2);
  }

  int side_;
  std::vector<bool> open_;
};

}  // namespace

Curves maze(double cells, Random& random) {
  return polygon(Maze(static_cast<int>(cells), random).outline());
}

// An Archimedean band half as wide as its pitch, which is 1 / turns.
Curves spiral(double turns, Random&) {
  const double pitch = 1 / turns, rise = pitch / (2 * std::numbers::pi);
  const int steps = static_cast<int>(8 * turns);
  const auto angle = [&](int k) { return 360 * turns * k / steps; };
  const auto stop = [&](int k, double side, double way) {
    const Point u = unit_at(angle(k));
    const double radius = pitch * (0.75 + angle(k) / 360) + side * pitch / 4;
    return through(radius * u, way * (rise * u + radius * turned(u)));
  };
  const auto cap = [&](int k, double way) {
    const Point u = unit_at(angle(k));
    const double radius = pitch * (0.75 + angle(k) / 360);
    return through(radius * u + way * pitch / 4 * turned(u), -way * u);
  };
  std::vector<Stop> stops;
  for (int k = 0; k <= steps; ++k) stops.push_back(stop(k, 1, 1));
  stops.push_back(cap(steps, 1));
  for (int k = steps; k >= 0; --k) stops.push_back(stop(k, -1, -1));
  stops.push_back(cap(0, -1));
  return closed_loop(stops);
}

// Unit discs; the neck's sides are level, so its width is exact.
Curves neck(double width, Random&) {
  const double half = snapped({width / 2, 0}).x(), reach = std::sqrt(1 - half * half);
  std::vector<Stop> stops;
  for (const double side : {1.0, -1.0}) {
    const Point centre(1.25 * side, 0);
    const auto on_disc = [&](const Point& u) { return through(centre + u, turned(u)); };
    Stop first = on_disc({-side * reach, -side * half}),
         last = on_disc({-side * reach, side * half});
    first.in = Point(side, 0);
    last.out = Point(-side, 0);
    last.line = true;
    stops.push_back(first);
    for (const double k : {-90.0, 0.0, 90.0}) stops.push_back(on_disc(side * unit_at(k)));
    stops.push_back(last);
  }
  return closed_loop(stops);
}

Curves dumbbell(double width, Random&) {
  std::vector<Stop> stops;
  for (const double side : {1.0, -1.0}) {
    stops.push_back(through({0, -side * width / 2}, {side, 0}));
    stops.push_back(through({2 * side, -side}, {side, 0}));
    stops.push_back(through({3 * side, 0}, {0, side}));
    stops.push_back(through({2 * side, side}, {-side, 0}));
  }
  return closed_loop(stops);
}

// A quarter of a ring of radius 1, cut off straight.
Curves hairline(double aspect, Random&) {
  const double half = std::numbers::pi / 4 / aspect;
  constexpr int kSteps = 3;
  std::vector<Stop> stops;
  for (const double side : {1.0, -1.0})
    for (int k = 0; k <= kSteps; ++k) {
      const Point u = unit_at(side > 0 ? 30.0 * k : 90 - 30.0 * k);
      Stop stop = through((1 + side * half) * u, side * turned(u));
      if (k == 0) stop.in = side * u;
      if (k == kSteps) stop.out = -side * u, stop.line = true;
      stops.push_back(stop);
    }
  return closed_loop(stops);
}

}  // namespace c1mesh::generate_detail
