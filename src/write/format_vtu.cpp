// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML unstructured grids of Bezier cells: the control points are the cells' points.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "bernstein/jacobian.h"
#include "c1mesh/write.h"
#include "write/mesh_edges.h"

namespace c1mesh {
namespace {

constexpr int kBezierCurve = 75, kBezierTriangle = 76;  // vtkCellType.h

/// The (i, j) of VTK's points of a triangle of degree n, in VTK's order: the corners, the insides
/// of the edges 01, 12 and 20, each in running direction, then the inside as a triangle of degree
/// n-3.
std::vector<std::array<int, 2>> vtk_order(int n) {
  std::vector<std::array<int, 2>> out;
  for (int shift = 0; n >= 0; ++shift, n -= 3) {
    const auto add = [&](int i, int j) { out.push_back({i + shift, j + shift}); };
    add(0, 0);
    if (n == 0) break;
    add(n, 0);
    add(0, n);
    for (int s = 1; s < n; ++s) add(s, 0);
    for (int s = 1; s < n; ++s) add(n - s, s);
    for (int s = 1; s < n; ++s) add(0, n - s);
  }
  return out;
}

struct Cell {
  int type, edge_kind, triangle;
  std::vector<int> points;
};

std::vector<Cell> cells_of(const PiecewiseMap& map, const std::vector<DrawnEdge>& edges) {
  const Result& result = map.result();
  const auto order = vtk_order(result.degree);
  std::vector<Cell> cells;
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t) {
    Cell cell{kBezierTriangle, 0, t, {}};
    for (const auto& [i, j] : order) cell.points.push_back(map.control_id(t, 0, i, j));
    cells.push_back(std::move(cell));
  }
  for (const DrawnEdge& e : edges) {
    if (e.kind == EdgeKind::smooth) continue;
    const int n = result.degree;
    Cell cell{kBezierCurve, static_cast<int>(e.kind), e.triangle[0], {}};
    cell.points = {map.control_id(e.triangle[0], e.corner[0], 0, 0),
                   map.control_id(e.triangle[0], e.corner[0], n, 0)};
    for (int s = 1; s < n; ++s)
      cell.points.push_back(map.control_id(e.triangle[0], e.corner[0], s, 0));
    cells.push_back(std::move(cell));
  }
  return cells;
}

/// Where each control point sits in the domain: the straight triangle's net has p_ij at
/// ((n-i-j) a + i b + j c) / n. These are Bernstein coefficients of the coordinates u and v.
std::vector<Point> domain_net(const PiecewiseMap& map) {
  const Result& result = map.result();
  const int n = result.degree;
  std::vector<Point> out(result.control_points.size(), Point::Zero());
  std::vector<char> known(out.size(), 0);
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n - j; ++i) {
        const int id = map.control_id(t, 0, i, j);
        if (known[id]) continue;
        known[id] = 1;
        const auto& v = result.triangles[t];
        const auto corner = [&](int k) -> const Point& { return result.domain_vertices[v[k]]; };
        // Corners are copied: (n a) / n may differ from a in the last bit.
        if (i == n)
          out[id] = corner(1);
        else if (j == n)
          out[id] = corner(2);
        else if (i + j == 0)
          out[id] = corner(0);
        else
          out[id] =
              (double(n - i - j) * corner(0) + double(i) * corner(1) + double(j) * corner(2)) / n;
      }
  return out;
}

/// At vertices the largest deviation of the edges there, on an edge's own points that edge's,
/// zero inside triangles.
std::vector<double> point_deviations(const PiecewiseMap& map, const std::vector<DrawnEdge>& edges) {
  std::vector<double> out(map.result().control_points.size(), 0);
  for (const DrawnEdge& e : edges)
    for (int s = 0; s <= map.result().degree; ++s) {
      double& value = out[map.control_id(e.triangle[0], e.corner[0], s, 0)];
      value = std::max(value, e.c1_deviation);
    }
  return out;
}

std::vector<int> exceptional_flags(const PiecewiseMap& map) {
  const Result& result = map.result();
  std::vector<char> exceptional(result.domain_vertices.size(), 0);
  for (const int v : result.exceptional_vertices) exceptional[v] = 1;
  std::vector<int> out(result.control_points.size(), 0);
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k)
      if (exceptional[result.triangles[t][k]]) out[map.control_id(t, k, 0, 0)] = 1;
  return out;
}

