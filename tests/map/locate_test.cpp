// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse of computed maps.
#include <gtest/gtest.h>

#include <thread>

#include "map/results.h"

namespace c1mesh {
namespace {

using testing_map::Chance;
using testing_map::result_of;

double extent(const Box& box) {
  return (box.high - box.low).maxCoeff();
}

class Locate : public testing::TestWithParam<std::pair<const char*, int>> {
 protected:
  const Result result = result_of(GetParam().first, GetParam().second);
  const Map map = Map(result);

  void undoes_the_map() const;  ///< inside, near edges and on them
  void none_outside() const;    ///< nor in holes
  void vertices_to_the_least() const;
  void many_threads() const;

  /// Is p inside by the polygon, holes counted? Sets `near` where the polygon is too near to tell.
  bool inside(const Point& p, bool& near) const {
    bool odd = false;
    near = false;
    for (const auto& [a, b] : polygon) {
      near = near || (p - a).norm() < 1e-3 * extent(map.shape_box()) + (b - a).norm();
      if ((a.y() > p.y()) != (b.y() > p.y()) && (cross(b - a, p - a) > 0) == (b.y() > a.y()))
        odd = !odd;
    }
    return odd;
  }

 private:
  /// Short pieces along the boundary.
  std::vector<std::pair<Point, Point>> polygon_of() const {
    constexpr int kPieces = 60;
    std::vector<std::pair<Point, Point>> pieces;
    for (const CurveEdge& edge : result.boundary_edges) {
      const auto on_curve = [&](int k) {
        const double t = edge.t0 + (edge.t1 - edge.t0) * k / kPieces;
        std::vector<Point> level = result.curves[edge.curve].poles;
        for (; level.size() > 1; level.pop_back())
          for (std::size_t i = 0; i + 1 < level.size(); ++i)
            level[i] = (1 - t) * level[i] + t * level[i + 1];
        return level[0];
      };
      for (int k = 0; k < kPieces; ++k) pieces.emplace_back(on_curve(k), on_curve(k + 1));
    }
    return pieces;
  }

 protected:
  const std::vector<std::pair<Point, Point>> polygon = polygon_of();
};

void Locate::undoes_the_map() const {
  Chance chance(1);
  const double domain = extent(map.domain_box());
  double worst = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const DomainPoint place = map.at(chance.below(map.triangles()), chance.place());
    const Point image = map.evaluate(place);
    const std::optional<DomainPoint> found = map.locate(image.x(), image.y());
    ASSERT_TRUE(found) << "triangle " << place.triangle;
    EXPECT_LE(found->triangle, place.triangle);
    if (place.barycentric.minCoeff() > 1e-6) {
      EXPECT_EQ(found->triangle, place.triangle);
    }
    EXPECT_LE((map.evaluate(*found) - image).norm(), 2 * map.shape_tolerance());
    worst = std::max(worst, (found->uv - place.uv).norm() / domain);
  }
  EXPECT_LT(worst, 1e-12);
}

void Locate::none_outside() const {
  Chance chance(2);
  const Box& box = map.shape_box();
  int in = 0, out = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Point p(box.low.x() + (1.2 * chance.number() - 0.1) * (box.high - box.low).x(),
                  box.low.y() + (1.2 * chance.number() - 0.1) * (box.high - box.low).y());
    bool near = false;
    const bool expected = inside(p, near);
    if (near) continue;
    ++(expected ? in : out);
    EXPECT_EQ(map.locate(p.x(), p.y()).has_value(), expected) << p.x() << ", " << p.y();
  }
  EXPECT_GT(in, 50);
  EXPECT_GT(out, 50);
}

void Locate::vertices_to_the_least() const {
  std::vector<int> least(result.domain_vertices.size(), -1);
  for (int t = map.triangles() - 1; t >= 0; --t)
    for (const int v : result.triangles[t]) least[v] = t;
  for (int t = 0; t < map.triangles(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Point image = map.evaluate(map.at(t, Barycentric(Barycentric::Unit(k))));
      const std::optional<DomainPoint> found = map.locate(image.x(), image.y());
      ASSERT_TRUE(found);
      EXPECT_EQ(found->triangle, least[result.triangles[t][k]]);
    }
}

void Locate::many_threads() const {
  const auto run = [&] {
    Chance chance(4);
    std::vector<DomainPoint> out;
    for (int trial = 0; trial < 500; ++trial) {
      const Point p = map.evaluate(map.at(chance.below(map.triangles()), chance.place()));
      out.push_back(map.locate(p.x(), p.y()).value_or(DomainPoint{}));
    }
    return out;
  };
  const std::vector<DomainPoint> expected = run();
  std::vector<std::vector<DomainPoint>> found(3);
  std::vector<std::thread> threads;
  for (auto& slot : found) threads.emplace_back([&] { slot = run(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& list : found)
    for (std::size_t k = 0; k < list.size(); ++k) {
      EXPECT_EQ(list[k].triangle, expected[k].triangle);
      EXPECT_EQ(list[k].barycentric, expected[k].barycentric);
    }
}

// One run for all, since making the map takes longer than all of them.
TEST_P(Locate, IsTheInverse) {
  undoes_the_map();
  none_outside();
  vertices_to_the_least();
  many_threads();
}

INSTANTIATE_TEST_SUITE_P(Examples, Locate,
                         testing::Values(std::pair("puzzle.svg", 3), std::pair("letter.svg", 3),
                                         std::pair("annulus.svg", 5),
                                         std::pair("interfaces.json", 3)),
                         [](const auto& info) {
                           const std::string name = info.param.first;
                           return name.substr(0, name.find('.')) +
                                  std::to_string(info.param.second);
                         });

}  // namespace
}  // namespace c1mesh
