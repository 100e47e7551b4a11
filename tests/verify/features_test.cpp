// SPDX-License-Identifier: GPL-3.0-or-later
// What verification asks of feature edges, and how it counts.
#include <gtest/gtest.h>

#include <algorithm>

#include "c1mesh/verify.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

// The 5 x 5 vertices of a grid over the unit square; features run along its lines, where the
// identity maps edges to themselves.
Result grid() {
  return example::grid(4, 3, example::identity());
}

int at(int x, int y) {
  return 5 * y + x;
}

// The line through these vertices as one curve, cut evenly.
void add_line(Result& result, const std::vector<int>& vertices) {
  const int curve = static_cast<int>(result.curves.size());
  result.curves.push_back(
      {{result.domain_vertices[vertices.front()], result.domain_vertices[vertices.back()]}});
  const double pieces = static_cast<double>(vertices.size() - 1);
  for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
    result.feature_edges.push_back({vertices[k], vertices[k + 1], curve,
                                    static_cast<double>(k) / pieces,
                                    static_cast<double>(k + 1) / pieces});
    result.relaxed_edges.push_back({vertices[k], vertices[k + 1]});
  }
}

Verdict verdict_of(const Result& result, const std::string& item) {
  for (const VerifyItem& found : verify(result).items)
    if (found.name == item) return found.verdict;
  return Verdict::undecided;
}

TEST(VerifyFeatures, ALineAcrossTheSquare) {
  Result result = grid();
  add_line(result, {at(0, 2), at(1, 2), at(2, 2), at(3, 2), at(4, 2)});
  EXPECT_EQ(verdict_of(result, "exceptional vertices"), Verdict::invalid);  // its ends branch
  result.exceptional_vertices = {at(0, 2), at(4, 2)};
  const VerifyReport report = verify(result);
  EXPECT_TRUE(report.valid()) << report_text(report);
  EXPECT_EQ(report.metrics.exceptional_minimum, 2);
  EXPECT_EQ(report.metrics.surplus, 0);
}

TEST(VerifyFeatures, MustCoverTheirCurves) {
  Result result = grid();
  add_line(result, {at(1, 2), at(2, 2), at(3, 2)});
  EXPECT_TRUE(verify(result).valid());
  Result gap = result;
  gap.feature_edges.pop_back();
  EXPECT_EQ(verdict_of(gap, "coverage"), Verdict::invalid);
  Result off = result;
  off.curves.back().poles[1] += Point(0, 1e-6);
  EXPECT_EQ(verdict_of(off, "conformance"), Verdict::invalid);
  Result outside = result;
  outside.feature_edges[0].a = at(1, 0);  // not an edge of the mesh
  EXPECT_EQ(verdict_of(outside, "topology"), Verdict::invalid);
}

TEST(VerifyFeatures, CountWhatPolygonsLack) {
  // A dangling line costs nothing; a square loop has its corners; a line from a corner of the loop
  // to the rim makes two branch points.
  Result result = grid();
  add_line(result, {at(1, 1), at(2, 1), at(3, 1)});
  EXPECT_EQ(verify(result).metrics.exceptional_minimum, 0);
  add_line(result, {at(3, 1), at(3, 2), at(3, 3)});
  add_line(result, {at(3, 3), at(2, 3), at(1, 3)});
  add_line(result, {at(1, 3), at(1, 2), at(1, 1)});
  EXPECT_EQ(verify(result).metrics.exceptional_minimum, 0);
  add_line(result, {at(3, 3), at(4, 3)});
  EXPECT_EQ(verify(result).metrics.exceptional_minimum, 2);
  // With corners from 100 degrees on, the square has none: three for each loop, of which the branch
  // points, one on each, are two; the others must be found elsewhere.
  result.parameters = {{"corner_angle", 100.0}};
  EXPECT_EQ(verify(result).metrics.exceptional_minimum, 2 + 2 + 2);
}

}  // namespace
}  // namespace c1mesh
