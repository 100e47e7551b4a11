// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/singular.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace c1mesh {
namespace {

Point at(const PointMatrix& domain, int v) {
  return domain.row(v).transpose();
}

// The neighbours of an interior vertex of four triangles, in cyclic order.
std::array<int, 4> ring_of(const CurvedMesh& mesh, const std::vector<int>& triangles, int v) {
  std::array<int, 4> ring{};
  int next = -1;
  for (int k = 0; k < 4; ++k)
    for (int t : triangles) {
      const auto& c = mesh.triangles[t];
      const int own = static_cast<int>(std::find(c.begin(), c.end(), v) - c.begin());
      const int from = c[(own + 1) % 3], to = c[(own + 2) % 3];
      if (k > 0 && from != next) continue;
      ring[k] = from;
      next = to;
      break;
    }
  return ring;
}

}  // namespace

int make_singular(const CurvedMesh& mesh, const MeshTopology& topology,
                  const std::vector<char>& movable, double tolerance, PointMatrix& domain) {
  int moved = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const std::vector<int>& triangles = topology.vertex_triangles[v];
    if (!movable[v] || triangles.size() != 4) continue;
    const std::array<int, 4> ring = ring_of(mesh, triangles, v);
    const Point p = at(domain, ring[0]), q = at(domain, ring[1]);
    const Point along = at(domain, ring[2]) - p, across = at(domain, ring[3]) - q;
    const double area = cross(along, across);
    if (!(std::abs(area) > 0)) continue;
    const Point crossing = p + cross(q - p, across) / area * along;
    double shortest = std::numeric_limits<double>::infinity();
    for (int w : ring) shortest = std::min(shortest, (at(domain, w) - at(domain, v)).norm());
    if (!((crossing - at(domain, v)).norm() <= tolerance * shortest)) continue;
    domain.row(v) = crossing.transpose();
    ++moved;
  }
  return moved;
}

}  // namespace c1mesh
