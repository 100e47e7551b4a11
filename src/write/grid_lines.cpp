// SPDX-License-Identifier: GPL-3.0-or-later
#include "write/grid_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace c1mesh {
namespace {

/// A piece with the coordinates where it starts and ends along the line.
struct Cut {
  LinePiece piece;
  double low, high;
};

/// Cuts triangle t by the line coordinate[axis] = value. A vertex on the line counts as above it,
/// so a line along an edge belongs to the triangle below it and to no other.
bool cut(const Result& result, int t, int axis, double value, Cut& out) {
  const auto& corner = result.triangles[t];
  const auto at = [&](int k) -> const Point& { return result.domain_vertices[corner[k % 3]]; };
  std::vector<std::pair<double, Barycentric>> crossings;
  for (int k = 0; k < 3; ++k) {
    const double a = at(k)[axis] - value, b = at(k + 1)[axis] - value;
    if ((a >= 0) == (b >= 0)) continue;
    const double share = a / (a - b);
    Barycentric where = Barycentric::Zero();
    where[k] = 1 - share;
    where[(k + 1) % 3] = share;
    crossings.emplace_back((1 - share) * at(k)[1 - axis] + share * at(k + 1)[1 - axis], where);
  }
  if (crossings.size() != 2) return false;
  if (crossings[1].first < crossings[0].first) std::swap(crossings[0], crossings[1]);
  out = {{t, crossings[0].second, crossings[1].second}, crossings[0].first, crossings[1].first};
  return out.high > out.low;
}

bool share_a_vertex(const Result& result, int s, int t) {
  for (const int a : result.triangles[s])
    for (const int b : result.triangles[t])
      if (a == b) return true;
  return false;
}

/// Joins pieces end to start where their triangles touch; where the domain overlaps itself, the
/// sheets stay apart.
std::vector<IsoLine> joined(const Result& result, int axis, double value, std::vector<Cut> cuts,
                            double tolerance) {
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const Cut& a, const Cut& b) { return a.low < b.low; });
  std::vector<IsoLine> lines;
  std::vector<std::pair<std::size_t, double>> open;  // line, where it ends so far
  for (const Cut& next : cuts) {
    std::erase_if(open, [&](const auto& o) { return o.second < next.low - tolerance; });
    const auto found = std::find_if(open.begin(), open.end(), [&](const auto& o) {
      return std::abs(o.second - next.low) <= tolerance &&
             share_a_vertex(result, lines[o.first].pieces.back().triangle, next.piece.triangle);
    });
    if (found == open.end()) {
      open.emplace_back(lines.size(), next.high);
      lines.push_back({axis, value, {next.piece}});
    } else {
      lines[found->first].pieces.push_back(next.piece);
      found->second = next.high;
    }
  }
  return lines;
}

}  // namespace

Grid grid_of(const Result& result, int count) {
  Grid grid;
  if (count < 1 || result.triangles.empty()) return grid;
  grid.low = grid.high = result.domain_vertices[result.triangles[0][0]];
  for (const auto& t : result.triangles)
    for (const int v : t) {
      grid.low = grid.low.cwiseMin(result.domain_vertices[v]);
      grid.high = grid.high.cwiseMax(result.domain_vertices[v]);
    }
  const Point size = grid.high - grid.low;
  const double step = size.maxCoeff() / count;
  if (!(step > 0)) return grid;
  grid.step = step;
  for (int axis = 0; axis < 2; ++axis) {
    grid.lines[axis] = static_cast<int>(std::floor(size[axis] / step + 0.5));
    grid.first[axis] = grid.low[axis] + 0.5 * (size[axis] - (grid.lines[axis] - 1) * step);
  }
  return grid;
}

std::vector<IsoLine> iso_lines(const Result& result, int count) {
  std::vector<IsoLine> out;
  const Grid grid = grid_of(result, count);
  const double step = grid.step, extent = (grid.high - grid.low).maxCoeff();
  if (!(step > 0)) return out;
  for (int axis = 0; axis < 2; ++axis) {
    const int lines = grid.lines[axis];
    const double first = grid.first[axis];
    std::vector<std::vector<Cut>> cuts(std::max(lines, 0));
    for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t) {
      double least = grid.high[axis], most = grid.low[axis];
      for (const int v : result.triangles[t]) {
        least = std::min(least, result.domain_vertices[v][axis]);
        most = std::max(most, result.domain_vertices[v][axis]);
      }
      const int begin = std::max(0, static_cast<int>(std::floor((least - first) / step)));
      const int end = std::min(lines - 1, static_cast<int>(std::ceil((most - first) / step)));
      Cut piece;
      for (int line = begin; line <= end; ++line)
        if (cut(result, t, axis, first + line * step, piece)) cuts[line].push_back(piece);
    }
    for (int line = 0; line < lines; ++line)
      for (IsoLine& iso :
           joined(result, axis, first + line * step, std::move(cuts[line]), 1e-9 * extent))
        out.push_back(std::move(iso));
  }
  return out;
}

}  // namespace c1mesh
