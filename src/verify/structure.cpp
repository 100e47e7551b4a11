// SPDX-License-Identifier: GPL-3.0-or-later
// Structure (ids in range, sizes, finite numbers) and topology (one oriented surface, shared rows).
#include <array>
#include <cmath>
#include <map>

#include "verify/checks.h"

namespace c1mesh::verification {
namespace {

bool finite(const Point& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y());
}

void check_points(const std::vector<Point>& points, const char* what, Faults& faults) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!finite(points[i])) faults.add(fmt::format("{} {} is not finite", what, i));
}

bool in_range(int id, std::size_t size) {
  return id >= 0 && id < static_cast<int>(size);
}

void check_triangles(const Result& r, Faults& faults) {
  const std::size_t net_size = (r.degree + 1) * (r.degree + 2) / 2;
  if (r.triangles.empty()) faults.add("there are no triangles");
  if (r.triangle_control_points.size() != r.triangles.size())
    return faults.add("there are not as many nets as triangles");
  for (std::size_t t = 0; t < r.triangles.size(); ++t) {
    const auto& v = r.triangles[t];
    for (const int id : v)
      if (!in_range(id, r.domain_vertices.size()))
        faults.add(fmt::format("triangle {} refers to vertex {}", t, id));
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      faults.add(fmt::format("triangle {} names a vertex twice", t));
    const auto& net = r.triangle_control_points[t];
    if (net.size() != net_size)
      faults.add(fmt::format("the net of triangle {} has {} ids", t, net.size()));
    for (const int id : net)
      if (!in_range(id, r.control_points.size()))
        faults.add(fmt::format("triangle {} refers to control point {}", t, id));
  }
}

void check_curve_edges(const Result& r, const std::vector<CurveEdge>& edges, const char* what,
                       Faults& faults) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const CurveEdge& e = edges[i];
    if (!in_range(e.a, r.domain_vertices.size()) || !in_range(e.b, r.domain_vertices.size()) ||
        !in_range(e.curve, r.curves.size()))
      faults.add(fmt::format("{} {} refers to what is not there", what, i));
    if (!(e.t0 >= 0 && e.t0 <= 1 && e.t1 >= 0 && e.t1 <= 1 && e.t0 != e.t1))
      faults.add(fmt::format("{} {} has the interval {} to {}", what, i, e.t0, e.t1));
  }
}

/// Where a control point lives: at a vertex, on an edge, or inside a triangle. Sharing follows from
/// every id having one place and every place one id.
using Place = std::array<int, 4>;

Place place_of(const Result& r, int t, int i, int j) {
  const int n = r.degree;
  const std::array<int, 3> exponent{n - i - j, i, j};
  for (int k = 0; k < 3; ++k)
    if (exponent[k] == n) return {0, r.triangles[t][k], 0, 0};
  for (int k = 0; k < 3; ++k)
    if (exponent[k] == 0) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      const int va = r.triangles[t][a], vb = r.triangles[t][b];
      // Counted from the vertex of smaller id, so both triangles at the edge name it alike.
      if (va < vb) return {1, va, vb, exponent[b]};
      return {1, vb, va, exponent[a]};
    }
  return {2, t, i, j};
}

void check_sharing(const Subject& subject, Faults& faults) {
  const Result& r = subject.result;
  const int n = r.degree;
  const Place nowhere{-1, -1, -1, -1};
  std::vector<Place> place(r.control_points.size(), nowhere);
  std::map<Place, int> id_at;
  for (int t = 0; t < static_cast<int>(r.triangles.size()); ++t)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n - j; ++i) {
        const int id = r.triangle_control_points[t][net_index(n, i, j)];
        const Place here = place_of(r, t, i, j);
        if (place[id] == nowhere) place[id] = here;
        if (place[id] != here)
          faults.add(fmt::format("control point {} of triangle {} is used at two places", id, t));
        if (here[0] != 2 && id_at.emplace(here, id).first->second != id)
          faults.add(fmt::format("triangle {} does not share control point {} with its neighbour",
                                 t, id_at[here]));
      }
  for (std::size_t id = 0; id < place.size(); ++id)
    if (place[id] == nowhere) faults.add(fmt::format("control point {} is not used", id));
}

