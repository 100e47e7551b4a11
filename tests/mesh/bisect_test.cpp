// SPDX-License-Identifier: GPL-3.0-or-later
// Bisection of chosen triangles: the map stays, the chosen ones are cut, curves stay covered.
#include "mesh/bisect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "bernstein/curve.h"
#include "bernstein/net_blossom.h"
#include "mesh/shapes.h"
#include "mesh/topology.h"
#include "optimise/random_mesh.h"

namespace c1mesh {
namespace {

using namespace test;

// A smooth region with a hole, or a disc with a bent chord and a dangling feature.
struct Sample {
  CurvedMesh mesh;
  std::map<int, BezierCurve> curves;
};

Sample sample(int degree, bool features) {
  MeshInput input = input_of({blob(6, 0.3, 2), backwards(circle({0.5, 0.5}, 0.1))}, degree);
  if (features) {
    input = input_of({circle({0.5, 0.5}, 0.4)}, degree);
    const Point east = input.loops[0][0].bezier.start(), west = input.loops[0][2].bezier.start();
    const Point south = input.loops[0][3].bezier.start();
    input.features.push_back({loop_of({{{east, {0.7, 0.8}, {0.3, 0.3}, west}}}, degree, 100)});
    input.features.push_back(
        {loop_of({{{south, {0.55, 0.2}, {0.45, 0.3}, {0.5, 0.35}}}}, degree, 101)});
  }
  Sample out;
  for (const auto& loop : input.loops)
    for (const LoopCurve& c : loop) out.curves[c.curve] = c.bezier;
  for (const auto& path : input.features)
    for (const LoopCurve& c : path.curves) out.curves[c.curve] = c.bezier;
  MeshReport report;
  out.mesh = initial_mesh(input, {}, report);
  return out;
}

double area(const CurvedMesh& mesh, int t) {
  const auto& v = mesh.triangles[t];
  return 0.5 * cross(mesh.domain[v[1]] - mesh.domain[v[0]], mesh.domain[v[2]] - mesh.domain[v[0]]);
}

// Points strictly inside the triangles of `mesh`, some in each.
std::vector<Point> random_points(const CurvedMesh& mesh, int each, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.02, 1);
  std::vector<Point> out;
  for (const auto& corners : mesh.triangles)
    for (int i = 0; i < each; ++i) {
      Barycentric w(unit(random), unit(random), unit(random));
      w /= w.sum();
      out.emplace_back(w[0] * mesh.domain[corners[0]] + w[1] * mesh.domain[corners[1]] +
                       w[2] * mesh.domain[corners[2]]);
    }
  return out;
}

// Vertices keep ids and places to the bit, every triangle lies within the one of its id.
void expect_first_parts(const CurvedMesh& before, const CurvedMesh& after) {
  for (int v = 0; v < before.vertex_count(); ++v) {
    EXPECT_EQ(after.domain[v], before.domain[v]);
    EXPECT_EQ(after.control[v], before.control[v]);
  }
  ASSERT_GE(after.triangle_count(), before.triangle_count());
  for (int t = 0; t < before.triangle_count(); ++t)
    for (int v : after.triangles[t])
      EXPECT_GT(locate(before, t, after.domain[v]).minCoeff(), -1e-12) << t;
}

void expect_cut(const CurvedMesh& before, const CurvedMesh& after, const std::vector<int>& chosen) {
  for (int t : chosen) EXPECT_LE(area(after, t), 0.5 * area(before, t) * (1 + 1e-12)) << t;
}

std::vector<Point> row_of(const CurvedMesh& mesh, int a, int b) {
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh.triangles[t][(k + 1) % 3] == a && mesh.triangles[t][(k + 2) % 3] == b) {
        std::vector<Point> row;
        for (int id : edge_controls(mesh, t, k)) row.push_back(mesh.control[id]);
        return row;
      }
  return {};
}

bool is_power_of_half(double x) {
  int exponent = 0;
  return x > 0 && x <= 1 && std::frexp(x, &exponent) == 0.5;
}

// The edges of a path after bisection: each old edge's parameters in order, halved again and again
// without error, and control points that are the curve's.
void expect_covered(const Sample& before, const std::vector<BoundaryEdge>& old_edges,
                    const CurvedMesh& after, const std::vector<BoundaryEdge>& edges) {
  std::size_t k = 0;
  for (const BoundaryEdge& whole : old_edges) {
    ASSERT_LT(k, edges.size());
    EXPECT_EQ(edges[k].a, whole.a);
    EXPECT_EQ(edges[k].t0, whole.t0);
    for (;; ++k) {
      ASSERT_LT(k, edges.size());
      const BoundaryEdge& part = edges[k];
      EXPECT_EQ(part.curve, whole.curve);
      EXPECT_TRUE(is_power_of_half((part.t1 - part.t0) / (whole.t1 - whole.t0)));
      EXPECT_EQ(std::ldexp(part.t1, 40), std::floor(std::ldexp(part.t1, 40)));
      const BezierCurve exact =
          restrict_exactly(before.curves.at(part.curve), part.t0, part.t1, after.degree);
      const std::vector<Point> row = row_of(after, part.a, part.b);
      ASSERT_EQ(row.size(), exact.poles.size());
      for (std::size_t i = 0; i < row.size(); ++i)
        EXPECT_LT((row[i] - exact.poles[i]).norm(), 2e-15);
      if (part.b == whole.b) break;
      EXPECT_EQ(part.b, edges[k + 1].a);
      EXPECT_EQ(part.t1, edges[k + 1].t0);
    }
    EXPECT_EQ(edges[k].t1, whole.t1);
    ++k;
  }
  EXPECT_EQ(k, edges.size());
}

