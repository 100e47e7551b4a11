// SPDX-License-Identifier: GPL-3.0-or-later
// What the drawings under examples/ promise, in exact arithmetic.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "c1mesh/generate.h"
#include "c1mesh/shape.h"

namespace c1mesh {
namespace {

struct Expected {
  const char* name;
  int curves, holes, convex, reflex;
};

// Prints the name, not the bytes.
void PrintTo(const Expected& e, std::ostream* out) {
  *out << e.name;
}

Shape shape_of(const std::string& name) {
  const auto drawings = read_drawings(C1MESH_EXAMPLES "/" + name + ".svg");
  EXPECT_EQ(drawings.size(), 1u);
  return make_shape(drawings.front());
}

std::array<mpq_class, 2> minus(const Point& a, const Point& b) {
  return {mpq_class(a.x()) - mpq_class(b.x()), mpq_class(a.y()) - mpq_class(b.y())};
}

std::vector<Point> poles(const Shape& shape, const CurveUse& use) {
  std::vector<Point> out = shape.curves[use.curve].poles;
  if (use.reversed) std::reverse(out.begin(), out.end());
  return out;
}

// Signs of the turns at the loop's joints; 0 means exactly tangent-continuous.
std::vector<int> turns(const Shape& shape, const Loop& loop) {
  std::vector<int> out;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto in = poles(shape, loop[i]), next = poles(shape, loop[(i + 1) % loop.size()]);
    const auto u = minus(in.back(), in[in.size() - 2]), v = minus(next[1], next[0]);
    const mpq_class c = u[0] * v[1] - u[1] * v[0], d = u[0] * v[0] + u[1] * v[1];
    EXPECT_TRUE(c != 0 || d > 0) << "the boundary turns back at joint " << i;
    out.push_back(sgn(c));
  }
  return out;
}

class ExampleDrawings : public testing::TestWithParam<Expected> {};

TEST_P(ExampleDrawings, HaveThePromisedJoints) {
  const Expected expected = GetParam();
  const Shape shape = shape_of(expected.name);
  ASSERT_EQ(shape.regions.size(), 1u);
  const Region& region = shape.regions.front();
  EXPECT_EQ(static_cast<int>(region.holes.size()), expected.holes);
  EXPECT_EQ(static_cast<int>(shape.curves.size()), expected.curves);
  std::vector<int> all = turns(shape, region.outer);
  for (const Loop& hole : region.holes) {
    const std::vector<int> more = turns(shape, hole);
    all.insert(all.end(), more.begin(), more.end());
  }
  EXPECT_EQ(std::count(all.begin(), all.end(), 1), expected.convex);
  EXPECT_EQ(std::count(all.begin(), all.end(), -1), expected.reflex);
}

INSTANTIATE_TEST_SUITE_P(All, ExampleDrawings,
                         testing::Values(Expected{"blob", 4, 0, 0, 0},
                                         Expected{"puzzle", 24, 0, 4, 0},
                                         Expected{"annulus", 8, 1, 0, 0},
                                         Expected{"spiral", 44, 0, 0, 0},
                                         Expected{"letter", 15, 1, 5, 5}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(ExampleDrawings, TheClipArtIsOneUsableShapeWithAHole) {
  const Shape shape = shape_of("clipart");
  ASSERT_EQ(shape.regions.size(), 1u);
  EXPECT_EQ(shape.regions.front().holes.size(), 1u);
  EXPECT_EQ(shape.curves.size(), 24u);
}

// The random shapes pass the same checks as every other input, from JSON and from SVG alike.
TEST(GeneratedShapes, AreUsableWithoutRepairs) {
  for (const char set : {'A', 'B', 'C'})
    for (const Drawing& drawing : generate(set, 40, 1))
      for (const std::string& text : {drawing_json(drawing), drawing_svg(drawing)}) {
        const CheckReport report = check(read_drawings_from(text, drawing.name).front());
        EXPECT_TRUE(report.usable()) << drawing.name;
        for (const Defect& defect : report.defects) EXPECT_EQ(defect.kind, DefectKind::note);
      }
}

}  // namespace
}  // namespace c1mesh
