// SPDX-License-Identifier: GPL-3.0-or-later
// The MFEM file, word by word for a square of two triangles; geometry is compared in tests/formats.
#include <gtest/gtest.h>

#include <sstream>

#include "c1mesh/write.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

TEST(Mfem, DomainOfASquareByHand) {
  EXPECT_EQ(format_mfem(example::square(), true),
            "MFEM mesh v1.0\n\ndimension\n2\n\n"
            "elements\n2\n1 2 0 1 2\n1 2 0 2 3\n\n"
            "boundary\n4\n1 1 0 1\n2 1 1 2\n3 1 2 3\n4 1 3 0\n\n"
            "vertices\n4\n2\n0 0\n1 0\n1 1\n0 1\n");
}

TEST(Mfem, ControlPointsOfASquareByHand) {
  const std::string text = format_mfem(example::square(2));
  EXPECT_EQ(text.substr(text.find("vertices")),
            "vertices\n4\n\nnodes\nFiniteElementSpace\nFiniteElementCollection: L2_T2_2D_P2\n"
            "VDim: 2\nOrdering: 1\n\n"
            "0 0\n0.5 0\n1 0\n0.5 0.5\n1 0.5\n1 1\n"
            "0 0\n0.5 0.5\n1 1\n0 0.5\n0.5 1\n0 1\n");
}

// Attributes: regions and curves, counted from 1; features are boundary elements too.
TEST(Mfem, AttributesAreRegionsAndCurves) {
  Result result = example::square();
  result.feature_edges.push_back({0, 2, 4, 0, 1});
  result.curves.push_back({{Point(0, 0), Point(1, 1)}});
  const std::string text = format_mfem(result, true);
  EXPECT_NE(text.find("boundary\n5\n1 1 0 1\n2 1 1 2\n3 1 2 3\n4 1 3 0\n5 1 0 2\n"),
            std::string::npos)
      << text;
  // Two triangles that share nothing are two regions.
  const Result apart = example::polynomial_result(3, example::identity(),
                                                  {{0, 0}, {1, 0}, {0, 1}, {5, 5}, {6, 5}, {5, 6}},
                                                  {{0, 1, 2}, {3, 4, 5}});
  EXPECT_NE(format_mfem(apart).find("elements\n2\n1 2 0 1 2\n2 2 3 4 5\n"), std::string::npos);
}

}  // namespace
}  // namespace c1mesh