std::vector<int> every(const CurvedMesh& mesh, int step) {
  std::vector<int> out;
  for (int t = 0; t < mesh.triangle_count(); t += step) out.push_back(t);
  return out;
}

struct Case {
  int degree;
  bool features;
  int step;
};

class Bisect : public testing::TestWithParam<Case> {};

TEST_P(Bisect, KeepsTheMapCutsTheChosenAndCoversTheCurves) {
  const Sample start = sample(GetParam().degree, GetParam().features);
  CurvedMesh mesh = start.mesh;
  std::size_t longer = 0;
  for (int round = 0; round < 3; ++round) {
    const CurvedMesh before = mesh;
    const std::vector<int> chosen = every(mesh, GetParam().step);
    bisect_triangles(mesh, chosen, std::vector<char>(mesh.vertex_count(), 0));
    EXPECT_EQ(check_mesh(mesh), std::vector<std::string>());
    expect_first_parts(before, mesh);
    expect_cut(before, mesh, chosen);
  }
  for (const Point& p : random_points(start.mesh, 4, 7))
    EXPECT_LT((map_at(start.mesh, p) - map_at(mesh, p)).norm(), 1e-13);
  for (std::size_t l = 0; l < mesh.loops.size(); ++l) {
    expect_covered(start, start.mesh.loops[l], mesh, mesh.loops[l]);
    longer += mesh.loops[l].size() - start.mesh.loops[l].size();
  }
  ASSERT_EQ(mesh.features.size(), start.mesh.features.size());
  for (std::size_t f = 0; f < mesh.features.size(); ++f) {
    expect_covered(start, start.mesh.features[f].edges, mesh, mesh.features[f].edges);
    EXPECT_GT(mesh.features[f].edges.size(), start.mesh.features[f].edges.size());
  }
  EXPECT_GT(longer, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, Bisect,
                         testing::Values(Case{3, false, 1}, Case{3, false, 7}, Case{4, false, 3},
                                         Case{5, false, 7}, Case{3, true, 2}, Case{4, true, 5}));

TEST(Bisect, NothingChosenChangesNothing) {
  const CurvedMesh before = sample(3, false).mesh;
  CurvedMesh after = before;
  bisect_triangles(after, {}, std::vector<char>(before.vertex_count(), 0));
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.nets, before.nets);
  EXPECT_EQ(after.control, before.control);
}

// Triangles (v, a, b) that are wide at v are cut from v to the middle of a, b, wherever their
// longest edge is.
TEST(Bisect, WideTrianglesOfAFanAreCutThroughItsCentre) {
  const CurvedMesh before = sample(3, false).mesh;
  int wide = 0, unlike = 0;
  for (int t = 0; t < before.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& corners = before.triangles[t];
      const int v = corners[k], a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const Point to_a = before.domain[a] - before.domain[v];
      const Point to_b = before.domain[b] - before.domain[v];
      const double angle = std::atan2(cross(to_a, to_b), to_a.dot(to_b)) * 180 / 3.14159265358979;
      if (angle < 25.5) continue;
      ++wide;
      std::vector<char> wide_at(before.vertex_count(), 0);
      wide_at[v] = 1;
      CurvedMesh after = before, plain = before;
      bisect_triangles(after, {t}, wide_at);
      const Point middle = 0.5 * (before.domain[a] + before.domain[b]);
      ASSERT_EQ(after.vertex_count(), before.vertex_count() + 1);
      EXPECT_LT((after.domain.back() - middle).norm(), 1e-15);
      std::set<int> first(after.triangles[t].begin(), after.triangles[t].end());
      EXPECT_TRUE(first.count(v) && first.count(before.vertex_count()));
      EXPECT_EQ(check_mesh(after), std::vector<std::string>());
      bisect_triangles(plain, {t}, std::vector<char>(before.vertex_count(), 0));
      unlike += plain.domain.back() != after.domain.back();
    }
  EXPECT_GT(wide, before.triangle_count());
  EXPECT_GT(unlike, 0);
}

