// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/initial_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "bernstein/curve.h"
#include "mesh/mesh_svg.h"
#include "mesh/shapes.h"
#include "mesh/topology.h"

namespace c1mesh {
namespace {

using namespace test;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

// Every boundary edge must hold the rounded exact subdivision of its curve, and the edges of a
// curve must cover it from 0 to 1 without gap.
void expect_conforming(const MeshInput& input, const CurvedMesh& mesh) {
  const MeshTopology topology(mesh);
  ASSERT_EQ(mesh.loops.size(), input.loops.size());
  for (std::size_t k = 0; k < mesh.loops.size(); ++k) {
    std::size_t source = 0;
    double reached = 0;
    for (const BoundaryEdge& e : mesh.loops[k]) {
      const LoopCurve& c = input.loops[k][source];
      ASSERT_EQ(e.curve, c.curve);
      const double s0 = c.reversed ? 1 - e.t0 : e.t0, s1 = c.reversed ? 1 - e.t1 : e.t1;
      EXPECT_EQ(s0, reached);
      EXPECT_LT(s0, s1);
      reached = s1;
      if (s1 == 1) ++source, reached = 0;
      const BezierCurve exact = restrict_exactly(c.bezier, s0, s1, input.degree);
      std::vector<Point> held;
      for (const MeshEdge& m : topology.edges)
        if (m.triangle[1] < 0 && m.a == e.a && m.b == e.b)
          for (int id : edge_controls(mesh, m.triangle[0], m.corner[0]))
            held.push_back(mesh.control[id]);
      EXPECT_EQ(held, exact.poles);
    }
    EXPECT_EQ(source, input.loops[k].size());
  }
}

void expect_guarded(const CurvedMesh& mesh) {
  const MeshTopology topology(mesh);
  for (const MeshEdge& e : topology.edges) {
    const bool joins = topology.on_boundary[e.a] && topology.on_boundary[e.b];
    EXPECT_FALSE(joins && e.triangle[1] >= 0) << e.a << "-" << e.b;
  }
  for (int v = 0; v < mesh.vertex_count(); ++v)
    EXPECT_TRUE(!topology.on_boundary[v] || topology.vertex_triangles[v].size() >= 2) << v;
}

CurvedMesh expect_sound(const MeshInput& input, double bound = 10, bool slender = false) {
  MeshReport report;
  const CurvedMesh mesh = initial_mesh(input, {bound}, report);
  EXPECT_EQ(joined(check_mesh(mesh)), "");
  EXPECT_LE(report.mips_bound, bound);
  EXPECT_EQ(report.notes.size(), slender ? 1u : 0u) << joined(report.notes);
  if (slender) {
    EXPECT_EQ(joined(report.notes).rfind("slender triangles (else ", 0), 0u);
  }
  double largest = 0, area = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    largest = std::max(largest, triangle_bound(mesh, t));
  EXPECT_EQ(largest, report.mips_bound);
  for (const auto& loop : input.loops)
    for (const LoopCurve& c : loop) area += green_area({c.bezier});
  EXPECT_NEAR(mesh_area(mesh), area, 1e-13);
  expect_conforming(input, mesh);
  expect_guarded(mesh);
  return mesh;
}

TEST(InitialMesh, SquareOfLinesIsTheIdentity) {
  const MeshInput input = input_of({polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})});
  const CurvedMesh mesh = expect_sound(input);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    EXPECT_FALSE(mesh.warped[t]);
    EXPECT_NEAR(triangle_bound(mesh, t), 2, 1e-12);  // |I|^2 / det I
  }
}

TEST(InitialMesh, OneTriangleIsSplitByTheGuard) {
  const CurvedMesh mesh = expect_sound(input_of({polygon({{0, 0}, {1, 0}, {0, 1}})}));
  EXPECT_EQ(mesh.triangle_count(), 3);
}

TEST(InitialMesh, UnevenlyParametrisedLinesAreWarped) {
  auto square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  square[0] = {{Point(0, 0), Point(0.2, 0), Point(0.9, 0), Point(1, 0)}};
  const CurvedMesh mesh = expect_sound(input_of({square}));
  EXPECT_TRUE(std::count(mesh.warped.begin(), mesh.warped.end(), 1) > 0);
}

TEST(InitialMesh, Annulus) {
  expect_sound(input_of({circle({0.5, 0.5}, 0.5), backwards(circle({0.5, 0.5}, 0.2))}));
}

MeshInput annulus(double width) {
  return input_of({circle({0.5, 0.5}, 0.5), backwards(circle({0.5, 0.5}, 0.5 - width))});
}

double least_angle(const CurvedMesh& mesh) {
  double least = 180;
  for (const auto& corners : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const Point a = mesh.domain[corners[k]], u = mesh.domain[corners[(k + 1) % 3]] - a,
                  v = mesh.domain[corners[(k + 2) % 3]] - a;
      least = std::min(least, std::atan2(cross(u, v), u.dot(v)) * 180 / M_PI);
    }
  return least;
}

// Well-shaped triangles across a ring number in proportion to length over width. Beyond some
// hundreds, slender ones are taken: their number grows with the logarithm.
TEST(InitialMesh, ThinAnnulus) {
  const CurvedMesh broad = expect_sound(annulus(0.05));
  EXPECT_GT(least_angle(broad), 11.5);
  const CurvedMesh thin = expect_sound(annulus(0.01), 10, true);
  EXPECT_LT(thin.triangle_count(), 600);
  const CurvedMesh thinner = expect_sound(annulus(0.001), 10, true);
  EXPECT_LT(thinner.triangle_count(), 2000);
}

