// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/initial_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "bernstein/curve.h"
#include "bernstein/net_blossom.h"
#include "c1mesh/cost.h"
#include "mesh/guard.h"
#include "mesh/no_mesh.h"
#include "mesh/straight_mesh.h"
#include "mesh/topology.h"
#include "mesh/warp_layer.h"

namespace c1mesh {
namespace {

using meshing::ChordVertex;
using meshing::StraightMesh;
using meshing::WarpSegment;

// Turns the straight mesh into the curved one: every triangle inside a warp triangle becomes a
// piece of its map, edge control points are made once per edge.
class Assembler {
 public:
  Assembler(const MeshInput& input, const meshing::Walks& walks,
            const std::vector<std::vector<WarpSegment>>& layer, const StraightMesh& straight)
      : input_(input), walks_(walks), straight_(straight) {
    for (const auto& loop : layer)
      for (const WarpSegment& s : loop) segments_.push_back(&s);
  }

  CurvedMesh assemble() {
    mesh_.degree = input_.degree;
    mesh_.domain = mesh_.control = straight_.points;
    mesh_.triangles = straight_.triangles;
    mesh_.warped.assign(mesh_.triangles.size(), 0);
    mesh_.nets.assign(mesh_.triangles.size() * mesh_.net_size(), -1);
    make_curve_edges();
    map_vertices();
    // Unwarped triangles first: along inner edges both maps are linear, and theirs without
    // rounding.
    for (const bool warped : {false, true})
      for (int t = 0; t < mesh_.triangle_count(); ++t)
        if ((straight_.warp[t] >= 0) == warped) make_net(t);
    return std::move(mesh_);
  }

 private:
  // Edges on curves hold the curve's own control points, exact and rounded once. Loops and features
  // are put together from the walks' pieces: (path, position, s0) is the order along a path.
  void make_curve_edges() {
    std::map<std::tuple<bool, int, int, double>, int> pieces;
    for (int i = 0; i < static_cast<int>(segments_.size()); ++i) {
      const meshing::WalkStep& step = walks_[segments_[i]->loop][segments_[i]->source];
      if (step.forward) pieces[{step.feature, step.path, step.position, segments_[i]->s0}] = i;
    }
    mesh_.loops.resize(input_.loops.size());
    for (const FeatureInput& feature : input_.features)
      mesh_.features.push_back({{}, feature.closed});
    for (const auto& [key, i] : pieces) {
      const auto& [feature, path, position, s0] = key;
      auto& edges = feature ? mesh_.features[path].edges : mesh_.loops[path];
      const auto& chord = straight_.chords[i];
      for (std::size_t k = 0; k + 1 < chord.size(); ++k)
        edges.push_back(make_curve_edge(*segments_[i], chord[k], chord[k + 1]));
    }
  }

  BoundaryEdge make_curve_edge(const WarpSegment& s, const ChordVertex& from,
                               const ChordVertex& to) {
    const LoopCurve& source = walks_[s.loop][s.source].curve;
    const double s0 = s.s0 + (s.s1 - s.s0) * from.s, s1 = s.s0 + (s.s1 - s.s0) * to.s;
    const BezierCurve piece =
        from.s == 0 && to.s == 1 ? s.curve : restrict_exactly(source.bezier, s0, s1, input_.degree);
    mesh_.control[from.vertex] = piece.start();
    mesh_.control[to.vertex] = piece.end();
    if (s.straight)
      mesh_.domain[from.vertex] = piece.start(), mesh_.domain[to.vertex] = piece.end();
    store_edge(from.vertex, to.vertex, piece.poles);
    BoundaryEdge edge;
    edge.a = from.vertex;
    edge.b = to.vertex;
    edge.curve = source.curve;
    edge.t0 = source.reversed ? 1 - s0 : s0;
    edge.t1 = source.reversed ? 1 - s1 : s1;
    return edge;
  }