/// `boundary_edges` must be the mesh's boundary edges, each once, with the interior on the left.
void check_boundary_list(const Subject& subject, Faults& faults) {
  const Surface& surface = subject.surface;
  std::vector<int> listed(surface.edges.size(), 0);
  for (const CurveEdge& e : subject.result.boundary_edges) {
    const int id = surface.find_edge(e.a, e.b);
    if (id < 0 || surface.edges[id].interior()) {
      faults.add(fmt::format("boundary edge ({}, {}) is not on the mesh's boundary", e.a, e.b));
      continue;
    }
    if (++listed[id] > 1)
      faults.add(fmt::format("boundary edge ({}, {}) is listed twice", e.a, e.b));
    if (!surface.edges[id].side[e.a < e.b ? 0 : 1].present())
      faults.add(fmt::format("boundary edge ({}, {}) has its interior on the right", e.a, e.b));
  }
  for (std::size_t id = 0; id < listed.size(); ++id)
    if (!surface.edges[id].interior() && !listed[id])
      faults.add(fmt::format("edge ({}, {}) is on the boundary but not listed", surface.edges[id].a,
                             surface.edges[id].b));
  for (const CurveEdge& e : subject.result.feature_edges) {
    const int id = surface.find_edge(e.a, e.b);
    if (id < 0 || !surface.edges[id].interior())
      faults.add(fmt::format("feature edge ({}, {}) is not an interior edge", e.a, e.b));
  }
}

}  // namespace

VerifyItem check_structure(const Result& r) {
  Faults faults;
  if (r.degree < 1 || r.degree > 15) {
    faults.add(fmt::format("the degree {} is not between 1 and 15", r.degree));
    return faults.item("structure", "");
  }
  check_points(r.domain_vertices, "domain vertex", faults);
  check_points(r.control_points, "control point", faults);
  for (std::size_t c = 0; c < r.curves.size(); ++c) {
    if (r.curves[c].degree() < 1) faults.add(fmt::format("curve {} has fewer than two poles", c));
    check_points(r.curves[c].poles, "a pole of curve", faults);
  }
  check_triangles(r, faults);
  check_curve_edges(r, r.boundary_edges, "boundary edge", faults);
  check_curve_edges(r, r.feature_edges, "feature edge", faults);
  const std::size_t vertices = r.domain_vertices.size();
  for (const BoundaryVertex& v : r.boundary_vertices)
    if (!in_range(v.vertex, vertices))
      faults.add(fmt::format("boundary vertex {} is not there", v.vertex));
  for (const int v : r.exceptional_vertices)
    if (!in_range(v, vertices)) faults.add(fmt::format("exceptional vertex {} is not there", v));
  for (const auto& e : r.relaxed_edges)
    if (!in_range(e[0], vertices) || !in_range(e[1], vertices))
      faults.add(fmt::format("relaxed edge ({}, {}) is not there", e[0], e[1]));
  return faults.item("structure",
                     fmt::format("{} triangles of degree {}", r.triangles.size(), r.degree));
}

VerifyItem check_topology(const Subject& subject) {
  Faults faults;
  for (const std::string& fault : subject.surface.faults) faults.add(fault);
  check_sharing(subject, faults);
  check_boundary_list(subject, faults);
  return faults.item(
      "topology",
      fmt::format("pieces: {}, boundary loops: {}, edges: {}", subject.surface.components,
                  subject.surface.loops.size(), subject.surface.edges.size()));
}

std::vector<BoundaryRow> rows_of(const Subject& subject, const std::vector<int>& loop) {
  std::vector<BoundaryRow> rows;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    BoundaryRow row{loop[i], loop[(i + 1) % loop.size()], {}};
    const int id = subject.surface.find_edge(row.a, row.b);
    if (id < 0) continue;  // only where the topology is at fault
    const Side& side = subject.surface.edges[id].side[row.a < row.b ? 0 : 1];
    if (!side.present()) continue;
    for (int s = 0; s <= subject.degree(); ++s)
      row.poles.push_back(subject.control(side.triangle, side.corner, s, 0));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace c1mesh::verification
