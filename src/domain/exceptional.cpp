// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/exceptional.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "c1mesh/cost.h"
#include "domain/cycles.h"
#include "domain/window_sums.h"

namespace c1mesh {
namespace {

// A loop's boundary by length: where each vertex lies and how much the boundary turns around it.
struct LoopProfile {
  double length = 0;
  std::vector<double> at;    // arc length (of chords) of each vertex
  std::vector<double> bend;  // turning towards the wanted side within a window
};

LoopProfile profile_of(const CurvedMesh& mesh, const std::vector<int>& vertices, double side,
                       double window_share) {
  LoopProfile out;
  const int m = static_cast<int>(vertices.size());
  std::vector<double> turn(m);
  for (int k = 0; k < m; ++k) {
    const Point& p = mesh.control[vertices[k]];
    const Point ahead = mesh.control[vertices[(k + 1) % m]] - p;
    const Point behind = p - mesh.control[vertices[(k + m - 1) % m]];
    out.at.push_back(out.length);
    out.length += ahead.norm();
    turn[k] = side * std::atan2(cross(behind, ahead), behind.dot(ahead));
  }
  out.bend = window_sums(out.at, turn, out.at, out.length * window_share, out.length);
  return out;
}

double distance(const LoopProfile& profile, int a, int b) {
  const double d = std::abs(profile.at[a] - profile.at[b]);
  return std::min(d, profile.length - d);
}

bool is_wanted_corner(const Joint& joint, Role role) {
  if (role == Role::exceptional) return true;
  if (role == Role::branch && joint.kind != JointKind::corner) return true;
  if (role == Role::released || role == Role::branch)
    return joint.kind == JointKind::corner && joint.convex() == (joint.loop == 0);
  return role == Role::anchor && joint.kind == JointKind::corner &&
         joint.convex() == (joint.loop == 0);
}

// Chain ends of the wanted kind already there, and corners of the other kind to stay away from.
std::vector<int> taken_places(const std::vector<Joint>& joints, const std::vector<Role>& roles,
                              bool wanted) {
  std::vector<int> out;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (ends_chain(roles[k]) && is_wanted_corner(joints[k], roles[k]) == wanted)
      out.push_back(static_cast<int>(k));
  }
  return out;
}

bool is_free(Role role) {
  return role == Role::flat || role == Role::bent;
}

// Positions of `missing` more chain ends among the `free` ones. `taken`, increasing: chain ends of
// the wanted kind already there; `reflex`: those to stay away from.
std::vector<int> choose_by_curvature(const LoopProfile& profile, std::vector<char> free,
                                     std::vector<int> taken, const std::vector<int>& reflex,
                                     int missing) {
  constexpr std::size_t kFew = 4'000'000;
  // Of few, one by one: see window_sums.
  const bool few = reflex.size() * free.size() <= kFew;
  std::vector<double> crowded;
  if (!few) {
    std::vector<double> places;
    for (int other : reflex) places.push_back(profile.at[other]);
    crowded = window_sums(places, std::vector<double>(places.size(), 2), profile.at,
                          profile.length / 12, profile.length);
  }
  std::vector<int> chosen;
  for (; missing > 0; --missing) {
    int best = -1;
    double best_score = -1e300;
    for (int k = 0; k < static_cast<int>(free.size()); ++k) {
      if (!free[k]) continue;
      double score = profile.bend[k];
      // Spacing: chain ends closer than a sixth of the loop cost a full turn, falling linearly.
      for (int other : taken)
        score -= 6 * std::max(0.0, 1 - 6 * distance(profile, k, other) / profile.length);
      if (few)
        for (int other : reflex)
          score -= 2 * std::max(0.0, 1 - 12 * distance(profile, k, other) / profile.length);
      else
        score -= crowded[k];
      if (score > best_score) {
        best_score = score;
        best = k;
      }
    }
    if (best < 0) break;
    free[best] = 0;
    taken.insert(std::upper_bound(taken.begin(), taken.end(), best), best);
    chosen.push_back(best);
  }
  return chosen;
}

std::vector<int> choose_evenly(const LoopProfile& profile, std::vector<char> free, int missing,
                               double offset) {
  std::vector<int> chosen;
  const int start = static_cast<int>(std::max_element(profile.bend.begin(), profile.bend.end()) -
                                     profile.bend.begin());
  for (int c = 0; c < missing; ++c) {
    const double goal =
        std::fmod(profile.at[start] + (c + offset) * profile.length / missing, profile.length);
    int best = -1;
    double best_distance = 1e300;
    for (int k = 0; k < static_cast<int>(free.size()); ++k) {
      if (!free[k]) continue;
      double d = std::abs(profile.at[k] - goal);
      d = std::min(d, profile.length - d);
      if (d < best_distance) {
        best_distance = d;
        best = k;
      }
    }
    if (best < 0) break;
    free[best] = 0;
    chosen.push_back(best);
  }
  return chosen;
}

// `side`: +1 where corners to the left are missing, -1 to the right.
std::vector<int> choose(const CurvedMesh& mesh, const std::vector<int>& vertices, double side,
                        const std::vector<char>& free, const std::vector<int>& taken,
                        const std::vector<int>& reflex, int missing, Placement placement) {
  const LoopProfile profile =
      profile_of(mesh, vertices, side, placement == Placement::tips ? 0.02 : 1.0 / 12);
  if (placement == Placement::curvature || placement == Placement::tips)
    return choose_by_curvature(profile, free, taken, reflex, missing);
  return choose_evenly(profile, free, missing, placement == Placement::spread ? 0.0 : 0.5);
}

// Turns of the polygon's corners along a cycle (see face_cycles). The corners placed on features
// turn as the cycle for which they were placed wanted: (path, position) -> +1 left, -1 right.
class CycleCorners {
 public:
  explicit CycleCorners(const Joints& joints) : joints_(joints) {}

