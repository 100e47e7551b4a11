// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay refinement after Chew ("Guaranteed-quality mesh generation for curved surfaces", 1993):
// a bad triangle's circumcentre is inserted unless a constraint hides it, then that constraint is
// halved. Constraints need not have empty diametral circles (as in Ruppert's method): flat warp
// triangles would have their chords halved for nothing. Circumcentres are pulled towards the
// shortest edge as far as the angle bound allows (Uengoer, "Off-centers", 2004), which saves
// points.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>

#include "base/float_traps.h"
#include "mesh/straight_cdt.h"

namespace c1mesh::meshing {
namespace {

constexpr double kClear = 0.5;  // a new vertex keeps this part of the local size from others
constexpr double kSlender =
    0.125;  // least distance that counts, in edges: thin strips cost too much
constexpr double kEncroached = -0.5;  // cosine of 120 degrees

double cosine_at(const Point& corner, const Point& a, const Point& b) {
  const Point u = a - corner, v = b - corner;
  return u.dot(v) / std::sqrt(u.squaredNorm() * v.squaredNorm());
}

bool share_line(Vertex a, Vertex b) {
  for (int line : a->info().lines)
    for (int other : b->info().lines)
      if (line == other) return true;
  return false;
}

// A bad face in the queue, worst first; stale once its vertices no longer form a face.
struct Candidate {
  double cosine;                  // of the smallest angle
  long order;                     // of insertion: breaks ties the same way in every run
  std::array<Vertex, 3> corners;  // the shortest edge first
  bool operator<(const Candidate& other) const {
    return std::tie(cosine, other.order) < std::tie(other.cosine, order);
  }
};

class Refiner {
 public:
  Refiner(Triangulation& cdt, const std::vector<const WarpSegment*>& segments, const Thrift& thrift,
          const Stop& stop)
      : cdt_(cdt), segments_(segments), thrift_(thrift), stop_(stop) {}

  void refine() {
    measure();
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) consider(f);
    // The cap is for angles where rounding keeps the refinement from ending.
    long budget = 1000 + 50 * static_cast<long>(cdt_.number_of_vertices());
    constexpr long kGlance = 256;
    while (budget > 0) {
      for (; !queue_.empty() && budget > 0; --budget) {
        if (stop_ && budget % kGlance == 0) stop_();
        const Candidate worst = queue_.top();
        queue_.pop();
        const auto face = face_of(worst.corners);
        if (face && (*face)->info().in_domain) improve(*face);
      }
      if (!separate_boundary(budget)) break;
    }
  }

 private:
  static int ccw(int k) { return Triangulation::ccw(k); }
  static int cw(int k) { return Triangulation::cw(k); }

  // The edge, with the face on the right of a -> b. Looked for around both ends by turns: one of
  // them may have thousands of faces.
  static std::optional<Triangulation::Edge> edge_between(Vertex a, Vertex b) {
    const Face start_a = a->face(), start_b = b->face();
    for (Face f = start_a, g = start_b;;) {
      const int i = f->index(a), j = g->index(b);
      if (f->vertex(cw(i)) == b) return Triangulation::Edge(f, ccw(i));
      if (g->vertex(ccw(j)) == a) return Triangulation::Edge(g, cw(j));
      f = f->neighbor(cw(i));
      g = g->neighbor(cw(j));
      if (f == start_a || g == start_b) return std::nullopt;
    }
  }

  std::optional<Face> face_of(const std::array<Vertex, 3>& corners) const {
    const auto edge = edge_between(corners[0], corners[1]);
    if (!edge) return std::nullopt;
    const auto& [f, k] = *edge;
    if (f->vertex(k) == corners[2]) return f;
    const Face other = f->neighbor(k);
    const bool found = other->vertex(cdt_.mirror_index(f, k)) == corners[2];
    return found ? std::optional(other) : std::nullopt;
  }

  // The corner with the smallest angle (opposite the shortest edge).
  static int sharpest(Face f) {
    int best = 0;
    double shortest = 0;
    for (int k = 0; k < 3; ++k) {
      const double length =
          CGAL::squared_distance(f->vertex(ccw(k))->point(), f->vertex(cw(k))->point());
      if (k == 0 || length < shortest) best = k, shortest = length;
    }
    return best;
  }

  double least_angle(Face f) const {
    return warp_of(f, segments_) >= 0 ? thrift_.least_warp_angle : thrift_.least_angle;
  }

  void consider(Face f) {
    if (cdt_.is_infinite(f) || !f->info().in_domain) return;
    const int k = sharpest(f);
    const Vertex a = f->vertex(ccw(k)), b = f->vertex(cw(k));
    const double cosine = cosine_at(point_of(f->vertex(k)), point_of(a), point_of(b));
    if (cosine <= std::cos(least_angle(f))) return;
    if (is_given(f, k)) return;
    queue_.push({cosine, ++order_, {a, b, f->vertex(k)}});
  }

