// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/assemble.h"

#include <algorithm>

#include "bernstein/curve.h"
#include "c1mesh/version.h"

namespace c1mesh {

namespace {

// Where one region's ids start in the result.
struct Offset {
  int vertex, control;
};

// Edges on curves get the exact restrictions as control points.
void add_curve_edges(const Shape& shape, const std::vector<BoundaryEdge>& edges,
                     const std::vector<std::vector<int>>& control, const Offset& at,
                     std::vector<CurveEdge>& out, Result& result) {
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const BoundaryEdge& e = edges[k];
    out.push_back({e.a + at.vertex, e.b + at.vertex, e.curve, e.t0, e.t1});
    const BezierCurve exact = restrict_exactly(shape.curves[e.curve], e.t0, e.t1, result.degree);
    for (int i = 0; i <= result.degree; ++i)
      result.control_points[control[k][i] + at.control] = exact.poles[i];
  }
}

void add_boundary(const Shape& shape, const RegionSolution& region, const Offset& at,
                  Result& result) {
  const auto control = boundary_control(region.mesh);
  const std::size_t loops = region.mesh.loops.size();
  for (std::size_t l = 0; l < loops; ++l) {
    add_curve_edges(shape, region.mesh.loops[l], control[l], at, result.boundary_edges, result);
    for (const Joint& joint : region.joints[l])
      result.boundary_vertices.push_back(
          {joint.vertex + at.vertex, joint.kind == JointKind::corner});
  }
  for (std::size_t f = 0; f < region.mesh.features.size(); ++f)
    add_curve_edges(shape, region.mesh.features[f].edges, control[loops + f], at,
                    result.feature_edges, result);
}

void add_region(const Shape& shape, const RegionSolution& region, Result& result) {
  const Offset at{static_cast<int>(result.domain_vertices.size()),
                  static_cast<int>(result.control_points.size())};
  const CurvedMesh& mesh = region.mesh;
  result.domain_vertices.insert(result.domain_vertices.end(), mesh.domain.begin(),
                                mesh.domain.end());
  for (const Point& p : mesh.control) result.control_points.push_back(shape.frame.restore(p));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    std::array<int, 3> corners = mesh.triangles[t];
    for (int& v : corners) v += at.vertex;
    result.triangles.push_back(corners);
    std::vector<int> net(mesh.nets.begin() + t * mesh.net_size(),
                         mesh.nets.begin() + (t + 1) * mesh.net_size());
    for (int& id : net) id += at.control;
    result.triangle_control_points.push_back(std::move(net));
  }
  add_boundary(shape, region, at, result);
  for (int v : region.exceptional) result.exceptional_vertices.push_back(v + at.vertex);
  for (const auto& e : region.relaxed)
    result.relaxed_edges.push_back({e[0] + at.vertex, e[1] + at.vertex});
}

// Moves each region's domain so that regions lie side by side instead of on top of each other.
void place_side_by_side(std::vector<RegionSolution>& regions) {
  double right = 0;
  for (RegionSolution& region : regions) {
    double low = 1e300, high = -1e300, bottom = 1e300;
    for (const Point& p : region.mesh.domain) {
      low = std::min(low, p.x());
      high = std::max(high, p.x());
      bottom = std::min(bottom, p.y());
    }
    if (regions.size() > 1)
      for (Point& p : region.mesh.domain) p += Point(right - low, -bottom);
    right += 1.05 * (high - low);
  }
}

void add_paper_parameters(const Options& options, Parameters& out) {
  const PaperOptions& p = options.paper;
  out.emplace_back("repeat", static_cast<long long>(options.repeat));
  out.emplace_back("extent", p.extent);
  out.emplace_back("lambda_reg_one", p.regularisation[0]);
  out.emplace_back("lambda_reg_two", p.regularisation[1]);
  out.emplace_back("lambda_hard_one", p.hard_penalty[0]);
  out.emplace_back("lambda_hard_two", p.hard_penalty[1]);
  out.emplace_back("rho", p.barrier);
  out.emplace_back("alpha_lift", p.alpha_lift);
  out.emplace_back("smoothing_first", p.smoothing[0]);
  out.emplace_back("smoothing_last", p.smoothing[1]);
  out.emplace_back("iterations_one", static_cast<long long>(p.iterations[0]));
  out.emplace_back("iterations_two", static_cast<long long>(p.iterations[1]));
  out.emplace_back(
      "straightening",
      std::string(p.straightening == Straightening::orthogonal ? "orthogonal" : "fractions"));
}

}  // namespace

Result assemble_result(const Shape& shape, const std::vector<RegionSolution>& regions,
                       const Options& options, int degree) {
  Result result;
  result.name = shape.name;
  result.degree = degree;
  result.curves = shape.curves;
  std::vector<RegionSolution> placed = regions;
  place_side_by_side(placed);
  for (const RegionSolution& region : placed) add_region(shape, region, result);
  result.parameters = {{"version", std::string(version())},
                       {"method", std::string(options.method == Method::paper ? "paper" : "exact")},
                       {"alpha", options.alpha},
                       {"mips_bound", options.mips_bound},
                       {"degree", static_cast<long long>(degree)},
                       {"exceptional", static_cast<long long>(options.exceptional)},
                       {"corner_angle", options.corner_angle},
                       {"seed", static_cast<long long>(options.seed)}};
  if (options.refine > 0) result.parameters.emplace_back("refine", options.refine);
  if (options.no_overlap) result.parameters.emplace_back("no_overlap", true);
  if (c1_asked(options) > 0) result.parameters.emplace_back("c1_bound", c1_asked(options));
  if (options.method == Method::paper) add_paper_parameters(options, result.parameters);
  return result;
}

}  // namespace c1mesh
