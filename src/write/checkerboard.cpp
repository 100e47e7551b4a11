// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/checkerboard.h"

#include <algorithm>
#include <cmath>

namespace c1mesh {
namespace {

/// A corner of what is left of a triangle after clipping.
struct Corner {
  Point place;  // in the domain
  Barycentric at;
};
using Polygon = std::vector<Corner>;

/// The part of a convex polygon where sign * (coordinate - value) >= 0.
Polygon clipped(const Polygon& polygon, int axis, double value, double sign) {
  Polygon out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double da = sign * (a.place[axis] - value), db = sign * (b.place[axis] - value);
    if (da >= 0) out.push_back(a);
    if ((da >= 0) == (db >= 0)) continue;
    const double share = da / (da - db);
    Corner cut{(1 - share) * a.place + share * b.place, (1 - share) * a.at + share * b.at};
    cut.place[axis] = value;
    out.push_back(cut);
  }
  return out;
}

double twice_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    sum += cross(polygon[k].place - polygon[0].place, polygon[k + 1].place - polygon[0].place);
  return sum;
}

void add(PathData& path, const PiecewiseMap& map, int t, const Polygon& polygon, bool domain) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (domain) {
      if (k == 0) path.move(a.place);
      if (k + 1 < polygon.size()) path.line(b.place);
      continue;
    }
    const std::vector<Point> poles = map.segment(t, a.at, b.at);
    if (k == 0) path.move(poles.front());
    path.curve(poles);
  }
  path.close();
}

}  // namespace

void add_dark_squares(PathData& path, const PiecewiseMap& map, const Grid& grid, bool domain) {
  const Result& result = map.result();
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t) {
    Polygon triangle;
    std::array<int, 2> first, last;
    for (int k = 0; k < 3; ++k)
      triangle.push_back({result.domain_vertices[result.triangles[t][k]], Barycentric::Unit(k)});
    for (int axis = 0; axis < 2; ++axis) {
      const auto [low, high] =
          std::minmax({triangle[0].place[axis], triangle[1].place[axis], triangle[2].place[axis]});
      first[axis] = grid.square(axis, low);
      last[axis] = grid.square(axis, high);
    }
    const double tiny = 1e-9 * std::min(twice_area(triangle), grid.step * grid.step);
    for (int i = first[0]; i <= last[0]; ++i)
      for (int j = first[1]; j <= last[1]; ++j) {
        if ((i + j) % 2 != 0) continue;
        Polygon left = clipped(triangle, 0, grid.line(0, i), 1);
        left = clipped(left, 0, grid.line(0, i + 1), -1);
        left = clipped(left, 1, grid.line(1, j), 1);
        left = clipped(left, 1, grid.line(1, j + 1), -1);
        if (left.size() > 2 && twice_area(left) > tiny) add(path, map, t, left, domain);
      }
  }
}

}  // namespace c1mesh