  // Small angles that no refinement can mend: between two constraints, or across such an angle,
  // where splitting one constraint makes the other bad, and so on into the corner. Not so between
  // two given vertices, as the apexes of neighbouring warp triangles are: nothing was split there.
  bool is_given(Face f, int k) const {
    if (f->is_constrained(ccw(k)) && f->is_constrained(cw(k))) return true;
    const Vertex a = f->vertex(ccw(k)), b = f->vertex(cw(k));
    if (share_line(a, b) || (is_input(a) && is_input(b))) return false;
    for (int first : a->info().lines)
      for (int second : b->info().lines)
        if (meet_sharply(first, second)) return true;
    return false;
  }

  static bool is_input(Vertex v) { return v->info().number >= 0; }

  bool meet_sharply(int first, int second) const {
    for (int i : {0, 1})
      for (int j : {0, 1})
        if (ends_[first][i] == ends_[second][j])
          return cosine_at(point_of(ends_[first][i]), point_of(ends_[first][1 - i]),
                           point_of(ends_[second][1 - j])) > 0.5;
    return false;
  }

  void improve(Face f) {
    const Point target = insertion_point(f);
    const KernelPoint p(target.x(), target.y());
    const int k = sharpest(f);
    const double size = std::min(f->vertex(ccw(k))->info().size, f->vertex(cw(k))->info().size);
    const auto [at, blocked] = walk(f, p);
    if (blocked >= 0) {
      split_constraint(at, blocked, size);
      return;
    }
    Triangulation::Locate_type type;
    int index = -1;
    const Face found = cdt_.locate(p, type, index, at);
    if (type == Triangulation::EDGE && found->is_constrained(index)) {
      split_constraint(found, index, size);
    } else if (type == Triangulation::FACE || type == Triangulation::EDGE) {
      const int inside = warp_of(found, segments_);
      if (const auto edge = encroached(p, found)) {
        split_constraint(edge->first, edge->second, size);
        return;
      }
      if (!is_clear(found, target, size)) return;
      // Points on curves are rounded: a sliver beside them may be inverted, where the walk goes
      // astray.
      if (type == Triangulation::FACE && cdt_.oriented_side(found, p) != CGAL::ON_POSITIVE_SIDE)
        return;
      const Vertex v = cdt_.insert(p, type, found, index);
      v->info().inside = inside;
      v->info().size = size;
      adopt_star(v);
    }
  }

  // A constraint that p would come too near to: p sees it at 120 degrees or more.
  std::optional<Triangulation::Edge> encroached(const KernelPoint& p, Face at) const {
    std::vector<Triangulation::Edge> rim;
    cdt_.get_boundary_of_conflicts(p, std::back_inserter(rim), at);
    std::optional<Triangulation::Edge> worst;
    double least = kEncroached;
    for (const auto& [f, k] : rim) {
      if (!f->is_constrained(k)) continue;
      const double cosine =
          cosine_at(Point(p.x(), p.y()), point_of(f->vertex(ccw(k))), point_of(f->vertex(cw(k))));
      if (cosine < least) least = cosine, worst = {f, k};
    }
    return worst;
  }

  // Circumcentre or off-centre, whichever is nearer to the shortest edge.
  Point insertion_point(Face f) const {
    const int k = sharpest(f);
    const Point a = point_of(f->vertex(ccw(k))), b = point_of(f->vertex(cw(k)));
    const Point c = point_of(f->vertex(k)) - a, e = b - a;
    const double area = cross(e, c);
    const Point middle = 0.5 * (a + b);
    const double reach = 0.475 * e.norm() / std::tan(0.5 * least_angle(f));
    // Rounding may leave no area: then the circumcentre is at infinity, on the side of the sharpest
    // corner, which is acute.
    const Point flat = middle + reach * Point(-e.y(), e.x()).normalized();
    if (!(area > 0)) return flat;
    const Point centre(c.y() * e.squaredNorm() - e.y() * c.squaredNorm(),
                       e.x() * c.squaredNorm() - c.x() * e.squaredNorm());
    const FloatTrapsOff nearly_flat;  // the same for next to none
    const Point circumcentre = a + centre / (2 * area);
    const Point away = circumcentre - middle;
    const double distance = away.norm();
    if (!std::isfinite(distance)) return flat;
    return distance > reach ? Point(middle + reach / distance * away) : circumcentre;
  }

