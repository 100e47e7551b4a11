// SPDX-License-Identifier: GPL-3.0-or-later
// Small meshes with known geometry for tests of the optimisation.
#pragma once

#include <array>
#include <map>
#include <random>

#include "mesh/curved_mesh.h"

namespace c1mesh::testing_tools {

/// A mesh of degree n over given vertices and triangles with evenly spaced (straight) nets. `loops`
/// lists each boundary loop's vertices, interior on the left; every boundary edge is a curve.
inline CurvedMesh straight_mesh(int n, const std::vector<Point>& vertices,
                                const std::vector<std::array<int, 3>>& triangles,
                                const std::vector<std::vector<int>>& loops) {
  CurvedMesh mesh;
  mesh.degree = n;
  mesh.domain = vertices;
  mesh.triangles = triangles;
  mesh.control = vertices;
  std::map<std::array<int, 3>, int> edge_ids;  // (low, high, steps from low)
  for (const auto& t : triangles)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n - j; ++i) {
        const int w[3] = {n - i - j, i, j};
        int id = -1;
        for (int k = 0; k < 3; ++k)
          if (w[k] == n) id = t[k];
        const Point p = (w[0] * vertices[t[0]] + w[1] * vertices[t[1]] + w[2] * vertices[t[2]]) / n;
        for (int k = 0; k < 3 && id < 0; ++k)
          if (w[k] == 0) {
            int a = t[(k + 1) % 3], b = t[(k + 2) % 3], steps = w[(k + 2) % 3];
            if (a > b) {
              std::swap(a, b);
              steps = n - steps;
            }
            const auto [it, added] = edge_ids.try_emplace({a, b, steps}, int(mesh.control.size()));
            if (added) mesh.control.push_back(p);
            id = it->second;
          }
        if (id < 0) {
          id = static_cast<int>(mesh.control.size());
          mesh.control.push_back(p);
        }
        mesh.nets.push_back(id);
      }
  int curve = 0;
  for (const auto& loop : loops) {
    mesh.loops.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k)
      mesh.loops.back().push_back({loop[k], loop[(k + 1) % loop.size()], curve++, 0, 1});
  }
  mesh.warped.assign(triangles.size(), 1);
  return mesh;
}

/// The unit square [0,1]^2 cut into m x m cells, diagonals alternating, inner vertices jittered;
/// with `hole`, m odd, the middle cell is left out and its corners are not jittered.
inline CurvedMesh jittered_square(int n, int m, unsigned seed, double jitter = 0.2,
                                  bool hole = false) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-jitter / m, jitter / m);
  const int middle = m / 2;
  const auto in_hole = [&](int x, int y) {
    return hole && (x == middle || x == middle + 1) && (y == middle || y == middle + 1);
  };
  std::vector<Point> vertices;
  for (int y = 0; y <= m; ++y)
    for (int x = 0; x <= m; ++x) {
      Point p(double(x) / m, double(y) / m);
      if (x > 0 && x < m && y > 0 && y < m && !in_hole(x, y))
        p += Point(shift(random), shift(random));
      vertices.push_back(p);
    }
  const auto id = [m](int x, int y) { return y * (m + 1) + x; };
  std::vector<std::array<int, 3>> triangles;
  for (int y = 0; y < m; ++y)
    for (int x = 0; x < m; ++x) {
      if (hole && x == middle && y == middle) continue;
      const int a = id(x, y), b = id(x + 1, y), c = id(x + 1, y + 1), d = id(x, y + 1);
      if ((x + y) % 2 == 0) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  std::vector<std::vector<int>> loops(1);
  for (int k = 0; k < m; ++k) loops[0].push_back(id(k, 0));
  for (int k = 0; k < m; ++k) loops[0].push_back(id(m, k));
  for (int k = m; k > 0; --k) loops[0].push_back(id(k, m));
  for (int k = m; k > 0; --k) loops[0].push_back(id(0, k));
  if (hole)
    loops.push_back({id(middle, middle), id(middle, middle + 1), id(middle + 1, middle + 1),
                     id(middle + 1, middle)});
  return straight_mesh(n, vertices, triangles, loops);
}

inline CurvedMesh jittered_square_with_hole(int n, int m, unsigned seed) {
  return jittered_square(n, m, seed, 0.2, true);
}

}  // namespace c1mesh::testing_tools
