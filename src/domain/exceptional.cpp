// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/exceptional.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace c1mesh {
namespace {

// A loop's boundary by length: where each vertex lies and how much the boundary turns around it.
struct LoopProfile {
  double length = 0;
  std::vector<double> at;    // arc length (of chords) of each vertex
  std::vector<double> bend;  // turning towards the wanted side within a window
};

LoopProfile profile_of(const CurvedMesh& mesh, const std::vector<Joint>& joints, double side,
                       double window_share) {
  LoopProfile out;
  const int m = static_cast<int>(joints.size());
  std::vector<double> turn(m);
  for (int k = 0; k < m; ++k) {
    const Point& p = mesh.control[joints[k].vertex];
    const Point ahead = mesh.control[joints[(k + 1) % m].vertex] - p;
    const Point behind = p - mesh.control[joints[(k + m - 1) % m].vertex];
    out.at.push_back(out.length);
    out.length += ahead.norm();
    turn[k] = side * std::atan2(cross(behind, ahead), behind.dot(ahead));
  }
  // Triangular window on either side.
  const double window = out.length * window_share;
  for (int k = 0; k < m; ++k) {
    double sum = 0;
    for (int j = 0; j < m; ++j) {
      double distance = std::abs(out.at[j] - out.at[k]);
      distance = std::min(distance, out.length - distance);
      sum += std::max(0.0, 1 - distance / window) * turn[j];
    }
    out.bend.push_back(sum);
  }
  return out;
}

double distance(const LoopProfile& profile, int a, int b) {
  const double d = std::abs(profile.at[a] - profile.at[b]);
  return std::min(d, profile.length - d);
}

bool is_wanted_corner(const Joint& joint, Role role) {
  if (role == Role::exceptional) return true;
  if (role == Role::released)
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

void place_by_curvature(const LoopProfile& profile, const std::vector<Joint>& joints, int missing,
                        std::vector<Role>& roles) {
  const int m = static_cast<int>(joints.size());
  const std::vector<int> reflex = taken_places(joints, roles, false);
  for (; missing > 0; --missing) {
    const std::vector<int> taken = taken_places(joints, roles, true);
    int best = -1;
    double best_score = -1e300;
    for (int k = 0; k < m; ++k) {
      if (roles[k] != Role::flat && roles[k] != Role::bent) continue;
      double score = profile.bend[k];
      // Spacing: chain ends closer than a sixth of the loop cost a full turn, falling linearly.
      for (int other : taken)
        score -= 6 * std::max(0.0, 1 - 6 * distance(profile, k, other) / profile.length);
      for (int other : reflex)
        score -= 2 * std::max(0.0, 1 - 12 * distance(profile, k, other) / profile.length);
      if (score > best_score) {
        best_score = score;
        best = k;
      }
    }
    if (best < 0) return;
    roles[best] = Role::exceptional;
  }
}

void place_evenly(const LoopProfile& profile, const std::vector<Joint>& joints, int missing,
                  double offset, std::vector<Role>& roles) {
  const int m = static_cast<int>(joints.size());
  const int start = static_cast<int>(std::max_element(profile.bend.begin(), profile.bend.end()) -
                                     profile.bend.begin());
  for (int c = 0; c < missing; ++c) {
    const double goal =
        std::fmod(profile.at[start] + (c + offset) * profile.length / missing, profile.length);
    int best = -1;
    double best_distance = 1e300;
    for (int k = 0; k < m; ++k) {
      if (roles[k] != Role::flat && roles[k] != Role::bent) continue;
      double d = std::abs(profile.at[k] - goal);
      d = std::min(d, profile.length - d);
      if (d < best_distance) {
        best_distance = d;
        best = k;
      }
    }
    if (best >= 0) roles[best] = Role::exceptional;
  }
}

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
  Roles out = roles;
  for (std::size_t l = 0; l < joints.size(); ++l) {
    const int missing = missing_corners(joints, roles, static_cast<int>(l));
    if (missing == 0) continue;
    const LoopProfile profile = profile_of(mesh, joints[l], l == 0 ? 1.0 : -1.0,
                                           placement == Placement::tips ? 0.02 : 1.0 / 12);
    if (placement == Placement::curvature || placement == Placement::tips)
      place_by_curvature(profile, joints[l], missing, out[l]);
    else
      place_evenly(profile, joints[l], missing, placement == Placement::spread ? 0.0 : 0.5, out[l]);
  }
  return out;
}

std::vector<Roles> one_more(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                            int count) {
  constexpr double kApart = 1.0 / 24;  // of the loop's length
  std::vector<Roles> out;
  for (std::size_t l = 0; l < joints.size(); ++l) {
    const double outer = l == 0 ? 1 : -1;
    for (const double side : {outer, -outer}) {
      const LoopProfile profile = profile_of(mesh, joints[l], side, kApart);
      std::vector<int> taken;
      const int m = static_cast<int>(joints[l].size());
      for (int k = 0; k < m; ++k)
        if (ends_chain(roles[l][k])) taken.push_back(k);
      for (int found = 0; found < count; ++found) {
        int best = -1;
        for (int k = 0; k < m; ++k) {
          if (ends_chain(roles[l][k]) || profile.bend[k] <= 0) continue;
          if (std::any_of(taken.begin(), taken.end(), [&](int other) {
                return distance(profile, k, other) < kApart * profile.length;
              }))
            continue;
          if (best < 0 || profile.bend[k] > profile.bend[best]) best = k;
        }
        if (best < 0) break;
        taken.push_back(best);
        out.push_back(roles);
        out.back()[l][best] = side == outer ? Role::exceptional : Role::released;
      }
    }
  }
  return out;
}

int count_exceptional(const Roles& roles) {
  int count = 0;
  for (const auto& loop : roles)
    count += static_cast<int>(std::count_if(loop.begin(), loop.end(), gives_up_c1));
  return count;
}

int minimum_exceptional(const Joints& joints) {
  int count = 0;
  for (std::size_t l = 0; l < joints.size(); ++l) {
    int corners = 0;
    for (const Joint& joint : joints[l])
      if (joint.kind == JointKind::corner && joint.convex() == (l == 0)) ++corners;
    count += std::max(0, 3 - corners);
  }
  return count;
}

}  // namespace c1mesh