  static int side(const Cycle& cycle) { return cycle.inside ? 1 : -1; }
  const Joint& joint(const CycleStop& stop) const { return joints_[stop.path][stop.position]; }

  // +1: a corner of the kind that the cycle needs; -1: of the other kind; 0: none.
  int kind(const Cycle& cycle, const CycleStop& stop, const Roles& roles) const {
    const Joint& at = joint(stop);
    if (at.branch) return 1;
    const Role role = roles[stop.path][stop.position];
    int turn = 0;
    if (role == Role::exceptional)
      turn = at.feature ? placed_.at({stop.path, stop.position}) : at.loop == 0 ? 1 : -1;
    else if (ends_chain(role) && at.kind == JointKind::corner)
      turn = at.convex() ? 1 : -1;
    return turn * (stop.forward ? 1 : -1) * side(cycle);
  }

  // A loop's vertices turn to the side that their own polygon needs.
  bool may_take(const Cycle& cycle, const CycleStop& stop, const Roles& roles) const {
    const Joint& at = joint(stop);
    return is_free(roles[stop.path][stop.position]) &&
           (at.feature || cycle.inside == (at.loop == 0));
  }

  void place(const Cycle& cycle, const CycleStop& stop, Roles& roles) {
    roles[stop.path][stop.position] = Role::exceptional;
    placed_[{stop.path, stop.position}] = (stop.forward ? 1 : -1) * side(cycle);
  }

 private:
  const Joints& joints_;
  std::map<std::pair<int, int>, int> placed_;
};

// Places what the polygons of faces lack. A place on a loop or outer side of features that lacks
// corners too serves both.
class CyclePlacer {
 public:
  CyclePlacer(const CurvedMesh& mesh, const Joints& joints, Placement placement)
      : mesh_(mesh),
        joints_(joints),
        placement_(placement),
        cycles_(face_cycles(mesh)),
        corners_(joints) {}

  void place_inside(Roles& roles) {
    count_rims(roles);
    for (const Cycle& cycle : cycles_)
      if (cycle.inside) place(cycle, roles);
  }

  void place_all(Roles& roles) {
    count_rims(roles);
    for (const Cycle& cycle : cycles_) place(cycle, roles);
  }

 private:
  int missing(const Cycle& cycle, const Roles& roles) const {
    int have = 0;
    for (const CycleStop& stop : cycle.stops) have += corners_.kind(cycle, stop, roles) > 0;
    return 3 - have;
  }

  // The rims are the outer loop and the cycles around several faces: what each lacks, and which run
  // through a vertex. They are counted once and kept up to date, for one of them may touch all
  // faces.
  struct RimStop {
    int rim;
    const CycleStop* stop;  // null on the outer loop
  };