struct TriangleValues {
  std::vector<double> distortion, min_det;
};

TriangleValues triangle_values(const Result& result) {
  const JacobianTables& tables = JacobianTables::of(result.degree);
  TriangleValues out;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    Net net;
    for (const int id : result.triangle_control_points[t]) net.push_back(result.control_points[id]);
    const auto corner = [&](int k) -> const Point& {
      return result.domain_vertices[result.triangles[t][k]];
    };
    const Point d1 = corner(1) - corner(0), d2 = corner(2) - corner(0);
    const double bound = distortion_bound(tables, net, d1, d2);
    out.distortion.push_back(std::isfinite(bound) ? bound : -1);
    const double area = cross(d1, d2);
    out.min_det.push_back(area != 0 ? det_coefficients(tables, net).minCoeff() / area : 0);
  }
  return out;
}

class VtuText {
 public:
  template <class Values>
  void array(const char* type, const char* name, int components, const Values& values) {
    out_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type,
        name, components);
    int column = 0;
    for (const auto& value : values) {
      fmt::format_to(std::back_inserter(out_), "{}", value);
      out_ += ++column % 12 == 0 ? '\n' : ' ';
    }
    out_ += "\n</DataArray>\n";
  }
  void add(const std::string& text) { out_ += text; }
  const std::string& text() const { return out_; }

 private:
  std::string out_;
};

/// x y z or u v, flat.
std::vector<double> flat(const std::vector<Point>& points, bool third) {
  std::vector<double> out;
  for (const Point& p : points) {
    out.push_back(p.x());
    out.push_back(p.y());
    if (third) out.push_back(0);
  }
  return out;
}

void add_cells(VtuText& text, const std::vector<Cell>& cells) {
  std::vector<int> connectivity, types;
  std::vector<std::size_t> offsets;
  for (const Cell& cell : cells) {
    connectivity.insert(connectivity.end(), cell.points.begin(), cell.points.end());
    offsets.push_back(connectivity.size());
    types.push_back(cell.type);
  }
  text.add("<Cells>\n");
  text.array("Int64", "connectivity", 1, connectivity);
  text.array("Int64", "offsets", 1, offsets);
  text.array("UInt8", "types", 1, types);
  text.add("</Cells>\n");
}

void add_cell_data(VtuText& text, const Result& result, const std::vector<Cell>& cells,
                   const std::vector<int>& region) {
  const TriangleValues values = triangle_values(result);
  std::vector<double> distortion, min_det;
  std::vector<int> regions, kinds;
  for (const Cell& cell : cells) {
    distortion.push_back(values.distortion[cell.triangle]);
    min_det.push_back(values.min_det[cell.triangle]);
    regions.push_back(region[cell.triangle]);
    kinds.push_back(cell.edge_kind);
  }
  text.add("<CellData Scalars=\"distortion\">\n");
  text.array("Float64", "distortion", 1, distortion);
  text.array("Float64", "min_det", 1, min_det);
  text.array("Int32", "region", 1, regions);
  text.array("Int32", "edge_kind", 1, kinds);
  text.add("</CellData>\n");
}

}  // namespace

std::string format_vtu(const Result& result, bool domain) {
  const PiecewiseMap map(result);
  const std::vector<DrawnEdge> edges = edges_of(map);
  const std::vector<Cell> cells = cells_of(map, edges);
  const std::vector<Point> uv = domain_net(map);
  VtuText text;
  text.add(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n");
  text.add(
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", uv.size(), cells.size()));
  text.add("<PointData>\n");
  text.array("Float64", "domain", 2, flat(uv, false));
  text.array("Float64", "c1_deviation", 1, point_deviations(map, edges));
  text.array("Int32", "exceptional", 1, exceptional_flags(map));
  text.add("</PointData>\n");
  add_cell_data(text, result, cells, regions_of(result, edges));
  text.add("<Points>\n");
  text.array("Float64", "Points", 3, flat(domain ? uv : result.control_points, true));
  text.add("</Points>\n");
  add_cells(text, cells);
  text.add("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return text.text();
}

}  // namespace c1mesh