  // Vertices strictly inside a warp triangle move with its map; on inner edges the map is the
  // identity.
  void map_vertices() {
    std::vector<int> inside(mesh_.domain.size(), -2);  // -2: unseen, -1: on a boundary of regions
    for (const auto& chord : straight_.chords)
      for (const ChordVertex& c : chord) inside[c.vertex] = -1;
    for (int t = 0; t < mesh_.triangle_count(); ++t)
      for (int v : mesh_.triangles[t]) {
        const int warp = straight_.warp[t];
        inside[v] = inside[v] == -2 || inside[v] == warp ? warp : -1;
      }
    for (std::size_t v = 0; v < inside.size(); ++v)
      if (inside[v] >= 0)
        mesh_.control[v] = evaluate(warp_net(*segments_[inside[v]]), mesh_.degree,
                                    coordinates(static_cast<int>(v), inside[v]));
  }

  // Barycentric coordinates of a vertex in the straight warp triangle.
  Barycentric coordinates(int vertex, int warp) const {
    const WarpSegment& s = *segments_[warp];
    const Point e1 = s.curve.end() - s.curve.start(), e2 = s.apex - s.curve.start();
    const Point p = mesh_.domain[vertex] - s.curve.start();
    const double area = cross(e1, e2);
    const double u = cross(p, e2) / area, v = cross(e1, p) / area;
    return {1 - u - v, u, v};
  }

  void store_edge(int a, int b, const std::vector<Point>& points) {
    std::vector<int> ids;
    for (int i = 1; i < mesh_.degree; ++i) {
      ids.push_back(static_cast<int>(mesh_.control.size()));
      mesh_.control.push_back(points[i]);
    }
    if (a > b) std::reverse(ids.begin(), ids.end());
    edges_[{std::min(a, b), std::max(a, b)}] = std::move(ids);
  }

  // The inner control ids of edge a -> b, made by whoever comes first: triangles of one warp
  // triangle give the same points up to rounding, and along inner edges all maps are linear.
  std::vector<int> edge_ids(int t, int a, int b) {
    const auto found = edges_.find({std::min(a, b), std::max(a, b)});
    if (found == edges_.end()) {
      store_edge(a, b, edge_points(t, a, b));
      return edge_ids(t, a, b);
    }
    std::vector<int> ids = found->second;
    if (a > b) std::reverse(ids.begin(), ids.end());
    return ids;
  }

  std::vector<Point> edge_points(int t, int a, int b) const {
    const int warp = straight_.warp[t];
    if (warp >= 0)
      return restrict_net_to_line(warp_net(*segments_[warp]), mesh_.degree, coordinates(a, warp),
                                  coordinates(b, warp));
    std::vector<Point> points;
    const int n = mesh_.degree;
    for (int i = 0; i <= n; ++i)
      points.push_back((double(n - i) * mesh_.control[a] + double(i) * mesh_.control[b]) /
                       double(n));
    return points;
  }

  void make_net(int t) {
    const int n = mesh_.degree, warp = straight_.warp[t];
    const auto [a, b, c] = mesh_.triangles[t];
    int* net = &mesh_.nets[t * mesh_.net_size()];
    mesh_.warped[t] = warp >= 0;
    net[mesh_.net_index(0, 0)] = a;
    net[mesh_.net_index(n, 0)] = b;
    net[mesh_.net_index(0, n)] = c;
    const auto ab = edge_ids(t, a, b), bc = edge_ids(t, b, c), ca = edge_ids(t, c, a);
    for (int i = 1; i < n; ++i) {
      net[mesh_.net_index(i, 0)] = ab[i - 1];
      net[mesh_.net_index(n - i, i)] = bc[i - 1];
      net[mesh_.net_index(0, n - i)] = ca[i - 1];
    }
    if (n < 3) return;
    Net inner;
    if (warp >= 0)
      inner = restrict_net(warp_net(*segments_[warp]), n, coordinates(a, warp),
                           coordinates(b, warp), coordinates(c, warp));
    for (int j = 1; j < n; ++j)
      for (int i = 1; i < n - j; ++i) {
        net[mesh_.net_index(i, j)] = static_cast<int>(mesh_.control.size());
        const Point even = (double(n - i - j) * mesh_.control[a] + double(i) * mesh_.control[b] +
                            double(j) * mesh_.control[c]) /
                           double(n);
        mesh_.control.push_back(warp >= 0 ? inner[mesh_.net_index(i, j)] : even);
      }
  }