  void count_rims(const Roles& roles) {
    lacks_.assign(1, missing_corners(joints_, roles, 0));
    rims_at_.clear();
    for (const Joint& joint : joints_[0]) rims_at_[joint.vertex].push_back({0, nullptr});
    for (const Cycle& cycle : cycles_) {
      if (cycle.inside) continue;
      for (const CycleStop& stop : cycle.stops)
        rims_at_[stop.vertex].push_back({static_cast<int>(lacks_.size()), &stop});
      lacks_.push_back(missing(cycle, roles));
      rim_cycles_.resize(lacks_.size(), nullptr);
      rim_cycles_.back() = &cycle;
    }
  }

  bool on_lacking_rim(int vertex) const {
    const auto found = rims_at_.find(vertex);
    return found != rims_at_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](const RimStop& at) { return lacks_[at.rim] > 0; });
  }

  // An exceptional vertex was placed, where before no chain ended.
  void update_rims(const CycleStop& placed, const Roles& roles) {
    for (const RimStop& at : rims_at_[placed.vertex]) {
      if (!at.stop) {
        if (placed.path == 0) --lacks_[0];
      } else if (at.stop->path == placed.path && at.stop->position == placed.position) {
        lacks_[at.rim] -= corners_.kind(*rim_cycles_[at.rim], *at.stop, roles) > 0;
      }
    }
  }

  void place(const Cycle& cycle, Roles& roles) {
    for (int rest = missing(cycle, roles); rest > 0; rest = missing(cycle, roles)) {
      std::vector<int> vertices, taken, reflex;
      std::vector<char> free, serving;
      for (std::size_t k = 0; k < cycle.stops.size(); ++k) {
        const CycleStop& stop = cycle.stops[k];
        vertices.push_back(stop.vertex);
        free.push_back(corners_.may_take(cycle, stop, roles));
        serving.push_back(free.back() && on_lacking_rim(stop.vertex));
        const int kind = corners_.kind(cycle, stop, roles);
        if (kind > 0) taken.push_back(static_cast<int>(k));
        if (kind < 0) reflex.push_back(static_cast<int>(k));
      }
      const bool serves = std::count(serving.begin(), serving.end(), 1) >= rest;
      const std::vector<int> chosen =
          choose(mesh_, vertices, CycleCorners::side(cycle), serves ? serving : free, taken, reflex,
                 rest, placement_);
      if (chosen.empty()) return;
      for (const int k : chosen) {
        corners_.place(cycle, cycle.stops[k], roles);
        update_rims(cycle.stops[k], roles);
      }
    }
  }

  const CurvedMesh& mesh_;
  const Joints& joints_;
  Placement placement_;
  std::vector<Cycle> cycles_;
  CycleCorners corners_;
  std::vector<int> lacks_;                // per rim
  std::vector<const Cycle*> rim_cycles_;  // null: the outer loop
  std::map<int, std::vector<RimStop>> rims_at_;
};

}  // namespace

int missing_corners(const Joints& joints, const Roles& roles, int loop) {
  int have = 0;
  for (std::size_t k = 0; k < joints[loop].size(); ++k) {
    const Role role = roles[loop][k];
    if (ends_chain(role) && is_wanted_corner(joints[loop][k], role)) ++have;
  }
  return std::max(0, 3 - have);
}

Roles place_exceptional(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                        Placement placement) {
  const StageTimer timer("map: placement");
  Roles out = roles;
  std::optional<CyclePlacer> cycles;
  if (!mesh.features.empty()) cycles.emplace(mesh, joints, placement).place_inside(out);
  for (std::size_t l = 0; l < mesh.loops.size(); ++l) {
    const int missing = missing_corners(joints, out, static_cast<int>(l));
    if (missing == 0) continue;
    std::vector<int> vertices;
    std::vector<char> free;
    for (std::size_t k = 0; k < joints[l].size(); ++k) {
      vertices.push_back(joints[l][k].vertex);
      free.push_back(is_free(out[l][k]));
    }
    for (const int k :
         choose(mesh, vertices, l == 0 ? 1.0 : -1.0, free, taken_places(joints[l], out[l], true),
                taken_places(joints[l], out[l], false), missing, placement))
      out[l][k] = Role::exceptional;
  }
  if (cycles) cycles->place_all(out);
  return out;
}

