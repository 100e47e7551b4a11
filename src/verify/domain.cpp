// SPDX-License-Identifier: GPL-3.0-or-later
// The domain: triangles oriented, fans wound once, and whether pieces of it overlap in the plane.
#include <algorithm>
#include <map>

#include "verify/boxes.h"
#include "verify/checks.h"
#include "verify/curve_pairs.h"
#include "verify/exact.h"

namespace c1mesh::verification {
namespace {

/// How often the edge from a to b passes the ray from p to the right, upwards less downwards, where
/// (p, a, b) is counter-clockwise: an edge that goes up is on the right of p then, one that goes
/// down on its left, so comparisons of coordinates are all it takes.
int passes(const Point& p, const Point& a, const Point& b) {
  return a.y() <= p.y() && p.y() < b.y() ? 1 : 0;
}

/// Interior vertices whose triangles do not go around exactly once, counted exactly.
/// Precondition: the triangles are counter-clockwise.
std::vector<int> vertices_wound_wrongly(const Subject& subject) {
  std::vector<int> wrong;
  const Surface& surface = subject.surface;
  const auto& domain = subject.result.domain_vertices;
  for (int v = 0; v < static_cast<int>(surface.vertex_triangles.size()); ++v) {
    if (surface.on_boundary[v] || surface.vertex_triangles[v].empty()) continue;
    int turns = 0;
    for (const int t : surface.vertex_triangles[v]) {
      const auto& corner = subject.result.triangles[t];
      const int k = static_cast<int>(std::find(corner.begin(), corner.end(), v) - corner.begin());
      turns += passes(domain[v], domain[corner[(k + 1) % 3]], domain[corner[(k + 2) % 3]]);
    }
    if (turns != 1) wrong.push_back(v);
  }
  return wrong;
}

struct Segment {
  int a, b;
};

bool overlap(const Result& result, const Segment& s, const Segment& r) {
  const auto at = [&](int v) -> const Point& { return result.domain_vertices[v]; };
  if (s.a == r.b && s.b == r.a) return true;
  if (s.b == r.a) return spokes_overlap(at(s.b), at(s.a), at(r.b));
  if (s.a == r.b) return spokes_overlap(at(s.a), at(s.b), at(r.a));
  return segments_meet(at(s.a), at(s.b), at(r.a), at(r.b));
}

bool boundary_meets_itself(const Subject& subject) {
  const Result& result = subject.result;
  std::vector<Segment> segments;
  std::vector<Box> boxes;
  for (const auto& loop : subject.surface.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
      boxes.push_back(box_of(
          {result.domain_vertices[segments.back().a], result.domain_vertices[segments.back().b]}));
    }
  for (const auto& [i, j] : meeting_pairs(boxes))
    if (overlap(result, segments[i], segments[j])) return true;
  return false;
}

/// Boundaries that do not meet: does one piece lie inside another, or wind more than once?
bool pieces_overlap(const Subject& subject) {
  const Surface& surface = subject.surface;
  std::vector<std::vector<std::vector<Point>>> loops;
  std::vector<int> counter_clockwise(surface.components, 0);
  for (std::size_t l = 0; l < surface.loops.size(); ++l) {
    const auto& loop = surface.loops[l];
    loops.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i)
      loops.back().push_back({subject.result.domain_vertices[loop[i]],
                              subject.result.domain_vertices[loop[(i + 1) % loop.size()]]});
    if (area_sign(loops.back()) > 0) ++counter_clockwise[surface.loop_component[l]];
  }
  for (const int count : counter_clockwise)
    if (count != 1) return true;
  std::vector<Point> starts;
  std::vector<Box> boxes;
  for (const auto& loop : loops) {
    starts.push_back(loop[0][0]);
    std::vector<Point> corners;
    for (const auto& edge : loop) corners.push_back(edge[0]);
    boxes.push_back(box_of(corners));
  }
  // Outside its box a loop winds zero times.
  std::map<std::pair<int, int>, int> number;  // (loop, other piece)
  for (const auto& [l, m] : containing_pairs(starts, boxes)) {
    const int other = surface.loop_component[m];
    if (surface.loop_component[l] != other)
      number[{l, other}] +=
          winding_around(loops[m], starts[l], subject.options.max_subdivision).number;
  }
  return std::any_of(number.begin(), number.end(), [](const auto& n) { return n.second != 0; });
}

}  // namespace

VerifyItem check_domain_orientation(const Subject& subject) {
  std::vector<int> wrong;
  for (int t = 0; t < static_cast<int>(subject.result.triangles.size()); ++t) {
    const auto& v = subject.result.triangles[t];
    const auto at = [&](int k) -> const Point& { return subject.result.domain_vertices[v[k]]; };
    if (orientation(at(0), at(1), at(2)) <= 0) wrong.push_back(t);
  }
  if (wrong.empty())
    return {"domain orientation", Verdict::valid,
            "every domain triangle is counter-clockwise, exactly"};
  return {"domain orientation", Verdict::invalid,
          fmt::format("{} triangles are not counter-clockwise: {}", wrong.size(), id_text(wrong))};
}

VerifyItem check_winding(const Subject& subject) {
  const std::vector<int> wrong = vertices_wound_wrongly(subject);
  if (wrong.empty()) return {"winding", Verdict::valid, "every interior vertex is wound once"};
  return {"winding", Verdict::invalid,
          fmt::format("{} interior vertices are not wound once: {}", wrong.size(), id_text(wrong))};
}

bool domain_overlaps(const Subject& subject) {
  return !vertices_wound_wrongly(subject).empty() || boundary_meets_itself(subject) ||
         pieces_overlap(subject);
}

}  // namespace c1mesh::verification
