// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML unstructured grids: of Bezier cells, whose points are the control points, or of Lagrange
// cells, whose points are the interpolation nodes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "bernstein/jacobian.h"
#include "c1mesh/write.h"
#include "write/mesh_edges.h"
#include "write/nodes.h"

namespace c1mesh {
namespace {

// vtkCellType.h
constexpr int kPolyLine = 4, kLagrangeTriangle = 69, kBezierCurve = 75, kBezierTriangle = 76;

struct Cell {
  int type, edge_kind, triangle;
  std::vector<int> points;
};

// An edge's interpolation nodes from end to end, for straight pieces: where VTK 9.1 and 9.2
// (ParaView 5.11) subdivide a surface, they crash at a Lagrange curve or a cubic line in it.
std::vector<int> nodes_along(const PiecewiseMap& map, int t, int k) {
  std::vector<int> out;
  for (int s = 0; s <= map.result().degree; ++s) out.push_back(map.control_id(t, k, s, 0));
  return out;
}

std::vector<Cell> cells_of(const PiecewiseMap& map, const std::vector<DrawnEdge>& edges,
                           VtuCells kind) {
  const bool bezier = kind == VtuCells::bezier;
  std::vector<Cell> cells;
  for (int t = 0; t < static_cast<int>(map.result().triangles.size()); ++t)
    cells.push_back({bezier ? kBezierTriangle : kLagrangeTriangle, 0, t, triangle_nodes(map, t)});
  for (const DrawnEdge& e : edges)
    if (e.kind != EdgeKind::smooth)
      cells.push_back({bezier ? kBezierCurve : kPolyLine, static_cast<int>(e.kind), e.triangle[0],
                       bezier ? edge_nodes(map, e.triangle[0], e.corner[0])
                              : nodes_along(map, e.triangle[0], e.corner[0])});
  return cells;
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

std::string format_vtu(const Result& result, bool domain, VtuCells kind) {
  const PiecewiseMap map(result);
  const std::vector<DrawnEdge> edges = edges_of(map);
  const std::vector<Cell> cells = cells_of(map, edges, kind);
  const std::vector<Point> uv = domain_net(map);
  const std::vector<Point> shape =
      kind == VtuCells::bezier ? result.control_points : interpolation_nodes(map);
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
  text.array("Float64", "Points", 3, flat(domain ? uv : shape, true));
  text.add("</Points>\n");
  add_cells(text, cells);
  text.add("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return text.text();
}

}  // namespace c1mesh
