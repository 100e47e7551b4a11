// SPDX-License-Identifier: GPL-3.0-or-later
// What each family of hard shapes promises, and that `check` takes every shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "c1mesh/generate.h"
#include "generate/portable_math.h"

namespace c1mesh {
namespace {

using generate_detail::in_equal_ratios;
using generate_detail::unit_at;

constexpr double kDegree = std::numbers::pi / 180;

using Curves = std::vector<BezierCurve>;

Curves curves_of(const FamilyShape& shape) {
  Curves curves;
  for (const InputCurve& input : shape.drawing.curves) curves.push_back(input.curve);
  return curves;
}

std::vector<FamilyShape> shapes_of(const std::string& family) {
  return generate_family(family, 8, 1);
}

// The curves in file order as closed loops: each ends where the next starts, bit for bit, or where
// its loop began.
std::vector<Curves> loops_of(const Curves& curves) {
  std::vector<Curves> loops;
  bool open = false;
  for (const BezierCurve& curve : curves) {
    if (!open) loops.emplace_back();
    EXPECT_TRUE(!open || loops.back().back().end() == curve.start());
    loops.back().push_back(curve);
    open = curve.end() != loops.back().front().start();
  }
  EXPECT_FALSE(open);
  return loops;
}

Point first_leg(const BezierCurve& curve) {
  for (const Point& p : curve.poles)
    if (p != curve.start()) return p - curve.start();
  return Point::Zero();
}

Point last_leg(const BezierCurve& curve) {
  for (auto p = curve.poles.rbegin(); p != curve.poles.rend(); ++p)
    if (*p != curve.end()) return curve.end() - *p;
  return Point::Zero();
}

// Where curve i ends, to the left positive, in radians. Exactly 0 for handles on the grid.
double turn_after(const Curves& loop, std::size_t i) {
  const Point u = last_leg(loop[i]), v = first_leg(loop[(i + 1) % loop.size()]);
  return std::atan2(cross(u, v), u.dot(v));
}

std::vector<double> turns(const Curves& loop) {
  std::vector<double> all;
  for (std::size_t i = 0; i < loop.size(); ++i) all.push_back(turn_after(loop, i));
  return all;
}

int count_turns(const Curves& loop, double low, double high) {
  const auto all = turns(loop);
  return static_cast<int>(std::count_if(all.begin(), all.end(),
                                        [&](double turn) { return turn > low && turn < high; }));
}

int convex(const Curves& loop) {
  return count_turns(loop, 1 * kDegree, 181 * kDegree);
}
int reflex(const Curves& loop) {
  return count_turns(loop, -181 * kDegree, -1 * kDegree);
}

void expect_smooth(const Curves& loop) {
  for (const double turn : turns(loop)) EXPECT_EQ(turn, 0);
}

double green_area(const Curves& loop) {
  // Gauss with 8 points integrates the degree 2 n - 1 <= 13 of n <= 7 exactly.
  constexpr double kNodes[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                               0.9602898564975363};
  constexpr double kWeights[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                 0.1012285362903763};
  double area = 0;
  for (const BezierCurve& curve : loop)
    for (int k = 0; k < 8; ++k) {
      const double t = 0.5 + (k < 4 ? 0.5 : -0.5) * kNodes[k % 4];
      std::vector<Point> p = curve.poles;
      for (std::size_t n = p.size() - 1; n > 1; --n)
        for (std::size_t i = 0; i < n; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
      const Point at = (1 - t) * p[0] + t * p[1], speed = curve.degree() * (p[1] - p[0]);
      area += 0.25 * kWeights[k % 4] * cross(at, speed);
    }
  return area;
}

TEST(PortableMath, AgreesWithTheLibrary) {
  for (double degrees = -800; degrees < 800; degrees += 0.37) {
    EXPECT_NEAR(unit_at(degrees).x(), std::cos(degrees * kDegree), 1e-14);
    EXPECT_NEAR(unit_at(degrees).y(), std::sin(degrees * kDegree), 1e-14);
  }
  EXPECT_EQ(unit_at(-270), Point(0, 1));
  EXPECT_EQ(unit_at(540), Point(-1, 0));
  for (double t = 0; t <= 1; t += 0.01) {
    const double expected = 3e-12 * std::pow(5e13 / 3, t);
    EXPECT_NEAR(in_equal_ratios(3e-12, 50, t), expected, 1e-13 * expected);
  }
  EXPECT_EQ(in_equal_ratios(1e-1, 1e-5, 1), 1e-5);
}

class Families : public testing::TestWithParam<std::string> {};

TEST_P(Families, AreValidInput) {
  for (const std::uint64_t seed : {1u, 2u})
    for (const FamilyShape& shape : generate_family(GetParam(), 8, seed)) {
      loops_of(curves_of(shape));
      const CheckReport report = check(shape.drawing);
      EXPECT_TRUE(report.usable()) << shape.drawing.name;
      for (const Defect& defect : report.defects)
        EXPECT_TRUE(defect.kind == DefectKind::note ||
                    (GetParam() == "pinched" && defect.kind == DefectKind::handle))
            << shape.drawing.name << ": " << defect.message;
    }
}

TEST_P(Families, TheParameterRunsFromPleasantToNasty) {
  const auto all = families();
  const Family family =
      *std::find_if(all.begin(), all.end(), [](const Family& f) { return f.name == GetParam(); });
  const auto shapes = shapes_of(GetParam());
  ASSERT_EQ(shapes.size(), 8u);
  EXPECT_EQ(shapes.front().parameter, family.pleasant);
  EXPECT_EQ(shapes.back().parameter, family.nasty);
  for (std::size_t i = 1; i < shapes.size(); ++i)
    EXPECT_GE((shapes[i].parameter - shapes[i - 1].parameter) * (family.nasty - family.pleasant),
              0);
  EXPECT_EQ(generate_family(GetParam(), 1, 1).front().parameter, family.nasty);
  int highest = 0;
  for (const FamilyShape& shape : shapes)
    for (const BezierCurve& curve : curves_of(shape)) highest = std::max(highest, curve.degree());
  EXPECT_EQ(highest, family.highest_degree);
}

TEST_P(Families, SameSeedSameBytes) {
  const auto one = shapes_of(GetParam()), two = shapes_of(GetParam());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(drawing_json(one[i].drawing), drawing_json(two[i].drawing));
    EXPECT_EQ(one[i].drawing.name, GetParam() + "-000" + std::to_string(i + 1));
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Family& family : families()) all.push_back(family.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(names()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Family, RefusesUnknownNamesAndNegativeCounts) {
  EXPECT_THROW(generate_family("cube", 1, 1), std::invalid_argument);
  EXPECT_THROW(generate_family("comb", -1, 1), std::invalid_argument);
  EXPECT_TRUE(generate_family("comb", 0, 1).empty());
}

TEST(Family, ChanceFollowsTheSeed) {
  for (const char* name : {"maze", "mild", "chords", "pinched", "degrees", "star"})
    EXPECT_NE(drawing_json(generate_family(name, 1, 1)[0].drawing),
              drawing_json(generate_family(name, 1, 2)[0].drawing))
        << name;
}

// FNV-1a of the text of all families: the same on every machine, or this fails there.
TEST(Family, BytesArePinned) {
  std::uint64_t hash = 14695981039346656037u;
  for (const std::string& name : names())
    for (const FamilyShape& shape : shapes_of(name))
      for (const unsigned char c : drawing_json(shape.drawing)) hash = (hash ^ c) * 1099511628211u;
  EXPECT_EQ(hash, 15940857840162155188u);
}

TEST(Family, CombsHaveTheirAspectAndCorners) {
  for (const FamilyShape& shape : shapes_of("comb")) {
    const auto loops = loops_of(curves_of(shape));
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(convex(loops[0]), 14);  // two at the foot, two a tooth
    EXPECT_EQ(reflex(loops[0]), 10);
    double top = 0;
    for (const BezierCurve& curve : loops[0])
      if (curve.start().y() == 1 && curve.end().y() == 1)
        top = (curve.end() - curve.start()).norm();
    EXPECT_NEAR(1 / top, shape.parameter, 1e-9 * shape.parameter);
  }
}

// A corridor that turns back 2 n times has the area that the slots leave.
TEST(Family, SerpentinesAndMazesHaveTheirArea) {
  for (const FamilyShape& shape : shapes_of("serpentine")) {
    const double n = shape.parameter, corridor = 1 / (1.5 * n + 1);
    EXPECT_NEAR(green_area(curves_of(shape)), 1 - n * (1 - corridor) * corridor / 2, 1e-10);
  }
  for (const FamilyShape& shape : shapes_of("maze")) {
    // A tree of n² rooms has n² - 1 doors, all unit cells of a board of side 2 n - 1.
    const double n = shape.parameter, side = 2 * n - 1;
    const Curves curves = curves_of(shape);
    EXPECT_EQ(loops_of(curves).size(), 1u);
    EXPECT_NEAR(green_area(curves) * side * side, 2 * n * n - 1, 1e-9);
    EXPECT_EQ(convex(curves), reflex(curves) + 4);
  }
}

TEST(Family, SmoothFamiliesAreExactlySmooth) {
  for (const char* name :
       {"spiral", "dumbbell", "rounded-snowflake", "chords", "oval", "single", "star"})
    for (const FamilyShape& shape : shapes_of(name)) {
      SCOPED_TRACE(shape.drawing.name);
      expect_smooth(curves_of(shape));
    }
}

// Half as wide as the pitch: the band's area is its mean length times that, ends apart.
TEST(Family, SpiralsHaveTheirTurns) {
  for (const FamilyShape& shape : shapes_of("spiral")) {
    const double n = shape.parameter, pitch = 1 / n;
    const double middle = 2 * std::numbers::pi * n * pitch * (0.75 + n / 2);
    const double ends = std::numbers::pi * pitch * pitch / 16;
    EXPECT_NEAR(green_area(curves_of(shape)), middle * pitch / 2 + ends, 0.01 * middle * pitch / 2);
  }
}

TEST(Family, NecksAreAsNarrowAsTheySay) {
  for (const FamilyShape& shape : shapes_of("neck")) {
    const Curves loop = curves_of(shape);
    std::vector<double> levels;
    for (const BezierCurve& curve : loop)
      if (curve.degree() == 1) {
        EXPECT_EQ(curve.start().y(), curve.end().y());
        levels.push_back(curve.start().y());
      }
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_NEAR(std::abs(levels[0] - levels[1]), shape.parameter, 2e-12);
    EXPECT_EQ(reflex(loop), 4);
    EXPECT_EQ(convex(loop), 0);
  }
  for (const FamilyShape& shape : shapes_of("dumbbell")) {
    // The waist is where the loop crosses x = 0; control points beyond lie further out.
    double least = 1;
    for (const BezierCurve& curve : curves_of(shape))
      for (const Point& p : curve.poles)
        if (std::abs(p.x()) < 2) least = std::min(least, std::abs(p.y()));
    EXPECT_NEAR(2 * least, shape.parameter, 2e-12);
  }
}

TEST(Family, HairlinesHaveTheirAspect) {
  for (const FamilyShape& shape : shapes_of("hairline")) {
    const Curves loop = curves_of(shape);
    const double length = std::numbers::pi / 2;
    EXPECT_NEAR(length * length / green_area(loop), shape.parameter, 1e-3 * shape.parameter);
    EXPECT_EQ(convex(loop), 4);
    EXPECT_EQ(reflex(loop), 0);
  }
}

TEST(Family, GearsAndSnowflakesHaveTheirCorners) {
  for (const FamilyShape& shape : shapes_of("gear")) {
    EXPECT_EQ(convex(curves_of(shape)), 2 * shape.parameter);
    EXPECT_EQ(reflex(curves_of(shape)), 2 * shape.parameter);
  }
  for (const FamilyShape& shape : shapes_of("snowflake")) {
    const double sides = 3 * std::pow(4, shape.parameter);
    EXPECT_EQ(convex(curves_of(shape)) + reflex(curves_of(shape)), sides);
    // Koch: the area tends to 8/5 of the triangle's, the rest falls by 4/9 a level.
    const double triangle = 0.75 * std::sqrt(3.0);
    EXPECT_NEAR(green_area(curves_of(shape)),
                triangle * (1.6 - 0.6 * std::pow(4.0 / 9, shape.parameter)), 1e-9);
  }
}

double interior_angle(const Curves& loop, std::size_t i) {
  return 180 - turn_after(loop, i) / kDegree;
}

TEST(Family, CornersHaveTheirAngles) {
  for (const FamilyShape& shape : shapes_of("spike")) {
    const Curves loop = curves_of(shape);
    EXPECT_NEAR(interior_angle(loop, loop.size() - 1), shape.parameter, 1e-9);
    EXPECT_EQ(convex(loop), 1);
    EXPECT_EQ(reflex(loop), 0);
  }
  for (const FamilyShape& shape : shapes_of("notch")) {
    const Curves loop = curves_of(shape);
    EXPECT_NEAR(interior_angle(loop, loop.size() - 1), 360 - shape.parameter, 1e-9);
    EXPECT_EQ(convex(loop), 2);
    EXPECT_EQ(reflex(loop), 1);
  }
  for (const FamilyShape& shape : shapes_of("drop"))
    EXPECT_NEAR(interior_angle(curves_of(shape), 0), shape.parameter, 1e-9);
  for (const FamilyShape& shape : shapes_of("lens"))
    for (const std::size_t i : {0, 1})
      EXPECT_NEAR(interior_angle(curves_of(shape), i), shape.parameter, 1e-9);
}

// Poles of size 1 hold a turn to about 2^-53 over a handle's length.
TEST(Family, MildJointsTurnByEqualRatios) {
  for (const FamilyShape& shape : shapes_of("mild")) {
    auto found = turns(curves_of(shape));
    for (double& turn : found) turn = std::abs(turn);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), shape.parameter);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double t = k / (shape.parameter - 1);
      EXPECT_NEAR(found[k], 1e-12 * std::pow(15e12, t) * kDegree, 4e-15) << k;
    }
  }
}

TEST(Family, HolesAndRingsAreCounted) {
  for (const char* name : {"plate", "grate"})
    for (const FamilyShape& shape : shapes_of(name)) {
      const Shape made = make_shape(shape.drawing);
      ASSERT_EQ(made.regions.size(), 1u);
      EXPECT_EQ(made.regions[0].holes.size(), shape.parameter);
    }
  for (const FamilyShape& shape : shapes_of("rings")) {
    EXPECT_EQ(loops_of(curves_of(shape)).size(), shape.parameter);
    EXPECT_EQ(make_shape(shape.drawing).regions.size(), std::ceil(shape.parameter / 2));
  }
}

TEST(Family, ChordsAreAsShortAsTheySay) {
  for (const FamilyShape& shape : shapes_of("chords")) {
    double least = 1;
    for (const BezierCurve& curve : curves_of(shape))
      least = std::min(least, (curve.end() - curve.start()).norm());
    // On an ellipse of half-axes 1 and 0.7.
    EXPECT_GT(least, 0.69 * shape.parameter);
    EXPECT_LT(least, 1.01 * shape.parameter);
  }
}

TEST(Family, PinchedCurvesHaveCoincidentPoles) {
  for (const FamilyShape& shape : shapes_of("pinched"))
    for (const BezierCurve& curve : curves_of(shape)) {
      const auto& p = curve.poles;
      EXPECT_TRUE(p[1] == p[2] || (p[0] == p[1] && p[2] == p[3]));
    }
}

TEST(Family, EveryDegreeUpToTheHighest) {
  for (const FamilyShape& shape : shapes_of("degrees")) {
    std::vector<int> seen(8, 0);
    for (const BezierCurve& curve : curves_of(shape)) ++seen[curve.degree()];
    for (int degree = 1; degree <= 7; ++degree)
      EXPECT_EQ(seen[degree] > 0, degree <= shape.parameter);
  }
  for (const FamilyShape& shape : shapes_of("single")) {
    ASSERT_EQ(shape.drawing.curves.size(), 1u);
    EXPECT_EQ(curves_of(shape)[0].degree(), shape.parameter);
  }
}

TEST(Family, OvalsAndStars) {
  for (const FamilyShape& shape : shapes_of("oval"))
    // Two arches of cubics with upright handles h over a chord of 2: area 2 * 3 / 5 * 2 h, each as
    // high as 3 / 4 h = 1 / aspect.
    EXPECT_NEAR(green_area(curves_of(shape)), 2.4 * 4 / (3 * shape.parameter), 1e-10);
  for (const FamilyShape& shape : shapes_of("star"))
    EXPECT_EQ(shape.drawing.curves.size(), shape.parameter);
}

}  // namespace
}  // namespace c1mesh
