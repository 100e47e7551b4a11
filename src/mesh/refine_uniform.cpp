// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/curve.h"
#include "mesh/split.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

// Builds the refined mesh: vertices are the old ones, then one per edge in MeshTopology's order.
class UniformRefiner {
 public:
  explicit UniformRefiner(const CurvedMesh& mesh) : old_(mesh), topology_(mesh) {}

  CurvedMesh refine() {
    new_.degree = old_.degree;
    new_.domain = old_.domain;
    new_.control.assign(old_.control.begin(), old_.control.begin() + old_.vertex_count());
    for (const MeshEdge& e : topology_.edges) add_middle(e);
    for (const MeshEdge& e : topology_.edges) add_halves(e);
    for (int t = 0; t < old_.triangle_count(); ++t) add_parts(t);
    for (const auto& loop : old_.loops) new_.loops.push_back(halved(loop));
    for (const FeatureLine& line : old_.features)
      new_.features.push_back({halved(line.edges), line.closed});
    return std::move(new_);
  }

 private:
  BezierCurve edge_curve(const MeshEdge& e) const {
    BezierCurve curve;
    for (int id : edge_controls(old_, e.triangle[0], e.corner[0]))
      curve.poles.push_back(old_.control[id]);
    return curve;
  }

  void add_middle(const MeshEdge& e) {
    new_.domain.push_back(0.5 * (old_.domain[e.a] + old_.domain[e.b]));
    new_.control.push_back(evaluate(edge_curve(e), 0.5));
  }

  std::vector<int> store(const std::vector<Point>& poles) {
    std::vector<int> ids;
    for (int i = 1; i < old_.degree; ++i) {
      ids.push_back(static_cast<int>(new_.control.size()));
      new_.control.push_back(poles[i]);
    }
    return ids;
  }

  void add_halves(const MeshEdge& e) {
    const BezierCurve curve = edge_curve(e);
    halves_.push_back(
        {store(restrict_curve(curve, 0, 0.5).poles), store(restrict_curve(curve, 0.5, 1).poles)});
  }

  // The ids of the half of edge e that touches corner vertex v, from v to the middle.
  std::vector<int> half_from(int e, int v) const {
    if (topology_.edges[e].a == v) return halves_[e][0];
    return {halves_[e][1].rbegin(), halves_[e][1].rend()};
  }

  void add_triangle(int t, const std::array<int, 3>& corners,
                    const std::array<std::vector<int>, 3>& side, const Net& values) {
    const int n = new_.degree, base = static_cast<int>(new_.nets.size());
    new_.triangles.push_back(corners);
    new_.warped.push_back(old_.warped[t]);
    new_.nets.resize(base + new_.net_size());
    int* net = &new_.nets[base];
    net[new_.net_index(0, 0)] = corners[0];
    net[new_.net_index(n, 0)] = corners[1];
    net[new_.net_index(0, n)] = corners[2];
    for (int i = 1; i < n; ++i) {
      net[new_.net_index(i, 0)] = side[0][i - 1];
      net[new_.net_index(n - i, i)] = side[1][i - 1];
      net[new_.net_index(0, n - i)] = side[2][i - 1];
    }
    for (int j = 1; j < n; ++j)
      for (int i = 1; i < n - j; ++i) {
        net[new_.net_index(i, j)] = static_cast<int>(new_.control.size());
        new_.control.push_back(values[new_.net_index(i, j)]);
      }
  }

  void add_parts(int t) {
    const int n = old_.degree;
    const auto& v = old_.triangles[t];
    const auto& e = topology_.triangle_edges[t];
    const Net whole = net_of(old_, t);
    const auto reversed_ids = [](const std::vector<int>& ids) {
      return std::vector<int>(ids.rbegin(), ids.rend());
    };
    // middle[k] lies opposite corner k; across[k] runs from middle[k+2] to middle[k+1], cutting off
    // k.
    Barycentric middle[3];
    int vertex[3];
    for (int k = 0; k < 3; ++k) {
      middle[k] = 0.5 * (Barycentric::Unit((k + 1) % 3) + Barycentric::Unit((k + 2) % 3));
      vertex[k] = old_.vertex_count() + e[k];
    }
    std::vector<int> across[3];
    for (int k = 0; k < 3; ++k)
      across[k] = store(restrict_net_to_line(whole, n, middle[(k + 2) % 3], middle[(k + 1) % 3]));
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      add_triangle(t, {v[k], vertex[m], vertex[l]},
                   {half_from(e[m], v[k]), across[k], reversed_ids(half_from(e[l], v[k]))},
                   restrict_net(whole, n, Barycentric::Unit(k), middle[m], middle[l]));
    }
    // The sides of the middle triangle (0, 1, 2) run against across: 0 -> 1 cuts off corner 2.
    add_triangle(t, {vertex[0], vertex[1], vertex[2]},
                 {reversed_ids(across[2]), reversed_ids(across[0]), reversed_ids(across[1])},
                 restrict_net(whole, n, middle[0], middle[1], middle[2]));
  }

  std::vector<BoundaryEdge> halved(const std::vector<BoundaryEdge>& edges) const {
    std::vector<BoundaryEdge> out;
    for (const BoundaryEdge& whole : edges) {
      const int middle = old_.vertex_count() + edge_at(whole.a, whole.b);
      const double t = 0.5 * (whole.t0 + whole.t1);
      out.push_back({whole.a, middle, whole.curve, whole.t0, t});
      out.push_back({middle, whole.b, whole.curve, t, whole.t1});
    }
    return out;
  }

  int edge_at(int a, int b) const {
    for (int t : topology_.vertex_triangles[a])
      for (int k = 0; k < 3; ++k)
        if (old_.triangles[t][(k + 1) % 3] == a && old_.triangles[t][(k + 2) % 3] == b)
          return topology_.triangle_edges[t][k];
    return -1;
  }

  const CurvedMesh& old_;
  MeshTopology topology_;
  std::vector<std::array<std::vector<int>, 2>> halves_;  // per edge, inner ids from a to b
  CurvedMesh new_;
};

}  // namespace

void refine_uniform(CurvedMesh& mesh) {
  mesh = UniformRefiner(mesh).refine();
}

}  // namespace c1mesh