// Right isosceles triangles around a point, each on the hypotenuse of the one before as its leg.
// From the smallest the way to the longest edge leads through all of them, and an edge has its turn
// only when the one behind it is cut. A chosen triangle is not worth that: four walks, then its own
// edge.
TEST(Bisect, WalksForAChosenTriangleAreFew) {
  constexpr int kTriangles = 7;
  std::vector<Point> points = {{0, 0}};
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> loop = {0};
  for (int k = 0; k <= kTriangles; ++k) {
    const std::complex<double> p = std::pow(std::complex<double>(1, 1), k);
    points.emplace_back(p.real(), p.imag());
    loop.push_back(k + 1);
    if (k < kTriangles) triangles.push_back({0, k + 1, k + 2});
  }
  const CurvedMesh before = testing_tools::straight_mesh(3, points, triangles, {loop});
  ASSERT_EQ(check_mesh(before), std::vector<std::string>());
  const std::vector<char> nowhere(before.vertex_count(), 0);
  CurvedMesh after = before;
  bisect_triangles(after, {0}, nowhere);
  EXPECT_EQ(check_mesh(after), std::vector<std::string>());
  expect_cut(before, after, {0});
  expect_first_parts(before, after);
  EXPECT_EQ(after.vertex_count(), before.vertex_count() + 5);
  // From the largest one cut is enough: its longest edge has nothing behind it.
  CurvedMesh last = before;
  bisect_triangles(last, {kTriangles - 1}, nowhere);
  EXPECT_EQ(last.vertex_count(), before.vertex_count() + 1);
  EXPECT_EQ(last.triangle_count(), before.triangle_count() + 1);
  EXPECT_LT((last.domain.back() - 0.5 * points.back()).norm(), 1e-14);
}

// z -> z^3 over triangles around an edge from 1 to exp(110 i degrees): its image turns by 330
// degrees and nearly closes, so its halves are longer than itself, also times the domain's halves.
// The blossom of z^3 is the product, so the nets are exact up to rounding. (Over triangles so large
// the coefficients of det J are not positive; bisection does not ask for it.)
TEST(Bisect, EndsWhereHalvesAreNotShorter) {
  using Complex = std::complex<double>;
  const double angle = 110 * 3.14159265358979 / 180;
  const std::vector<Complex> z = {1, std::polar(1.0, angle), std::polar(1.5, 0.5 * angle),
                                  std::polar(0.2, 0.5 * angle), std::polar(3.0, 0.1 * angle)};
  const auto halved = 0.5 * (z[0] + z[1]);
  ASSERT_GT(0.5 * std::abs(std::pow(halved, 3) - std::pow(z[0], 3)),
            std::abs(std::pow(z[1], 3) - std::pow(z[0], 3)));
  CurvedMesh mesh;
  mesh.degree = 3;
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}};
  std::map<std::vector<int>, int> ids;
  for (int v = 0; v < 5; ++v) {
    mesh.domain.emplace_back(z[v].real(), z[v].imag());
    mesh.control.emplace_back(std::pow(z[v], 3).real(), std::pow(z[v], 3).imag());
    ids[{v, v, v}] = v;
  }
  for (const auto& t : mesh.triangles)
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 3 - j; ++i) {
        std::vector<int> of(3 - i - j, t[0]);
        of.insert(of.end(), i, t[1]);
        of.insert(of.end(), j, t[2]);
        std::sort(of.begin(), of.end());
        const auto [at, added] = ids.try_emplace(of, static_cast<int>(mesh.control.size()));
        const Complex p = z[of[0]] * z[of[1]] * z[of[2]];
        if (added) mesh.control.emplace_back(p.real(), p.imag());
        mesh.nets.push_back(at->second);
      }
  mesh.warped.assign(3, 1);
  mesh.loops = {
      {{0, 4, 0, 0, 1}, {4, 2, 1, 0, 1}, {2, 1, 2, 0, 1}, {1, 3, 3, 0, 1}, {3, 0, 4, 0, 1}}};
  const auto sound = [](const CurvedMesh& m) {
    const auto wrong = check_mesh(m);
    return std::all_of(wrong.begin(), wrong.end(), [](const std::string& line) {
      return line.find("det coefficient") != std::string::npos;
    });
  };
  ASSERT_TRUE(sound(mesh));
  const std::vector<Point> places = random_points(mesh, 20, 3);
  for (int round = 0; round < 6; ++round) {
    const CurvedMesh before = mesh;
    const std::vector<int> chosen = every(mesh, 2);
    bisect_triangles(mesh, chosen, std::vector<char>(mesh.vertex_count(), 0));
    EXPECT_TRUE(sound(mesh));
    expect_first_parts(before, mesh);
    expect_cut(before, mesh, chosen);
  }
  for (const Point& p : places) {
    const Complex cubed = std::pow(Complex(p.x(), p.y()), 3);
    EXPECT_LT((map_at(mesh, p) - Point(cubed.real(), cubed.imag())).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace c1mesh