  const MeshInput& input_;
  const meshing::Walks& walks_;
  const StraightMesh& straight_;
  std::vector<const WarpSegment*> segments_;
  std::map<std::array<int, 2>, std::vector<int>> edges_;  // from the smaller to the larger vertex
  CurvedMesh mesh_;
};

constexpr std::size_t kManySegments = 30000, kMostSegments = 1'000'000;
// Long narrow shapes would be filled with well-shaped triangles by the thousand. Slender ones along
// them serve as well there, since the domain is as slender: above both numbers they are taken.
constexpr std::size_t kManyTriangles = 400, kManyPerCurve = 50;

struct Straight {
  std::vector<std::vector<WarpSegment>> layer;
  StraightMesh mesh;
};

// Nothing if the usual way needs too many triangles; then `report` says so.
std::optional<Straight> usual_straight(const MeshInput& input, const meshing::Walks& walks,
                                       const MeshOptions& options, MeshReport& report) {
  const meshing::Thrift thrift = meshing::usual_thrift();
  auto layer = meshing::build_warp_layer(walks, input.degree, options.mips_bound, thrift,
                                         kManySegments, report, options.stop);
  std::string many = fmt::format("over {} warp triangles", kManySegments);
  if (layer) {
    StraightMesh mesh = meshing::triangulate_layer(*layer, thrift, options.stop);
    std::size_t curves = 0;
    for (const auto& loop : input.loops) curves += loop.size();
    for (const auto& line : input.features) curves += line.curves.size();
    if (mesh.triangles.size() <= std::max(kManyTriangles, kManyPerCurve * curves))
      return Straight{std::move(*layer), std::move(mesh)};
    many = fmt::format("{} triangles for {} curves", mesh.triangles.size(), curves);
  }
  report = {};
  report.notes.push_back("slender triangles (else " + many + ")");
  return std::nullopt;
}

Straight strict_straight(const MeshInput& input, const meshing::Walks& walks,
                         const MeshOptions& options, MeshReport& report) {
  const meshing::Thrift thrift = meshing::strict_thrift();
  auto layer = meshing::build_warp_layer(walks, input.degree, options.mips_bound, thrift,
                                         kMostSegments, report, options.stop);
  if (!layer)
    throw NoMesh(
        fmt::format("the shape is so narrow that it needs more than {} triangles", kMostSegments));
  StraightMesh mesh = meshing::triangulate_layer(*layer, thrift, options.stop);
  return {std::move(*layer), std::move(mesh)};
}

double largest_bound(const CurvedMesh& mesh) {
  double bound = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) bound = std::max(bound, triangle_bound(mesh, t));
  return bound;
}

}  // namespace

CurvedMesh initial_mesh(const MeshInput& input, const MeshOptions& options, MeshReport& report) {
  report = {};
  if (input.loops.empty() || input.degree < 1) throw std::invalid_argument("nothing to mesh");
  std::optional<StageTimer> timer(std::in_place, "mesh: walks");
  const meshing::Walks walks = meshing::walks_of(input);
  timer.reset();
  auto straight = usual_straight(input, walks, options, report);
  if (!straight) straight = strict_straight(input, walks, options, report);
  timer.emplace("mesh: curved");
  CurvedMesh mesh = Assembler(input, walks, straight->layer, straight->mesh).assemble();
  timer.emplace("mesh: guard");
  guard_boundary(mesh);
  report.mips_bound = largest_bound(mesh);
  return mesh;
}

}  // namespace c1mesh
