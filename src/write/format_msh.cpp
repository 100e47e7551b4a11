// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh's MSH 4.1, ASCII: complete Lagrange elements of the map's degree, an entity and a physical
// group for every input curve, region and exceptional vertex.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "c1mesh/error.h"
#include "c1mesh/write.h"
#include "write/curve_edges.h"
#include "write/mesh_edges.h"
#include "write/nodes.h"

namespace c1mesh {
namespace {

// GmshDefines.h; complete elements of order 1 … 10.
constexpr int kPointElement = 15;
constexpr std::array<int, 10> kLineElements{1, 8, 26, 27, 28, 62, 63, 64, 65, 66};
constexpr std::array<int, 10> kTriangleElements{2, 9, 21, 23, 25, 42, 43, 44, 45, 46};

/// A model entity of dimension 0, 1 or 2 with what lies on it. Gmsh's tags count from 1.
struct Entity {
  int dimension = 0, tag = 0;
  bool physical = true;
  std::vector<int> boundary;               ///< signed tags of entities one dimension lower
  std::vector<int> nodes;                  ///< ids, ascending; each node is on one entity alone
  std::vector<std::vector<int>> elements;  ///< ids of their nodes in Gmsh's order
};

struct Box {
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
  void add(const Point& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

/// Sorts the mesh into entities: points, curves, surfaces.
class Model {
 public:
  explicit Model(const PiecewiseMap& map)
      : map_(map), region_(regions_of(map.result(), edges_of(map))) {
    find_vertices();
    add_curves();
    add_surfaces();
    add_points();
    place_nodes();
  }

  /// By dimension, then by tag.
  std::vector<Entity> entities() const {
    std::vector<Entity> out = points_;
    out.insert(out.end(), curves_.begin(), curves_.end());
    out.insert(out.end(), surfaces_.begin(), surfaces_.end());
    return out;
  }

 private:
  /// The node of each vertex.
  void find_vertices() {
    const Result& result = map_.result();
    vertex_node_.assign(result.domain_vertices.size(), -1);
    for (int t = 0; t < static_cast<int>(result.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k)
        vertex_node_[result.triangles[t][k]] = map_.control_id(t, k, 0, 0);
    for (const int v : result.exceptional_vertices)
      if (vertex_node_[v] >= 0) points_at_.emplace(v, true);
  }

  /// One entity per input curve that edges lie on, its elements along it.
  void add_curves() {
    std::map<int, std::vector<EdgeOnCurve>> by_curve;
    for (const EdgeOnCurve& e : edges_on_curves(map_.result())) by_curve[e.edge.curve].push_back(e);
    for (auto& [curve, edges] : by_curve) {
      const auto start = [](const EdgeOnCurve& e) { return std::min(e.edge.t0, e.edge.t1); };
      std::sort(edges.begin(), edges.end(),
                [&](const EdgeOnCurve& a, const EdgeOnCurve& b) { return start(a) < start(b); });
      Entity entity{1, curve + 1, true, {}, {}, {}};
      for (const EdgeOnCurve& e : edges) entity.elements.push_back(along_curve(e));
      const auto end_of = [](const EdgeOnCurve& e, bool last) {
        return (e.edge.t0 < e.edge.t1) == last ? e.edge.b : e.edge.a;
      };
      ends_[curve] = {end_of(edges.front(), false), end_of(edges.back(), true)};
      for (const int v : ends_[curve]) points_at_.emplace(v, false);
      curves_.push_back(std::move(entity));
      const EdgeOnCurve& first = edges.front();
      if (first.feature) continue;
      const int sign = first.edge.t0 < first.edge.t1 ? 1 : -1;
      bounding_[region_[first.triangle]].push_back(sign * (curve + 1));
    }
  }

  /// The edge's nodes in the direction of growing t.
  std::vector<int> along_curve(const EdgeOnCurve& e) const {
    std::vector<int> nodes = edge_nodes(map_, e.triangle, e.corner);
    if ((e.edge.t0 < e.edge.t1) == e.against) {
      std::swap(nodes[0], nodes[1]);
      std::reverse(nodes.begin() + 2, nodes.end());
    }
    return nodes;
  }

  void add_surfaces() {
    const int regions = region_.empty() ? 0 : *std::max_element(region_.begin(), region_.end()) + 1;
    for (int r = 0; r < regions; ++r) surfaces_.push_back({2, r + 1, true, bounding_[r], {}, {}});
    for (int t = 0; t < static_cast<int>(region_.size()); ++t)
      surfaces_[region_[t]].elements.push_back(triangle_nodes(map_, t));
  }

  /// Points: exceptional vertices, and the ends of curves, which bound them. Elements only where
  /// there is a physical group: readers take every element to be in one, or none.
  void add_points() {
    std::map<int, int> tag_of;
    for (const auto& [v, exceptional] : points_at_) {
      const int tag = static_cast<int>(points_.size()) + 1;
      tag_of[v] = tag;
      Entity entity{0, tag, exceptional, {}, {vertex_node_[v]}, {}};
      if (exceptional) entity.elements.push_back({vertex_node_[v]});
      points_.push_back(std::move(entity));
    }
    for (Entity& curve : curves_) {
      const auto& [from, to] = ends_[curve.tag - 1];
      curve.boundary = {tag_of[from], -tag_of[to]};
    }
  }

  /// Each node goes to the first entity, by dimension and tag, that has it.
  void place_nodes() {
    std::vector<char> placed(map_.result().control_points.size(), 0);
    for (const Entity& point : points_) placed[point.nodes.front()] = 1;
    for (std::vector<Entity>* list : {&curves_, &surfaces_})
      for (Entity& entity : *list) {
        std::set<int> nodes;
        for (const auto& element : entity.elements)
          for (const int id : element)
            if (!placed[id]) nodes.insert(id);
        entity.nodes.assign(nodes.begin(), nodes.end());
        for (const int id : entity.nodes) placed[id] = 1;
      }
  }

  const PiecewiseMap& map_;
  std::vector<int> region_, vertex_node_;
  std::map<int, bool> points_at_;  ///< vertex -> exceptional
  std::map<int, std::array<int, 2>> ends_;
  std::map<int, std::vector<int>> bounding_;
  std::vector<Entity> points_, curves_, surfaces_;
};

class MshText {
 public:
  template <class... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Values>(values)...);
    out_ += '\n';
  }
  /// Appended to the line before.
  void more(const std::vector<int>& numbers) {
    out_.pop_back();
    for (const int number : numbers) fmt::format_to(std::back_inserter(out_), " {}", number);
    out_ += '\n';
  }
  const std::string& text() const { return out_; }

 private:
  std::string out_;
};

/// The physical group's tag: the entity's own, but all exceptional vertices are one group.
int physical_tag(const Entity& entity) {
  return entity.dimension == 0 ? 1 : entity.tag;
}

void add_physical_names(MshText& out, const std::vector<Entity>& entities) {
  std::map<std::array<int, 2>, std::string> names;
  for (const Entity& e : entities) {
    if (!e.physical) continue;
    names[{e.dimension, physical_tag(e)}] = e.dimension == 0 ? "exceptional"
                                            : e.dimension == 1
                                                ? fmt::format("curve {}", e.tag - 1)
                                                : fmt::format("region {}", e.tag - 1);
  }
  out.line("$PhysicalNames\n{}", names.size());
  for (const auto& [key, name] : names) out.line("{} {} \"{}\"", key[0], key[1], name);
  out.line("$EndPhysicalNames");
}

void add_entities(MshText& out, const std::vector<Entity>& entities,
                  const std::vector<Point>& points) {
  std::array<int, 3> count{0, 0, 0};
  for (const Entity& e : entities) ++count[e.dimension];
  out.line("$Entities\n{} {} {} 0", count[0], count[1], count[2]);
  for (const Entity& e : entities) {
    Box box;
    for (const int id : e.nodes) box.add(points[id]);
    for (const auto& element : e.elements)
      for (const int id : element) box.add(points[id]);
    if (e.dimension == 0)
      out.line("{} {} {} 0", e.tag, box.low.x(), box.low.y());
    else
      out.line("{} {} {} 0 {} {} 0", e.tag, box.low.x(), box.low.y(), box.high.x(), box.high.y());
    out.more(e.physical ? std::vector<int>{1, physical_tag(e)} : std::vector<int>{0});
    if (e.dimension == 0) continue;
    out.more({static_cast<int>(e.boundary.size())});
    out.more(e.boundary);
  }
  out.line("$EndEntities");
}

void add_nodes(MshText& out, const std::vector<Entity>& entities,
               const std::vector<Point>& points) {
  std::size_t blocks = 0, count = 0;
  int least = std::numeric_limits<int>::max(), most = 0;
  for (const Entity& e : entities) {
    if (e.nodes.empty()) continue;
    ++blocks;
    count += e.nodes.size();
    least = std::min(least, e.nodes.front() + 1);
    most = std::max(most, e.nodes.back() + 1);
  }
  out.line("$Nodes\n{} {} {} {}", blocks, count, std::min(least, most), most);
  for (const Entity& e : entities) {
    if (e.nodes.empty()) continue;
    out.line("{} {} 0 {}", e.dimension, e.tag, e.nodes.size());
    for (const int id : e.nodes) out.line("{}", id + 1);
    for (const int id : e.nodes) out.line("{} {} 0", points[id].x(), points[id].y());
  }
  out.line("$EndNodes");
}

void add_elements(MshText& out, const std::vector<Entity>& entities, int degree) {
  std::size_t blocks = 0, count = 0;
  for (const Entity& e : entities) {
    blocks += !e.elements.empty();
    count += e.elements.size();
  }
  out.line("$Elements\n{} {} {} {}", blocks, count, count > 0 ? 1 : 0, count);
  const std::array<int, 3> types{kPointElement, kLineElements[degree - 1],
                                 kTriangleElements[degree - 1]};
  int tag = 0;
  for (const Entity& e : entities) {
    if (e.elements.empty()) continue;
    out.line("{} {} {} {}", e.dimension, e.tag, types[e.dimension], e.elements.size());
    for (const auto& element : e.elements) {
      std::vector<int> tags;
      tags.reserve(element.size());
      for (const int id : element) tags.push_back(id + 1);
      out.line("{}", ++tag);
      out.more(tags);
    }
  }
  out.line("$EndElements");
}

/// A view of the domain coordinates over the nodes.
void add_domain_view(MshText& out, const std::vector<char>& used, const std::vector<Point>& uv) {
  const auto count = std::count(used.begin(), used.end(), 1);
  out.line("$NodeData\n1\n\"domain\"\n1\n0\n3\n0\n3\n{}", count);
  for (std::size_t id = 0; id < uv.size(); ++id)
    if (used[id]) out.line("{} {} {} 0", id + 1, uv[id].x(), uv[id].y());
  out.line("$EndNodeData");
}

}  // namespace

std::string format_msh(const Result& result, bool domain) {
  if (result.degree > kHighestGmshDegree) {
    Defect defect;
    defect.kind = DefectKind::unsupported;
    defect.message = fmt::format("Gmsh has no triangles of degree {}: its highest is {}",
                                 result.degree, kHighestGmshDegree);
    defect.remedy = "use .vtu or .mesh";
    throw InputError({defect});
  }
  const PiecewiseMap map(result);
  const std::vector<Point> uv = domain_net(map);
  const std::vector<Point> points = domain ? uv : interpolation_nodes(map);
  const std::vector<Entity> entities = Model(map).entities();
  MshText out;
  out.line("$MeshFormat\n4.1 0 8\n$EndMeshFormat");
  add_physical_names(out, entities);
  add_entities(out, entities, points);
  add_nodes(out, entities, points);
  add_elements(out, entities, result.degree);
  add_domain_view(out, used_nodes(result), uv);
  return out.text();
}

}  // namespace c1mesh
