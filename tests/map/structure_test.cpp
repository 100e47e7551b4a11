// SPDX-License-Identifier: GPL-3.0-or-later
// What is no result is refused, with the kind of defect.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "c1mesh/error.h"
#include "c1mesh/map.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

DefectKind kind_after(const std::function<void(Result&)>& spoil) {
  Result result = example::square();
  spoil(result);
  try {
    const Map map(result);
  } catch (const InputError& error) {
    return error.defects().at(0).kind;
  }
  return DefectKind::note;
}

TEST(MapStructure, WhatIsWrongIsSaid) {
  EXPECT_EQ(kind_after([](Result&) {}), DefectKind::note);
  EXPECT_EQ(kind_after([](Result& r) { r = Result(); }), DefectKind::empty);
  EXPECT_EQ(kind_after([](Result& r) { r.triangles.clear(); }), DefectKind::empty);
  EXPECT_EQ(kind_after([](Result& r) { r.control_points.clear(); }), DefectKind::empty);
  EXPECT_EQ(kind_after([](Result& r) { r.degree = 4; }), DefectKind::malformed);
  EXPECT_EQ(kind_after([](Result& r) { r.degree = 0; }), DefectKind::malformed);
  EXPECT_EQ(kind_after([](Result& r) { r.triangle_control_points.pop_back(); }),
            DefectKind::malformed);
  EXPECT_EQ(kind_after([](Result& r) { r.triangles[0][1] = 4; }), DefectKind::malformed);
  EXPECT_EQ(kind_after([](Result& r) { r.triangle_control_points[0][2] = -1; }),
            DefectKind::malformed);
  EXPECT_EQ(kind_after([](Result& r) {
              r.control_points[0].x() = std::numeric_limits<double>::quiet_NaN();
            }),
            DefectKind::non_finite);
  EXPECT_EQ(kind_after([](Result& r) { r.domain_vertices[0].y() = 1e200; }),
            DefectKind::non_finite);
  EXPECT_EQ(kind_after([](Result& r) { r.domain_vertices[0] = r.domain_vertices[1]; }),
            DefectKind::unsupported);
}

TEST(MapStructure, TrianglesThatAreNotThere) {
  const Map map(example::square());
  EXPECT_THROW(map.at(2, Point(0, 0)), std::out_of_range);
  EXPECT_THROW(map.at(-1, Barycentric(1, 0, 0)), std::out_of_range);
  EXPECT_THROW(map.evaluate(DomainPoint{}), std::out_of_range);
  EXPECT_THROW(map.jet(DomainPoint{}), std::out_of_range);
}

// The map has its own copy, and copies of the map share it.
TEST(MapStructure, OutlivesItsResult) {
  const Map copy = [] {
    const Map map(example::square());
    return Map(map);
  }();
  EXPECT_LT((copy.evaluate(0.25, 0.5) - Point(0.25, 0.5)).norm(), 1e-15);
}

}  // namespace
}  // namespace c1mesh