  // Straight walk from the face's centroid to p: the face reached and -1, or the face and the index
  // of the constrained edge that hides p.
  std::pair<Face, int> walk(Face f, const KernelPoint& p) const {
    const KernelPoint from = CGAL::centroid(cdt_.triangle(f));
    // Where rounding puts the centroid of a sliver beside it the walk may go in circles: no more
    // than all faces are on a straight line.
    std::size_t left = cdt_.tds().faces().size();
    for (Face previous = f; left > 0; --left) {
      int exit = -1;
      for (int k = 0; k < 3 && exit < 0; ++k) {
        if (f->neighbor(k) == previous && previous != f) continue;
        const KernelPoint &u = f->vertex(ccw(k))->point(), &w = f->vertex(cw(k))->point();
        if (CGAL::orientation(u, w, p) == CGAL::RIGHT_TURN &&
            CGAL::orientation(from, u, p) != CGAL::RIGHT_TURN &&
            CGAL::orientation(from, w, p) != CGAL::LEFT_TURN)
          exit = k;
      }
      if (exit < 0) return {f, -1};
      if (f->is_constrained(exit)) return {f, exit};
      previous = f;
      f = f->neighbor(exit);
    }
    return {f, -1};
  }

  void split_constraint(Face f, int k, double size) {
    const Vertex a = f->vertex(ccw(k)), b = f->vertex(cw(k));
    int line = -1;
    for (int l : a->info().lines)
      if (std::count(b->info().lines.begin(), b->info().lines.end(), l)) line = l;
    const int other_side = is_chord(line) ? segments_[line / 3]->twin : -1;
    if (other_side >= 0) line = line_of(std::min(line / 3, other_side), Side::chord);
    const auto [p, s] = middle_of(line, a, b);
    if (!is_clear(f, p, size) || !is_clear(f->neighbor(k), p, size)) return;
    const Vertex v = cdt_.insert(KernelPoint(p.x(), p.y()), Triangulation::EDGE, f, k);
    v->info().lines = {line};
    v->info().s = s;
    v->info().size = size;
    if (other_side >= 0) v->info().lines.push_back(line_of(segments_[line / 3]->twin, Side::chord));
    if (!is_chord(line) || other_side >= 0)
      adopt_star(v);
    else if (s_on(a, line) < s_on(b, line))
      adopt_half_star(v, a, b);
    else
      adopt_half_star(v, b, a);
  }

  static bool is_chord(int line) { return line % 3 == static_cast<int>(Side::chord); }

  // The size of an input vertex is its shortest edge before refinement.
  void measure() {
    ends_.resize(3 * segments_.size());
    for (auto v = cdt_.finite_vertices_begin(); v != cdt_.finite_vertices_end(); ++v) {
      v->info().size = std::numeric_limits<double>::infinity();
      for (int line : v->info().lines) ends_[line][ends_[line][0] == Vertex() ? 0 : 1] = v;
    }
    for (auto e = cdt_.finite_edges_begin(); e != cdt_.finite_edges_end(); ++e) {
      const Vertex a = e->first->vertex(ccw(e->second)), b = e->first->vertex(cw(e->second));
      const double length = (point_of(a) - point_of(b)).norm();
      for (Vertex v : {a, b}) v->info().size = std::min(v->info().size, length);
    }
    // So is a constraint that passes by, as across a strip narrower than its shortest edge.
    std::vector<std::pair<Vertex, double>> passed;
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f)
      for (int k = 0; k < 3; ++k)
        if (f->info().in_domain && f->is_constrained(k) && warp_of(f, segments_) < 0)
          if (const auto height = height_over(f, k)) passed.emplace_back(f->vertex(k), *height);
    for (const auto& [v, height] : passed) {
      double& size = v->info().size;
      size = std::min(size, std::max(height, kSlender * size));
    }
  }

  // The distance of corner k from the opposite edge, if its foot lies there. None between
  // neighbours (lines that meet at one of the edge's ends): they are as near as their angle has it.
  std::optional<double> height_over(Face f, int k) const {
    const Vertex v = f->vertex(k);
    const Point a = point_of(f->vertex(ccw(k))), e = point_of(f->vertex(cw(k))) - a;
    const Point d = point_of(v) - a;
    const double along = d.dot(e) / e.squaredNorm();
    if (along <= 0 || along >= 1) return std::nullopt;
    for (int line : v->info().lines)
      for (const Vertex end : {f->vertex(ccw(k)), f->vertex(cw(k))})
        if (std::count(end->info().lines.begin(), end->info().lines.end(), line))
          return std::nullopt;
    return cross(e, d) / e.norm();
  }