// The apexes of neighbouring warp triangles are the ends of short edges whose far corner is the
// middle of the shape: a fan that is refined like anything else.
TEST(InitialMesh, ManyShortCurvesMakeNoFan) {
  for (const int count : {30, 60, 120})
    EXPECT_GT(least_angle(expect_sound(input_of({blob(count, 0.1, 5)}))), 11.5) << count;
}

// A comb whose back is far narrower than any of its edges is long.
TEST(InitialMesh, NarrowStripsHaveSoundTriangles) {
  std::vector<Point> points = {{0, 0}, {1, 0}};
  for (int tooth = 5; tooth >= 0; --tooth) {
    const double right = (2 * tooth + 1) / 11.0, left = 2 * tooth / 11.0;
    if (tooth < 5) points.push_back({right, 0.02});
    points.insert(points.end(), {Point(right, 0.2), Point(left, 0.2)});
    if (tooth > 0) points.push_back({left, 0.02});
  }
  EXPECT_GT(least_angle(expect_sound(input_of({polygon(points)}))), 14.5);
}

TEST(InitialMesh, LoopOfOneCurve) {
  expect_sound(input_of({drop()}));
}

TEST(InitialMesh, HolesOfLinesInABlob) {
  auto hole = [](double x, double y) {
    return backwards(polygon({{x, y}, {x + 0.05, y}, {x + 0.05, y + 0.05}, {x, y + 0.05}}));
  };
  expect_sound(input_of({blob(8, 0.2, 3), hole(0.4, 0.4), hole(0.46, 0.46), hole(0.55, 0.4)}));
}

TEST(InitialMesh, ReversedCurvesRunBackwards) {
  MeshInput input = input_of({blob(5, 0.2, 4)});
  for (LoopCurve& c : input.loops[0]) c.reversed = true;
  const CurvedMesh mesh = expect_sound(input);
  for (const BoundaryEdge& e : mesh.loops[0]) EXPECT_GT(e.t0, e.t1);
}

TEST(InitialMesh, TighterBoundsAreKept) {
  expect_sound(input_of({blob(6, 0.4, 9)}), 4);
}

TEST(InitialMesh, Spiral) {
  expect_sound(input_of({spiral(3)}));
}

// A symmetric shape has many ties, and a churned heap gives the mesher's objects addresses in
// another order: none of that may show.
TEST(InitialMesh, SameInputSameBytes) {
  std::vector<std::vector<BezierCurve>> loops{polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  for (double x : {0.2, 0.5, 0.8}) {
    loops.push_back(
        backwards(polygon({{x - 0.1, 0.2}, {x + 0.1, 0.2}, {x + 0.1, 0.4}, {x - 0.1, 0.4}})));
    loops.push_back(backwards(circle({x, 0.7}, 0.1)));
  }
  const MeshInput input = input_of(loops);
  MeshReport report;
  const CurvedMesh first = initial_mesh(input, {}, report);
  std::mt19937 random(1);
  for (int run = 0; run < 20; ++run) {
    std::vector<std::unique_ptr<char[]>> blocks;
    for (int i = 0; i < 2000; ++i) blocks.emplace_back(new char[100 + random() % 20000]);
    std::shuffle(blocks.begin(), blocks.end(), random);
    blocks.resize(1000);
    const CurvedMesh again = initial_mesh(input, {}, report);
    ASSERT_EQ(first.triangles, again.triangles);
    ASSERT_EQ(first.nets, again.nets);
    ASSERT_EQ(first.domain, again.domain);
    ASSERT_EQ(first.control, again.control);
  }
}

TEST(InitialMesh, PictureShowsEveryBoundaryVertex) {
  MeshReport report;
  const CurvedMesh mesh = initial_mesh(input_of({blob(5, 0.1, 1)}), {}, report);
  const std::string svg = mesh_svg(mesh);
  std::size_t dots = 0;
  for (std::size_t at = svg.find("h0"); at != std::string::npos; at = svg.find("h0", at + 1))
    ++dots;
  EXPECT_EQ(dots, 2 * mesh.loops[0].size());  // once in each of the two meshes
}

TEST(InitialMesh, NothingToMeshIsRefused) {
  MeshReport report;
  EXPECT_THROW(initial_mesh({}, {}, report), std::invalid_argument);
}

class RandomShapes : public testing::TestWithParam<int> {};

TEST_P(RandomShapes, AreSoundInEveryDegree) {
  const int seed = GetParam();
  const auto outer = blob(5 + seed % 20, 0.1 + 0.02 * (seed % 25), seed);
  const auto hole = backwards(circle({0.5, 0.5}, 0.03));
  expect_sound(input_of({outer, hole}, 3 + seed % 3));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomShapes, testing::Range(1, 31));

class SharpCorners : public testing::TestWithParam<double> {};

TEST_P(SharpCorners, OfALensAreMeshed) {
  expect_sound(input_of({lens(GetParam())}));
}

TEST_P(SharpCorners, BetweenLinesAreMeshed) {
  const double rise = std::tan(GetParam() * std::acos(-1.0) / 180);
  expect_sound(input_of({polygon({{0, 0}, {1, 0}, {1, rise}})}));
}

INSTANTIATE_TEST_SUITE_P(Degrees, SharpCorners, testing::Values(0.5, 1.0, 2.0, 5.0, 10.0, 20.0));

}  // namespace
}  // namespace c1mesh
