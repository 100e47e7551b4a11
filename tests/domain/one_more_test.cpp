// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates for one more exceptional vertex: one change each, apart, limbs and bays told apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "domain/hard_shapes.h"

namespace c1mesh {
namespace {

using namespace test;

constexpr double kApart = 1.0 / 24;  // of a loop's length, as the header promises "apart"

// Lengths along the chords of a loop's control points.
struct Along {
  std::vector<double> at;
  double length = 0;
  double distance(int a, int b) const {
    const double d = std::abs(at[a] - at[b]);
    return std::min(d, length - d);
  }
};

Along along(const Stage& stage, int loop) {
  Along out;
  const auto& joints = stage.joints[loop];
  for (std::size_t k = 0; k < joints.size(); ++k) {
    out.at.push_back(out.length);
    out.length += (stage.mesh.control[joints[(k + 1) % joints.size()].vertex] -
                   stage.mesh.control[joints[k].vertex])
                      .norm();
  }
  return out;
}

struct Change {
  int loop = -1, position = -1;
  Role role = Role::flat;
};

// The one place where a candidate differs.
Change change_of(const Roles& roles, const Roles& candidate) {
  Change out;
  int changes = 0;
  EXPECT_EQ(candidate.size(), roles.size());
  for (std::size_t l = 0; l < roles.size(); ++l) {
    EXPECT_EQ(candidate[l].size(), roles[l].size());
    for (std::size_t k = 0; k < roles[l].size(); ++k)
      if (candidate[l][k] != roles[l][k]) {
        ++changes;
        EXPECT_TRUE(roles[l][k] == Role::flat || roles[l][k] == Role::bent);
        out = {static_cast<int>(l), static_cast<int>(k), candidate[l][k]};
      }
  }
  EXPECT_EQ(changes, 1);
  return out;
}

// A plus sign, rounded, and a comb: convex corners at limbs, reflex ones in bays.
std::vector<Point> plus() {
  return {{0.35, 0.05}, {0.65, 0.05}, {0.65, 0.35}, {0.95, 0.35}, {0.95, 0.65}, {0.65, 0.65},
          {0.65, 0.95}, {0.35, 0.95}, {0.35, 0.65}, {0.05, 0.65}, {0.05, 0.35}, {0.35, 0.35}};
}

bool nearest_is_convex(const std::vector<Point>& corners, const Point& p) {
  const std::size_t n = corners.size();
  std::size_t best = 0;
  for (std::size_t i = 0; i < n; ++i)
    if ((corners[i] - p).norm() < (corners[best] - p).norm()) best = i;
  return cross(corners[best] - corners[(best + n - 1) % n],
               corners[(best + 1) % n] - corners[best]) > 0;
}

class OneMore : public testing::TestWithParam<std::vector<Point>> {};

TEST_P(OneMore, IsOneVertexApartExceptionalOnALimbReleasedInABay) {
  const std::vector<Point> corners = GetParam();
  const Stage stage = stage_of({rounded(corners, 0.3)});
  ASSERT_EQ(count_exceptional(stage.roles), 3);
  const Along lengths = along(stage, 0);
  for (const int count : {1, 3, 100}) {
    const std::vector<Roles> candidates = one_more(stage.mesh, stage.joints, stage.roles, count);
    std::vector<int> limbs, bays;
    for (const Roles& candidate : candidates) {
      const Change change = change_of(stage.roles, candidate);
      ASSERT_EQ(change.loop, 0);
      const Point p = stage.mesh.control[stage.joints[0][change.position].vertex];
      ASSERT_TRUE(change.role == Role::exceptional || change.role == Role::released);
      std::vector<int>& same = change.role == Role::exceptional ? limbs : bays;
      EXPECT_EQ(nearest_is_convex(corners, p), change.role == Role::exceptional) << p.transpose();
      for (std::size_t k = 0; k < stage.roles[0].size(); ++k)
        if (ends_chain(stage.roles[0][k])) {
          EXPECT_GE(lengths.distance(change.position, static_cast<int>(k)),
                    kApart * lengths.length * (1 - 1e-12));
        }
      for (int other : same)
        EXPECT_GE(lengths.distance(change.position, other), kApart * lengths.length * (1 - 1e-12));
      same.push_back(change.position);
    }
    EXPECT_LE(limbs.size(), static_cast<std::size_t>(count));
    EXPECT_LE(bays.size(), static_cast<std::size_t>(count));
    EXPECT_GE(limbs.size(), static_cast<std::size_t>(std::min(count, 3)));
    EXPECT_GE(bays.size(), static_cast<std::size_t>(std::min(count, 3)));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, OneMore, testing::Values(plus(), comb(3)));

// A disc turns to the left everywhere and has no bay; seen from a ring the hole turns to the right
// everywhere, which is the side that a hole's corners need.
TEST(OneMoreRound, RoundLoopsHaveNoBays) {
  const Stage stage = stage_of({circle({0.5, 0.5}, 0.4), backwards(circle({0.5, 0.5}, 0.15))});
  const std::vector<Roles> candidates = one_more(stage.mesh, stage.joints, stage.roles, 2);
  std::vector<int> found(2, 0);
  for (const Roles& candidate : candidates) {
    const Change change = change_of(stage.roles, candidate);
    EXPECT_EQ(change.role, Role::exceptional);
    ++found[change.loop];
  }
  EXPECT_EQ(found, (std::vector<int>{2, 2}));
}

TEST(OneMoreRound, NoneAskedNoneGiven) {
  const Stage stage = stage_of({circle({0.5, 0.5}, 0.4)});
  EXPECT_TRUE(one_more(stage.mesh, stage.joints, stage.roles, 0).empty());
}

}  // namespace
}  // namespace c1mesh
