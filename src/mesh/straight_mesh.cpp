// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/straight_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "bernstein/curve.h"
#include "c1mesh/cost.h"
#include "mesh/no_mesh.h"
#include "mesh/straight_cdt.h"

namespace c1mesh::meshing {
namespace {

// One loop's chords as flat segment numbers.
struct Ring {
  int first = 0, count = 0;
};

class Builder {
 public:
  Builder(const std::vector<std::vector<WarpSegment>>& layer, const Thrift& thrift,
          const Stop& stop)
      : thrift_(thrift), stop_(stop) {
    for (const auto& loop : layer) {
      rings_.push_back({static_cast<int>(segments_.size()), static_cast<int>(loop.size())});
      for (const WarpSegment& s : loop) segments_.push_back(&s);
    }
  }

  StraightMesh build() {
    std::optional<StageTimer> timer(std::in_place, "mesh: triangulation");
    insert_points();
    insert_constraints();
    mark_domain();
    timer.emplace("mesh: refinement");
    refine_delaunay(cdt_, segments_, thrift_, stop_);
    timer.emplace("mesh: numbering");
    number_vertices();
    collect_triangles();
    trace_chords();
    sort_triangles();
    return std::move(mesh_);
  }

 private:
  Vertex insert(const Point& p) {
    const Vertex v = cdt_.insert(KernelPoint(p.x(), p.y()), hint_);
    v->info().number = static_cast<int>(mesh_.points.size());
    hint_ = v->face();
    mesh_.points.push_back(p);
    vertices_.push_back(v);
    return v;
  }

  void insert_points() {
    for (const WarpSegment* s : segments_)
      if (s->start == static_cast<int>(corners_.size()))
        corners_.push_back(insert(s->curve.start()));
    for (const WarpSegment* s : segments_)
      apexes_.push_back(s->straight ? Vertex() : insert(s->apex));
    if (cdt_.number_of_vertices() != mesh_.points.size())
      throw NoMesh("two boundary points coincide");
    for (const Ring& ring : rings_)
      for (int i = ring.first; i < ring.first + ring.count; ++i) {
        const Vertex a = corners_[segments_[i]->start], b = corners_[segments_[i]->end];
        for (Vertex v : {a, b}) v->info().lines.push_back(line_of(i, Side::chord));
        if (segments_[i]->straight) continue;
        for (Vertex v : {a, apexes_[i]}) v->info().lines.push_back(line_of(i, Side::left));
        for (Vertex v : {apexes_[i], b}) v->info().lines.push_back(line_of(i, Side::right));
      }
  }

  void insert_constraints() {
    for (const Ring& ring : rings_)
      for (int i = ring.first; i < ring.first + ring.count; ++i) {
        const Vertex a = corners_[segments_[i]->start], b = corners_[segments_[i]->end];
        cdt_.insert_constraint(a, b);
        if (segments_[i]->straight) continue;
        cdt_.insert_constraint(a, apexes_[i]);
        cdt_.insert_constraint(apexes_[i], b);
      }
  }

  // Marks the faces left of the chords and all that no chord separates from them.
  void mark_domain() {
    std::vector<Face> stack;
    for (const Ring& ring : rings_)
      for (int i = ring.first; i < ring.first + ring.count; ++i) {
        const Vertex a = corners_[segments_[i]->start], b = corners_[segments_[i]->end];
        Face face;
        int k;
        if (!cdt_.is_edge(a, b, face, k)) throw NoMesh("a chord is not an edge");
        // The face that has a -> b counter-clockwise lies on the left.
        stack.push_back(face->vertex(Triangulation::ccw(k)) == a ? face : face->neighbor(k));
      }
    while (!stack.empty()) {
      const Face face = stack.back();
      stack.pop_back();
      if (face->info().in_domain) continue;
      if (cdt_.is_infinite(face)) throw NoMesh("the chord polygon is not simple");
      face->info().in_domain = true;
      for (int k = 0; k < 3; ++k)
        if (!is_chord(face, k)) stack.push_back(face->neighbor(k));
    }
  }

  // Before refinement the chords are the constraints between end points of segments.
  bool is_chord(Face face, int k) const {
    if (!face->is_constrained(k)) return false;
    const int a = face->vertex(Triangulation::ccw(k))->info().number;
    const int b = face->vertex(Triangulation::cw(k))->info().number;
    return std::max(a, b) < static_cast<int>(corners_.size());
  }

