// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/split.h"

#include <algorithm>
#include <stdexcept>

namespace c1mesh {
namespace {

Barycentric unit(int k) {
  return Barycentric::Unit(k);
}

// Net positions along the side from local corner k to local corner l, ends included.
int side_position(const CurvedMesh& mesh, int k, int l, int i) {
  const int n = mesh.degree;
  int weight[3] = {0, 0, 0};
  weight[k] = n - i;
  weight[l] += i;
  return mesh.net_index(weight[1], weight[2]);
}

int local_corner(const std::array<int, 3>& triangle, int v) {
  return static_cast<int>(std::find(triangle.begin(), triangle.end(), v) - triangle.begin());
}

// De Casteljau at t: the control points of both parts, the second begins where the first ends.
std::array<std::vector<Point>, 2> halves(std::vector<Point> p, double t) {
  const std::size_t n = p.size() - 1;
  std::array<std::vector<Point>, 2> out;
  out[1].resize(n + 1);
  for (std::size_t last = n;; --last) {
    out[0].push_back(p[0]);
    out[1][last] = p[last];
    if (last == 0) break;
    for (std::size_t i = 0; i < last; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  }
  return out;
}

// The edge was split at the middle of its parameters.
std::array<BoundaryEdge, 2> halves_of(const BoundaryEdge& whole, int middle) {
  const double t_middle = 0.5 * (whole.t0 + whole.t1);
  return {BoundaryEdge{whole.a, middle, whole.curve, whole.t0, t_middle},
          BoundaryEdge{middle, whole.b, whole.curve, t_middle, whole.t1}};
}

}  // namespace

MeshSplitter::MeshSplitter(CurvedMesh& mesh) : mesh_(mesh) {
  const int vertices = mesh_.vertex_count();
  images_.assign(mesh_.control.begin(), mesh_.control.begin() + vertices);
  others_.assign(mesh_.control.begin() + vertices, mesh_.control.end());
  for (int& id : mesh_.nets)
    if (id >= vertices) id = -1 - (id - vertices);
  vertex_triangles_.resize(vertices);
  for (int t = 0; t < mesh_.triangle_count(); ++t)
    for (int v : mesh_.triangles[t]) vertex_triangles_[v].push_back(t);
}

MeshSplitter::~MeshSplitter() {
  finish();
}

void MeshSplitter::finish() {
  if (finished_) return;
  finished_ = true;
  const int vertices = mesh_.vertex_count();
  for (int& id : mesh_.nets)
    if (id < 0) id = vertices + (-1 - id);
  mesh_.control = std::move(images_);
  mesh_.control.insert(mesh_.control.end(), others_.begin(), others_.end());
}

const Point& MeshSplitter::point(int id) const {
  return id >= 0 ? images_[id] : others_[-1 - id];
}
Point& MeshSplitter::point(int id) {
  return id >= 0 ? images_[id] : others_[-1 - id];
}

int MeshSplitter::new_vertex(const Point& domain, const Point& image) {
  mesh_.domain.push_back(domain);
  images_.push_back(image);
  vertex_triangles_.emplace_back();
  return mesh_.vertex_count() - 1;
}

int MeshSplitter::new_triangle(bool warped) {
  mesh_.triangles.push_back({-1, -1, -1});
  mesh_.warped.push_back(warped);
  mesh_.nets.resize(mesh_.nets.size() + mesh_.net_size());
  return mesh_.triangle_count() - 1;
}

MeshSplitter::Ids MeshSplitter::new_points(const std::vector<Point>& points) {
  Ids ids;
  for (const Point& p : points) {
    others_.push_back(p);
    ids.push_back(-static_cast<int>(others_.size()));
  }
  return ids;
}

// The triangle that has a -> b counter-clockwise, or -1.
int MeshSplitter::find_triangle(int a, int b) const {
  if (a < 0 || b < 0 || a >= mesh_.vertex_count() || b >= mesh_.vertex_count()) return -1;
  for (int t : vertex_triangles_[a]) {
    const auto& v = mesh_.triangles[t];
    if (v[(local_corner(v, a) + 1) % 3] == b) return t;
  }
  return -1;
}

MeshSplitter::Ids MeshSplitter::inner_edge_ids(int t, int a, int b) const {
  const auto& v = mesh_.triangles[t];
  const int k = local_corner(v, a), l = local_corner(v, b);
  Ids ids;
  for (int i = 1; i < mesh_.degree; ++i)
    ids.push_back(mesh_.nets[t * mesh_.net_size() + side_position(mesh_, k, l, i)]);
  return ids;
}

MeshSplitter::Ids MeshSplitter::interior_ids(int t) const {
  Ids ids;
  for (int j = 1; j < mesh_.degree; ++j)
    for (int i = 1; i < mesh_.degree - j; ++i) ids.push_back(mesh_.control_id(t, i, j));
  return ids;
}

Net MeshSplitter::net(int t) const {
  Net out;
  for (int k = 0; k < mesh_.net_size(); ++k)
    out.push_back(point(mesh_.nets[t * mesh_.net_size() + k]));
  return out;
}

// Makes t the triangle of these corners; edge ids run in the direction named. `values` is its net,
// of which only the interior is stored: edges have their points already.
void MeshSplitter::write_triangle(int t, const std::array<int, 3>& corners, const Ids& ab,
                                  const Ids& bc, const Ids& ca, const Ids& interior,
                                  const Net& values) {
  for (int v : mesh_.triangles[t])
    if (v >= 0) std::erase(vertex_triangles_[v], t);
  mesh_.triangles[t] = corners;
  for (int v : corners) vertex_triangles_[v].push_back(t);
  int* out = &mesh_.nets[t * mesh_.net_size()];
  const int n = mesh_.degree;
  for (int k = 0; k < 3; ++k) out[side_position(mesh_, k, (k + 1) % 3, 0)] = corners[k];
  for (int i = 1; i < n; ++i) {
    out[side_position(mesh_, 0, 1, i)] = ab[i - 1];
    out[side_position(mesh_, 1, 2, i)] = bc[i - 1];
    out[side_position(mesh_, 2, 0, i)] = ca[i - 1];
  }
  std::size_t next = 0;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n - j; ++i) {
      const int id = interior[next++];
      out[mesh_.net_index(i, j)] = id;
      point(id) = values[mesh_.net_index(i, j)];
    }
}

// Cuts the edge a -> b of triangle t: the first part keeps the edge's control points, the second
// gets new ones. The domain's new vertex is the affine combination.
std::array<MeshSplitter::Ids, 2> MeshSplitter::split_edge_points(int t, int a, int b, double t_edge,
                                                                 int& middle) {
  const Ids old = inner_edge_ids(t, a, b);
  std::vector<Point> poles{images_[a]};
  for (int id : old) poles.push_back(point(id));
  poles.push_back(images_[b]);
  const auto parts = halves(poles, t_edge);
  middle = new_vertex((1 - t_edge) * mesh_.domain[a] + t_edge * mesh_.domain[b], parts[1].front());
  for (std::size_t i = 0; i < old.size(); ++i) point(old[i]) = parts[0][i + 1];
  return {old, new_points({parts[1].begin() + 1, parts[1].end() - 1})};
}

// Triangle t = (a, b, c) becomes (a, middle, c); (middle, b, c) is appended.
void MeshSplitter::split_side(int t, const Net& whole, int a, int b, double t_edge, int middle,
                              const std::array<Ids, 2>& parts) {
  const auto v = mesh_.triangles[t];
  const int n = mesh_.degree;
  const int ka = local_corner(v, a), kb = local_corner(v, b), kc = 3 - ka - kb;
  const int c = v[kc];
  const Barycentric cut = (1 - t_edge) * unit(ka) + t_edge * unit(kb);
  const auto line = restrict_net_to_line(whole, n, cut, unit(kc));
  const Ids rise = new_points({line.begin() + 1, line.end() - 1});
  const Ids fall(rise.rbegin(), rise.rend());
  const Ids bc = inner_edge_ids(t, b, c), ca = inner_edge_ids(t, c, a), interior = interior_ids(t);
  const Ids more = new_points(std::vector<Point>(interior.size(), Point::Zero()));
  const int added = new_triangle(mesh_.warped[t]);
  write_triangle(t, {a, middle, c}, parts[0], rise, ca, interior,
                 restrict_net(whole, n, unit(ka), cut, unit(kc)));
  write_triangle(added, {middle, b, c}, parts[1], bc, fall, more,
                 restrict_net(whole, n, cut, unit(kb), unit(kc)));
}

int MeshSplitter::split_edge(int a, int b, double t) {
  const int left = find_triangle(a, b), right = find_triangle(b, a);
  if (left < 0 || right < 0) throw std::invalid_argument("split_edge: not an interior edge");
  const Net left_net = net(left), right_net = net(right);
  int middle = -1;
  const auto parts = split_edge_points(left, a, b, t, middle);
  std::array<Ids, 2> back{Ids(parts[1].rbegin(), parts[1].rend()),
                          Ids(parts[0].rbegin(), parts[0].rend())};
  split_side(left, left_net, a, b, t, middle, parts);
  split_side(right, right_net, b, a, 1 - t, middle, back);
  return middle;
}

std::array<BoundaryEdge, 2> MeshSplitter::halve(const BoundaryEdge& whole, bool feature) {
  if (feature) return halves_of(whole, split_edge(whole.a, whole.b));
  const int t = find_triangle(whole.a, whole.b);
  if (t < 0) throw std::invalid_argument("split_boundary_edge: no triangle at this edge");
  const Net before = net(t);
  int middle = -1;
  const auto parts = split_edge_points(t, whole.a, whole.b, 0.5, middle);
  split_side(t, before, whole.a, whole.b, 0.5, middle, parts);
  return halves_of(whole, middle);
}

void MeshSplitter::halve_all(std::vector<BoundaryEdge>& path, const std::vector<int>& indices,
                             bool feature) {
  // Backwards, as the indices are.
  std::vector<BoundaryEdge> out;
  out.reserve(path.size() + indices.size());
  std::size_t left = path.size();
  for (const int index : indices) {
    while (left > static_cast<std::size_t>(index) + 1) out.push_back(path[--left]);
    const auto parts = halve(path[--left], feature);
    out.push_back(parts[1]);
    out.push_back(parts[0]);
  }
  while (left > 0) out.push_back(path[--left]);
  path.assign(out.rbegin(), out.rend());
}

int MeshSplitter::split_boundary_edge(int loop, int index) {
  auto& edges = mesh_.loops.at(loop);
  const auto parts = halve(edges.at(index), false);
  edges[index] = parts[0];
  edges.insert(edges.begin() + index + 1, parts[1]);
  return parts[0].b;
}

int MeshSplitter::split_feature_edge(int line, int index) {
  auto& edges = mesh_.features.at(line).edges;
  const auto parts = halve(edges.at(index), true);
  edges[index] = parts[0];
  edges.insert(edges.begin() + index + 1, parts[1]);
  return parts[0].b;
}

int MeshSplitter::split_triangle(int t, const Barycentric& where) {
  if (t < 0 || t >= mesh_.triangle_count() || !(where.minCoeff() > 0))
    throw std::invalid_argument("split_triangle: no such triangle or point not inside");
  const int n = mesh_.degree;
  const Net whole = net(t);
  const auto v = mesh_.triangles[t];
  Point domain = Point::Zero();
  for (int k = 0; k < 3; ++k) domain += where[k] * mesh_.domain[v[k]];
  const int middle = new_vertex(domain, evaluate(whole, n, where));
  Ids side[3], spoke[3];
  for (int k = 0; k < 3; ++k) {
    side[k] = inner_edge_ids(t, v[k], v[(k + 1) % 3]);
    const auto line = restrict_net_to_line(whole, n, unit(k), where);
    spoke[k] = new_points({line.begin() + 1, line.end() - 1});
  }
  Ids interior = interior_ids(t);
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, part = k == 0 ? t : new_triangle(mesh_.warped[t]);
    if (k > 0) interior = new_points(std::vector<Point>(interior.size(), Point::Zero()));
    write_triangle(part, {v[k], v[l], middle}, side[k], spoke[l],
                   Ids(spoke[k].rbegin(), spoke[k].rend()), interior,
                   restrict_net(whole, n, unit(k), unit(l), where));
  }
  return middle;
}

int split_edge(CurvedMesh& mesh, int a, int b, double t) {
  return MeshSplitter(mesh).split_edge(a, b, t);
}

int split_boundary_edge(CurvedMesh& mesh, int loop, int index) {
  return MeshSplitter(mesh).split_boundary_edge(loop, index);
}

int split_feature_edge(CurvedMesh& mesh, int line, int index) {
  return MeshSplitter(mesh).split_feature_edge(line, index);
}

int clough_tocher_split(CurvedMesh& mesh, int triangle) {
  return MeshSplitter(mesh).split_triangle(triangle, Barycentric::Constant(1.0 / 3));
}

}  // namespace c1mesh
