// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "verify/curve_pairs.h"

namespace c1mesh::verification {
namespace {

using Poles = std::vector<Point>;
constexpr int kDepth = 60;

Meeting curves_meet(const Poles& a, const Poles& b, Shared shared) {
  ProofTree tree = comparison_tree(kDepth);
  return verification::curves_meet(a, b, shared, tree);
}

Meeting meets_itself(const Poles& curve) {
  ProofTree tree = comparison_tree(kDepth);
  return verification::meets_itself(curve, tree);
}

TEST(CurvesMeet, CrossingsAreProven) {
  const Poles arch{{0, 0}, {0, 1}, {1, 1}, {1, 0}};  // top at y = 3/4
  EXPECT_EQ(curves_meet(arch, {{-1, 0.5}, {0, 0.5}, {1, 0.5}, {2, 0.5}}, Shared::none),
            Meeting::meet);
  EXPECT_EQ(curves_meet(arch, {{0.3, -1}, {0.5, 0}, {0.6, 1}, {0.7, 3}}, Shared::none),
            Meeting::meet);
  EXPECT_EQ(curves_meet(arch, arch, Shared::none), Meeting::meet);
}

// The line y = 3/4 + gap passes above the arch by exactly `gap`.
TEST(CurvesMeet, NarrowGapsAreProvenAndTouchingIsNotCalledApart) {
  const Poles arch{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  const auto line = [](double y) { return Poles{{-1, y}, {0, y}, {1, y}, {2, y}}; };
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12})
    EXPECT_EQ(curves_meet(arch, line(0.75 + gap), Shared::none), Meeting::apart) << gap;
  for (const double gap : {1e-3, 1e-6, 1e-9})
    EXPECT_EQ(curves_meet(arch, line(0.75 - gap), Shared::none), Meeting::meet) << gap;
  EXPECT_NE(curves_meet(arch, line(0.75), Shared::none), Meeting::apart);
}

TEST(CurvesMeet, SharedStartAtAnyPositiveAngle) {
  const Poles base{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  for (const double angle : {3.14, 1.0, 0.1, 1e-3, 1e-6}) {
    const double c = std::cos(angle), s = std::sin(angle);
    // Bends back towards the base but does not reach it before its end.
    const Poles other{{0, 0}, {c, s}, {2 * c, 2 * s}, {3 * c, 2 * s}};
    EXPECT_EQ(curves_meet(base, other, Shared::start), Meeting::apart) << angle;
  }
  // Leaves upwards and comes down through the base.
  EXPECT_EQ(curves_meet(base, {{0, 0}, {1, 1}, {2, 1}, {2, -2}}, Shared::start), Meeting::meet);
  // The same tangent: nothing is proven, and nothing is claimed.
  EXPECT_EQ(curves_meet(base, {{0, 0}, {2, 0}, {3, 0}, {6, 0}}, Shared::start), Meeting::unknown);
}

TEST(CurvesMeet, ZeroHandlesAtTheSharedStart) {
  EXPECT_EQ(curves_meet({{0, 0}, {0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {0, 0}, {0, 1}, {1, 2}},
                        Shared::start),
            Meeting::apart);
}

TEST(CurvesMeet, LensBetweenTwoVertices) {
  const Poles low{{0, 0}, {1, -1}, {2, -1}, {3, 0}}, high{{0, 0}, {1, 1}, {2, 1}, {3, 0}};
  EXPECT_EQ(curves_meet(low, high, Shared::both_ends), Meeting::apart);
  const Poles wave{{0, 0}, {1, 3}, {2, -4}, {3, 0}};
  EXPECT_EQ(curves_meet(wave, {{0, 0}, {1, 0}, {2, 0}, {3, 0}}, Shared::both_ends), Meeting::meet);
}

TEST(MeetsItself, LoopsAndArches) {
  EXPECT_EQ(meets_itself({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), Meeting::apart);
  EXPECT_EQ(meets_itself({{0, 0}, {0, 0}, {1, 1}, {1, 1}}), Meeting::apart);
  // Turns by more than a half circle without closing.
  EXPECT_EQ(meets_itself({{0, 0}, {2, 0}, {2, 1}, {1, 0.5}}), Meeting::apart);
  // x = 1/2 at three parameters, two of them at one height.
  EXPECT_EQ(meets_itself({{0, 0}, {1.2, 1}, {-0.2, 1}, {1, 0}}), Meeting::meet);
  EXPECT_EQ(meets_itself({{0, 0}, {3, 2}, {-2, 2}, {1, 0}}), Meeting::meet);
  EXPECT_NE(meets_itself({{0, 0}, {1, 0}, {0, 0}}), Meeting::apart);  // there and back
}

TEST(Winding, CountsTurnsOfCurvedLoops) {
  const std::vector<Poles> lens{{{0, 0}, {1, -1}, {2, -1}, {3, 0}},
                                {{3, 0}, {2, 1}, {1, 1}, {0, 0}}};
  EXPECT_EQ(winding_around(lens, {1.5, 0}, kDepth).number, 1);
  EXPECT_EQ(winding_around(lens, {1.5, -0.7499}, kDepth).number, 1);
  EXPECT_EQ(winding_around(lens, {1.5, -0.7501}, kDepth).number, 0);  // inside the hull, outside
  EXPECT_FALSE(winding_around(lens, {1.5, -0.75}, 20).known);
  EXPECT_EQ(area_sign(lens), 1);
  const std::vector<Poles> clockwise{{lens[1].rbegin(), lens[1].rend()},
                                     {lens[0].rbegin(), lens[0].rend()}};
  EXPECT_EQ(area_sign(clockwise), -1);
  EXPECT_EQ(area_sign({{{0, 0}, {1, 0}}, {{1, 0}, {0, 0}}}), 0);
}

}  // namespace
}  // namespace c1mesh::verification