  // Would a point in the face keep its distance? Sizes are inherited from the edge that is mended,
  // so no chain of insertions can shrink the mesh below half of where it began: refinement ends.
  bool is_clear(Face f, const Point& p, double size) const {
    for (int k = 0; k < 3; ++k)
      if (!cdt_.is_infinite(f->vertex(k)) && (point_of(f->vertex(k)) - p).norm() < kClear * size)
        return false;
    return true;
  }

  // Only Steiner points have no number yet.
  double s_on(Vertex v, int line) const {
    if (v->info().number < 0) return v->info().s;
    return v->info().number == segments_[line / 3]->start ? 0 : 1;
  }

  // On chords the middle in s, which stays dyadic; straight segments' points lie on the curve.
  std::pair<Point, double> middle_of(int line, Vertex a, Vertex b) const {
    if (!is_chord(line)) return {0.5 * (point_of(a) + point_of(b)), 0};
    const double s = 0.5 * (s_on(a, line) + s_on(b, line));
    return {chord_point(*segments_[line / 3], s), s};
  }

  // Faces around a new vertex of the domain lie in the domain.
  void adopt_star(Vertex v) {
    auto f = cdt_.incident_faces(v), end = f;
    do f->info().in_domain = true;
    while (++f != end);
    do consider(f);
    while (++f != end);
  }

  // Around a new chord vertex, the domain lies on the left of start -> v -> end: the faces that are
  // met from end to start, counter-clockwise. By edges, not by orientation: beside rounded points
  // slivers may be inverted.
  void adopt_half_star(Vertex v, Vertex start, Vertex end) {
    const auto first = cdt_.incident_faces(v);
    auto f = first;
    do f->info().in_domain = false;
    while (++f != first);
    while (f->vertex(ccw(f->index(v))) != end) ++f;
    for (bool left = true; left; ++f) {
      f->info().in_domain = true;
      left = f->vertex(cw(f->index(v))) != start;
    }
    f = first;
    do consider(f);
    while (++f != first);
  }

  bool on_boundary(Vertex v) const {
    return std::any_of(v->info().lines.begin(), v->info().lines.end(), is_chord);
  }

  // An unconstrained edge between two vertices of boundary or features would have to be split later
  // (see guard.h): better now, while Delaunay flips can make the most of the new vertex. False if
  // there was none.
  bool separate_boundary(long& budget) {
    // By faces: the library's edge iterator goes by addresses, which differ from run to run. Each
    // edge is met from both sides; the second time it is gone.
    std::vector<std::pair<Vertex, Vertex>> joining;
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f)
      for (int k = 0; k < 3; ++k) {
        const Vertex a = f->vertex(ccw(k)), b = f->vertex(cw(k));
        if (f->info().in_domain && !f->is_constrained(k) && on_boundary(a) && on_boundary(b))
          joining.emplace_back(a, b);
      }
    bool any = false;
    for (const auto& [a, b] : joining) {
      const auto edge = edge_between(a, b);
      if (!edge) continue;
      const auto& [f, k] = *edge;
      // Flips of inverted slivers outside may have joined two vertices once more.
      if (!f->info().in_domain || f->is_constrained(k)) continue;
      --budget;
      const Point middle = 0.5 * (point_of(a) + point_of(b));
      const int inside = warp_of(f, segments_);
      const Vertex v = cdt_.insert(KernelPoint(middle.x(), middle.y()), Triangulation::EDGE, f, k);
      v->info().inside = inside;
      v->info().size = std::min(a->info().size, b->info().size);
      adopt_star(v);
      any = true;
    }
    return any;
  }

  Triangulation& cdt_;
  const std::vector<const WarpSegment*>& segments_;
  const Thrift& thrift_;
  const Stop& stop_;
  std::priority_queue<Candidate> queue_;
  long order_ = 0;
  std::vector<std::array<Vertex, 2>> ends_;  // per line
};

}  // namespace

int warp_of(Face face, const std::vector<const WarpSegment*>& segments) {
  const auto contains = [&](Vertex v, int warp) {
    const VertexInfo& info = v->info();
    return info.inside == warp || std::any_of(info.lines.begin(), info.lines.end(),
                                              [&](int line) { return line / 3 == warp; });
  };
  const auto in_all = [&](int warp) {
    return warp >= 0 && !segments[warp]->straight && contains(face->vertex(1), warp) &&
           contains(face->vertex(2), warp);
  };
  const VertexInfo& info = face->vertex(0)->info();
  if (in_all(info.inside)) return info.inside;
  for (int line : info.lines)
    if (in_all(line / 3)) return line / 3;
  return -1;
}

void refine_delaunay(Triangulation& cdt, const std::vector<const WarpSegment*>& segments,
                     const Thrift& thrift, const Stop& stop) {
  Refiner(cdt, segments, thrift, stop).refine();
}

}  // namespace c1mesh::meshing
