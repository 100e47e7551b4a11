// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/scaffold.h"

#include <queue>

#include "mesh/straight_cdt.h"

namespace c1mesh {
namespace {

using namespace meshing;

// False where constraints cross, pass through a vertex or meet on one point.
bool insert_loops(const CurvedMesh& mesh, const std::vector<Point>& points, Triangulation& cdt) {
  std::vector<Vertex> handle(mesh.vertex_count());
  // Neighbours on a loop are near each other: the search for the next one's face may begin there.
  // Few points are inserted without: where four lie on a circle the order of the faces would be
  // another.
  constexpr std::size_t kMany = 4096;
  std::size_t count = 0;
  for (const auto& loop : mesh.loops) count += loop.size();
  Face near;
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& edge : loop) {
      const Vertex v = cdt.insert(KernelPoint(points[edge.a].x(), points[edge.a].y()), near);
      if (v->info().number >= 0) return false;
      if (count > kMany) near = v->face();
      v->info().number = edge.a;
      handle[edge.a] = v;
    }
  try {
    for (const auto& loop : mesh.loops)
      for (const BoundaryEdge& edge : loop) cdt.insert_constraint(handle[edge.a], handle[edge.b]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  for (const auto& loop : mesh.loops)
    for (const BoundaryEdge& edge : loop)
      if (!cdt.is_edge(handle[edge.a], handle[edge.b])) return false;
  return true;
}

// Every second crossing of a constraint, from outside, enters the domain.
void mark_domain(Triangulation& cdt) {
  std::queue<Face> border;
  const Face outside = cdt.infinite_face();
  for (const Face face : cdt.all_face_handles()) face->info() = {};
  outside->info().number = 0;
  border.push(outside);
  while (!border.empty()) {
    const Face face = border.front();
    border.pop();
    for (int k = 0; k < 3; ++k) {
      const Face next = face->neighbor(k);
      if (next->info().number >= 0) continue;
      next->info().number = 0;
      next->info().in_domain = face->info().in_domain != face->is_constrained(k);
      border.push(next);
    }
  }
}

}  // namespace

Scaffold make_scaffold(const CurvedMesh& mesh, const std::vector<Point>& points) {
  Scaffold out;
  Triangulation cdt;
  if (!insert_loops(mesh, points, cdt)) {
    out.crossing = true;
    return out;
  }
  mark_domain(cdt);
  for (const Face face : cdt.finite_face_handles())
    if (!face->info().in_domain)
      out.triangles.push_back({face->vertex(0)->info().number, face->vertex(1)->info().number,
                               face->vertex(2)->info().number});
  return out;
}

}  // namespace c1mesh
