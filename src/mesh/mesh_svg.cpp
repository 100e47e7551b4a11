// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_svg.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "bernstein/curve.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

constexpr double kSize = 800, kMargin = 20;

// Maps a box to a square of the page, y upward.
struct Page {
  Eigen::AlignedBox2d box;
  double left = 0;

  std::string at(const Point& p) const {
    const double scale = (kSize - 2 * kMargin) / std::max(box.sizes().maxCoeff(), 1e-300);
    return fmt::format("{:.3f} {:.3f}", left + kMargin + scale * (p.x() - box.min().x()),
                       kSize - kMargin - scale * (p.y() - box.min().y()));
  }
  std::string op(char letter, const Point& p) const { return letter + at(p); }
};

std::string edge_path(const Page& page, const std::vector<Point>& poles) {
  const BezierCurve curve{poles};
  std::string path;
  if (curve.degree() == 3)
    return fmt::format("C{} {} {}", page.at(poles[1]), page.at(poles[2]), page.at(poles[3]));
  for (int k = 1; k <= 16; ++k) path += page.op('L', evaluate(curve, k / 16.0));
  return path;
}

std::string draw_curved(const CurvedMesh& mesh, const MeshTopology& topology, const Page& page) {
  const std::vector<char> feature = feature_flags(mesh, topology);
  std::string fill, inner, curves;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    std::string path = page.op('M', mesh.control[mesh.triangles[t][0]]);
    for (int k : {2, 0, 1}) {
      std::vector<Point> poles;
      for (int id : edge_controls(mesh, t, k)) poles.push_back(mesh.control[id]);
      const std::string side = edge_path(page, poles);
      path += side;
      const MeshEdge& e = topology.edges[topology.triangle_edges[t][k]];
      if (e.triangle[0] == t)
        (e.triangle[1] < 0 || feature[topology.triangle_edges[t][k]] ? curves : inner) +=
            page.op('M', poles.front()) + side;
    }
    if (mesh.warped[t]) fill += path + "Z";
  }
  return fmt::format(
      "<path fill='#fc9' stroke='none' d='{}'/><path fill='none' stroke='#777' "
      "stroke-width='0.5' d='{}'/><path fill='none' stroke='#c00' d='{}'/>\n",
      fill, inner, curves);
}

std::string draw_straight(const CurvedMesh& mesh, const MeshTopology& topology, const Page& page) {
  const std::vector<char> feature = feature_flags(mesh, topology);
  std::string fill, inner, curves;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    if (!mesh.warped[t]) continue;
    const auto& v = mesh.triangles[t];
    fill += page.op('M', mesh.domain[v[0]]) + page.op('L', mesh.domain[v[1]]) + "L" +
            page.at(mesh.domain[v[2]]) + "Z";
  }
  for (std::size_t k = 0; k < topology.edges.size(); ++k) {
    const MeshEdge& e = topology.edges[k];
    (e.triangle[1] < 0 || feature[k] ? curves : inner) +=
        page.op('M', mesh.domain[e.a]) + page.op('L', mesh.domain[e.b]);
  }
  return fmt::format(
      "<path fill='#fc9' stroke='none' d='{}'/><path fill='none' stroke='#777' "
      "stroke-width='0.5' d='{}'/><path fill='none' stroke='#c00' d='{}'/>\n",
      fill, inner, curves);
}

std::string draw_dots(const CurvedMesh& mesh, const Page& page, const std::vector<Point>& points) {
  const std::vector<char> on_curve = on_curves(mesh);
  std::string dots;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (on_curve[v]) dots += page.op('M', points[v]) + "h0";
  return fmt::format("<path stroke='#000' stroke-width='3' stroke-linecap='round' d='{}'/>\n",
                     dots);
}

}  // namespace

std::string mesh_svg(const CurvedMesh& mesh) {
  const MeshTopology topology(mesh);
  Page shape, domain;
  domain.left = kSize;
  for (const Point& p : mesh.control) shape.box.extend(p);
  for (const Point& p : mesh.domain) domain.box.extend(p);
  return fmt::format(
             "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {} {}'>\n"
             "<rect width='100%' height='100%' fill='#fff'/>\n",
             2 * kSize, kSize) +
         draw_curved(mesh, topology, shape) + draw_dots(mesh, shape, mesh.control) +
         draw_straight(mesh, topology, domain) + draw_dots(mesh, domain, mesh.domain) + "</svg>\n";
}

}  // namespace c1mesh