  // Steiner points in the order of their coordinates: no trace of the library's containers is left.
  void number_vertices() {
    std::vector<Vertex> steiner;
    for (auto v = cdt_.finite_vertices_begin(); v != cdt_.finite_vertices_end(); ++v)
      if (v->info().number < 0) steiner.push_back(v);
    std::sort(steiner.begin(), steiner.end(),
              [](Vertex a, Vertex b) { return a->point() < b->point(); });
    for (const Vertex& v : steiner) {
      v->info().number = static_cast<int>(mesh_.points.size());
      mesh_.points.push_back(point_of(v));
    }
    vertices_.insert(vertices_.end(), steiner.begin(), steiner.end());
  }

  void collect_triangles() {
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) {
      if (!f->info().in_domain) continue;
      f->info().number = static_cast<int>(faces_.size());
      faces_.push_back(f);
      mesh_.triangles.push_back(
          {f->vertex(0)->info().number, f->vertex(1)->info().number, f->vertex(2)->info().number});
      mesh_.warp.push_back(warp_of(f, segments_));
    }
  }

  // Follows the boundary from vertex to vertex.
  void trace_chords() {
    std::vector<int> next(mesh_.points.size(), -1);
    for (std::size_t t = 0; t < faces_.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (!faces_[t]->neighbor(k)->info().in_domain) {
          const int from = mesh_.triangles[t][(k + 1) % 3];
          if (next[from] >= 0) throw NoMesh("the chord polygon is not simple");
          next[from] = mesh_.triangles[t][(k + 2) % 3];
        }
    mesh_.chords.resize(segments_.size());
    trace_features();
    for (const Ring& ring : rings_)
      for (int i = ring.first; i < ring.first + ring.count; ++i) {
        if (segments_[i]->twin >= 0) continue;
        const int first = segments_[i]->start, last = segments_[i]->end;
        auto& chord = mesh_.chords[i];
        chord.push_back({first, 0.0});
        for (int v = next[first]; v != last; v = next[v]) {
          if (v < 0 || vertices_[v]->info().lines != std::vector<int>{line_of(i, Side::chord)})
            throw NoMesh("a chord is not covered by edges");
          chord.push_back({v, vertices_[v]->info().s});
        }
        chord.push_back({last, 1.0});
      }
  }

  // A feature's Steiner points have parameters of the side of lower number.
  void trace_features() {
    for (std::size_t v = corners_.size(); v < vertices_.size(); ++v) {
      const VertexInfo& info = vertices_[v]->info();
      if (info.lines.size() == 2 && segments_[info.lines[0] / 3]->twin == info.lines[1] / 3)
        mesh_.chords[std::min(info.lines[0], info.lines[1]) / 3].push_back(
            {static_cast<int>(v), info.s});
    }
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const WarpSegment& s = *segments_[i];
      if (s.twin < static_cast<int>(i)) continue;
      auto& chord = mesh_.chords[i];
      chord.push_back({s.start, 0.0});
      chord.push_back({s.end, 1.0});
      std::sort(chord.begin(), chord.end(),
                [](const ChordVertex& a, const ChordVertex& b) { return a.s < b.s; });
      for (std::size_t k = 0; k + 1 < chord.size(); ++k)
        if (!cdt_.is_edge(vertices_[chord[k].vertex], vertices_[chord[k + 1].vertex]))
          throw NoMesh("a feature's chord is not covered by edges");
      for (auto c = chord.rbegin(); c != chord.rend(); ++c)
        mesh_.chords[s.twin].push_back({c->vertex, 1 - c->s});
    }
  }

  void sort_triangles() {
    std::vector<std::pair<std::array<int, 3>, int>> sorted;
    for (std::size_t t = 0; t < faces_.size(); ++t) {
      auto v = mesh_.triangles[t];
      std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
      sorted.emplace_back(v, mesh_.warp[t]);
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t t = 0; t < sorted.size(); ++t)
      std::tie(mesh_.triangles[t], mesh_.warp[t]) = sorted[t];
  }

  const Thrift& thrift_;
  const Stop& stop_;
  std::vector<const WarpSegment*> segments_;
  std::vector<Ring> rings_;
  std::vector<Vertex> corners_, apexes_;  // by point; by segment
  Triangulation cdt_;
  Face hint_;
  std::vector<Vertex> vertices_;  // by number
  std::vector<Face> faces_;       // of the domain, as numbered in mesh_.triangles before sorting
  StraightMesh mesh_;
};

}  // namespace

Point chord_point(const WarpSegment& segment, double s) {
  if (segment.straight) return evaluate(segment.curve, s);
  return segment.curve.start() + s * (segment.curve.end() - segment.curve.start());
}

StraightMesh triangulate_layer(const std::vector<std::vector<WarpSegment>>& layer,
                               const Thrift& thrift, const Stop& stop) {
  return Builder(layer, thrift, stop).build();
}

}  // namespace c1mesh::meshing