std::vector<Roles> one_more(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                            int count) {
  const StageTimer timer("map: placement");
  constexpr double kApart = 1.0 / 24;  // of the loop's length
  struct Candidate {
    int loop, position;
    Role role;
    double bend;
  };
  std::vector<Candidate> wanted;
  for (std::size_t l = 0; l < mesh.loops.size(); ++l) {
    const double outer = l == 0 ? 1 : -1;
    std::vector<int> vertices;
    for (const Joint& joint : joints[l]) vertices.push_back(joint.vertex);
    for (const double side : {outer, -outer}) {
      const LoopProfile profile = profile_of(mesh, vertices, side, kApart);
      std::set<int> taken;
      const int m = static_cast<int>(joints[l].size());
      for (int k = 0; k < m; ++k)
        if (ends_chain(roles[l][k])) taken.insert(k);
      // The nearest of them along the loop are the next before and after.
      const auto is_clear = [&](int k) {
        if (taken.empty()) return true;
        const auto after = taken.lower_bound(k);
        const int ahead = after == taken.end() ? *taken.begin() : *after;
        const int behind = after == taken.begin() ? *taken.rbegin() : *std::prev(after);
        return !(distance(profile, k, ahead) < kApart * profile.length ||
                 distance(profile, k, behind) < kApart * profile.length);
      };
      for (int found = 0; found < count; ++found) {
        int best = -1;
        for (int k = 0; k < m; ++k) {
          if (ends_chain(roles[l][k]) || profile.bend[k] <= 0) continue;
          if (best >= 0 && !(profile.bend[k] > profile.bend[best])) continue;
          if (is_clear(k)) best = k;
        }
        if (best < 0) break;
        taken.insert(best);
        wanted.push_back({static_cast<int>(l), best,
                          side == outer ? Role::exceptional : Role::released, profile.bend[best]});
      }
    }
  }
  // Each costs whoever asks a domain stage: of many loops' the strongest bends are worth it.
  constexpr std::size_t kMost = 64;
  if (wanted.size() > kMost) {
    std::stable_sort(wanted.begin(), wanted.end(),
                     [](const Candidate& x, const Candidate& y) { return x.bend > y.bend; });
    wanted.resize(kMost);
  }
  std::vector<Roles> out;
  for (const Candidate& place : wanted) {
    out.push_back(roles);
    out.back()[place.loop][place.position] = place.role;
  }
  return out;
}

int count_exceptional(const Roles& roles) {
  int count = 0;
  for (const auto& loop : roles)
    count += static_cast<int>(std::count_if(loop.begin(), loop.end(), gives_up_c1));
  return count;
}

int minimum_exceptional(const CurvedMesh& mesh, const Joints& joints) {
  // What a polygon lacks at least, and where it runs.
  struct Demand {
    int missing;
    std::set<int> vertices;
  };
  std::set<int> branches;
  for (const auto& path : joints)
    for (const Joint& joint : path)
      if (joint.branch) branches.insert(joint.vertex);
  // Vertices that serve one of these do not serve another.
  std::vector<Demand> apart;
  std::vector<Demand> rims;
  for (std::size_t l = 0; l < mesh.loops.size(); ++l) {
    Demand demand{3, {}};
    for (const Joint& joint : joints[l]) {
      demand.vertices.insert(joint.vertex);
      if (joint.branch || (joint.kind == JointKind::corner && joint.convex() == (l == 0)))
        --demand.missing;
    }
    (l == 0 ? rims : apart).push_back(demand);
  }
  const CycleCorners corners(joints);
  const Roles roles = natural_roles(joints);
  for (const Cycle& cycle : face_cycles(mesh)) {
    Demand demand{3, {}};
    for (const CycleStop& stop : cycle.stops) {
      demand.vertices.insert(stop.vertex);
      if (corners.kind(cycle, stop, roles) > 0) --demand.missing;
    }
    (cycle.inside ? apart : rims).push_back(demand);
  }
  int count = static_cast<int>(branches.size());
  for (const Demand& demand : apart) count += std::max(0, demand.missing);
  std::map<int, std::vector<int>> demands_at;  // vertex -> of `apart`
  for (std::size_t k = 0; k < apart.size(); ++k)
    for (const int v : apart[k].vertices) demands_at[v].push_back(static_cast<int>(k));
  for (const Demand& rim : rims) {
    std::set<int> touched;
    for (const int v : rim.vertices)
      if (const auto found = demands_at.find(v); found != demands_at.end())
        touched.insert(found->second.begin(), found->second.end());
    int served = 0;
    for (const int k : touched) served += std::max(0, apart[k].missing);
    count += std::max(0, rim.missing - served);
  }
  return count;
}

}  // namespace c1mesh
