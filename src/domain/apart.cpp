// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/apart.h"

#include <set>

#include "mesh/scaffold.h"

namespace c1mesh {
namespace {

std::vector<Point> as_points(const CurvedMesh& mesh, const PointMatrix& rows) {
  std::vector<Point> out;
  for (int v = 0; v < mesh.vertex_count(); ++v) out.emplace_back(rows.row(v).transpose());
  return out;
}

}  // namespace

std::vector<DomainElement> scaffold_elements(const CurvedMesh& mesh, const PointMatrix& points,
                                             Flats flats, double weight) {
  // Cosines of the angles above which a triangle counts as flat.
  constexpr double kFlat = -0.85, kRounding = -1 + 1e-9;
  const std::vector<Point> at = as_points(mesh, points);
  std::set<std::array<int, 2>> boundary;
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& e : loop) boundary.insert({e.b, e.a});
  const auto idle = [&](const std::array<int, 3>& t) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const Point p = at[a] - at[t[k]], q = at[b] - at[t[k]];
      const double cosine = p.dot(q) / (p.norm() * q.norm());
      if (!boundary.contains({a, b}) && cosine < (flats == Flats::kept ? kRounding : kFlat))
        return true;
    }
    return false;
  };
  std::vector<DomainElement> out;
  for (const auto& t : make_scaffold(mesh, at).triangles) {
    Eigen::Matrix2d S;
    S.col(0) = at[t[1]] - at[t[0]];
    S.col(1) = at[t[2]] - at[t[0]];
    DomainElement element;
    element.points = t;
    element.area = cross(S.col(0), S.col(1));
    if (!(element.area > 0) || idle(t)) continue;
    element.metric = metric_of(S);
    element.weight = weight;
    out.push_back(element);
  }
  return out;
}

bool boundary_meets_itself(const CurvedMesh& mesh, const PointMatrix& points) {
  return make_scaffold(mesh, as_points(mesh, points)).crossing;
}

}  // namespace c1mesh
