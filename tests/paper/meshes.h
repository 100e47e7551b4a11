// SPDX-License-Identifier: GPL-3.0-or-later
// States of small meshes for tests of the paper's method.
#pragma once

#include <random>

#include "domain/start.h"
#include "optimise/map_objective.h"
#include "optimise/random_mesh.h"
#include "optimise/stages.h"
#include "paper/paper_method.h"

namespace c1mesh::testing_tools {

/// The jittered square of m x m cells; its triangles left of the middle are not warped, so that
/// there are hard edges.
inline CurvedMesh half_warped_square(int n, int m, unsigned seed) {
  CurvedMesh mesh = jittered_square(n, m, seed);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    double x = 0;
    for (int v : mesh.triangles[t]) x += mesh.domain[v].x() / 3;
    mesh.warped[t] = x > 0.55;
  }
  return mesh;
}

inline AskedEdges all_edges(const CurvedMesh& mesh) {
  return classify_edges(mesh, std::vector<char>(mesh.vertex_count(), 0));
}

inline Pair initial_pair(const CurvedMesh& mesh) {
  return {domain_points(mesh), mesh.control};
}

/// Domain and free control points moved by at most so much in each coordinate.
inline Pair shaken(const CurvedMesh& mesh, unsigned seed, double domain, double control) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Pair state = initial_pair(mesh);
  for (Eigen::Index v = 0; v < state.domain.rows(); ++v)
    state.domain.row(v) += domain * Eigen::RowVector2d(unit(random), unit(random));
  const std::vector<char> fixed = fixed_control(mesh, mesh.control.size());
  for (std::size_t k = 0; k < fixed.size(); ++k)
    if (!fixed[k]) state.control[k] += control * Point(unit(random), unit(random));
  return state;
}

/// The domain under p -> M p + shift.
inline PointMatrix mapped(const PointMatrix& domain, const Eigen::Matrix2d& M, const Point& shift) {
  PointMatrix out = domain * M.transpose();
  out.rowwise() += shift.transpose();
  return out;
}

}  // namespace c1mesh::testing_tools
