// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/faces.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace c1mesh::verification {
namespace {

using Arrow = std::pair<int, int>;

/// All directed edges that run along boundary or features with a triangle on their left.
std::set<Arrow> arrows_of(const Subject& subject) {
  std::set<Arrow> arrows;
  const auto add = [&](int a, int b) {
    const int id = subject.surface.find_edge(a, b);
    if (id >= 0 && subject.surface.edges[id].side[a < b ? 0 : 1].present()) arrows.emplace(a, b);
  };
  for (const auto* edges : {&subject.result.boundary_edges, &subject.result.feature_edges})
    for (const CurveEdge& e : *edges) {
      add(e.a, e.b);
      add(e.b, e.a);
    }
  return arrows;
}

/// Turns around the arrow's head through the triangles on its left until the next arrow. Nothing if
/// it comes to an edge of the surface before that: a boundary that the file does not tell.
std::optional<Arrow> next_arrow(const Subject& subject, const std::set<Arrow>& arrows,
                                const Arrow& at) {
  Arrow spoke = at;
  for (std::size_t left = subject.result.triangles.size(); left > 0; --left) {
    const int id = subject.surface.find_edge(spoke.first, spoke.second);
    if (id < 0) return std::nullopt;
    const Side& side = subject.surface.edges[id].side[spoke.first < spoke.second ? 0 : 1];
    if (!side.present()) return std::nullopt;
    const int third = subject.result.triangles[side.triangle][(side.corner + 2) % 3];
    if (arrows.count({at.second, third})) return Arrow{at.second, third};
    spoke = {third, at.second};
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::vector<int>> face_cycles(const Subject& subject) {
  std::vector<std::vector<int>> cycles;
  if (!subject.surface.faults.empty()) return cycles;
  const std::set<Arrow> arrows = arrows_of(subject);
  std::set<Arrow> walked;
  for (const Arrow& first : arrows) {
    std::vector<int> trail;    // vertices since the walk was last at each of them
    std::map<int, int> place;  // in it
    for (Arrow at = first; walked.insert(at).second;) {
      place[at.first] = static_cast<int>(trail.size());
      trail.push_back(at.first);
      const auto back = place.find(at.second);
      if (back != place.end()) {
        const auto from = trail.begin() + back->second;
        if (trail.end() - from > 2) cycles.emplace_back(from, trail.end());
        for (auto v = from; v != trail.end(); ++v) place.erase(*v);
        trail.erase(from, trail.end());
      }
      const std::optional<Arrow> next = next_arrow(subject, arrows, at);
      if (!next) return {};
      at = *next;
    }
  }
  return cycles;
}

std::vector<int> branch_points(const Subject& subject) {
  std::map<int, int> ends;
  for (const auto* edges : {&subject.result.boundary_edges, &subject.result.feature_edges})
    for (const CurveEdge& e : *edges) ++ends[e.a], ++ends[e.b];
  std::vector<int> out;
  for (const auto& [vertex, count] : ends)
    if (count > 2) out.push_back(vertex);
  return out;
}

}  // namespace c1mesh::verification
