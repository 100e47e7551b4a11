// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: the curved triangles cut into straight ones, the domain as texture coordinates.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "c1mesh/write.h"
#include "write/mesh_edges.h"

namespace c1mesh {
namespace {

/// The points of all triangles' lattices, each once: those at vertices and on edges are shared.
class Tessellation {
 public:
  Tessellation(const PiecewiseMap& map, int cuts) : map_(map), cuts_(cuts) {}

  /// Ids of triangle t's lattice points, for j: for i, at (i, j) / cuts.
  std::vector<int> lattice(int t) {
    std::vector<int> out;
    for (int j = 0; j <= cuts_; ++j)
      for (int i = 0; i <= cuts_ - j; ++i) out.push_back(id(t, {cuts_ - i - j, i, j}));
    return out;
  }
  const std::vector<Point>& shape() const { return shape_; }
  const std::vector<Point>& domain() const { return domain_; }

 private:
  int id(int t, const std::array<int, 3>& weight) {
    const auto& v = map_.result().triangles[t];
    const auto inside = std::count_if(weight.begin(), weight.end(), [](int w) { return w > 0; });
    if (inside == 3) return add(t, weight);
    // Weights by vertex tell a vertex or a place on an edge, from whichever triangle it is seen.
    std::array<std::pair<int, int>, 3> key;
    for (int k = 0; k < 3; ++k)
      key[k] = weight[k] > 0 ? std::pair(v[k], weight[k]) : std::pair(-1, 0);
    std::sort(key.begin(), key.end());
    const auto [entry, fresh] = shared_.emplace(key, 0);
    if (fresh) entry->second = add(t, weight);
    return entry->second;
  }

  int add(int t, const std::array<int, 3>& weight) {
    const double n = cuts_;
    const Barycentric at(weight[0] / n, weight[1] / n, weight[2] / n);
    shape_.push_back(map_.evaluate(t, at));
    domain_.push_back(map_.domain_point(t, at));
    return static_cast<int>(shape_.size()) - 1;
  }

  const PiecewiseMap& map_;
  int cuts_;
  std::map<std::array<std::pair<int, int>, 3>, int> shared_;
  std::vector<Point> shape_, domain_;
};

void add_faces(std::string& out, const std::vector<int>& lattice, int cuts) {
  const auto at = [&](int i, int j) { return lattice[j * (cuts + 1) - j * (j - 1) / 2 + i] + 1; };
  const auto face = [&](int a, int b, int c) {
    fmt::format_to(std::back_inserter(out), "f {0}/{0} {1}/{1} {2}/{2}\n", a, b, c);
  };
  for (int j = 0; j < cuts; ++j)
    for (int i = 0; i < cuts - j; ++i) {
      face(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + j < cuts - 1) face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
}

}  // namespace

std::string format_obj(const Result& result, int tessellation) {
  const int cuts = std::max(1, tessellation);
  const PiecewiseMap map(result);
  const std::vector<int> region = regions_of(result, edges_of(map));
  Tessellation points(map, cuts);
  std::map<int, std::string> faces;  // by region
  for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
    add_faces(faces[region[t]], points.lattice(t), cuts);
  std::string out = fmt::format("# {} pieces along each edge; vt: the place in the domain\n", cuts);
  for (const Point& p : points.shape())
    fmt::format_to(std::back_inserter(out), "v {} {} 0\n", p.x(), p.y());
  for (const Point& p : points.domain())
    fmt::format_to(std::back_inserter(out), "vt {} {}\n", p.x(), p.y());
  for (const auto& [number, text] : faces) out += fmt::format("g region_{}\n", number) + text;
  return out;
}

}  // namespace c1mesh
