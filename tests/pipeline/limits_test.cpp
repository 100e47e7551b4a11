// SPDX-License-Identifier: GPL-3.0-or-later
// Large meshes: how much is tried, and that what is tried in vain leaves a valid map.
#include <gtest/gtest.h>

#include "pipeline/example_mesh.h"
#include "pipeline/ladder.h"

namespace c1mesh {
namespace {

using testing_pipeline::example_mesh;

TEST(SearchLimits, OneTryIsEnoughWhereItSucceeds) {
  const CurvedMesh mesh = example_mesh("puzzle.svg");
  SearchLimits limits;
  limits.tried_often = 0;
  const RegionSolution usual = solve_region(mesh, {}, {}),
                       once = solve_region(mesh, {}, {}, {}, limits);
  ASSERT_TRUE(usual.remedies.empty()) << "this shape takes more than one try";
  EXPECT_EQ(once.exceptional, usual.exceptional);
  EXPECT_EQ(once.g, usual.g);
}

TEST(SearchLimits, NoSearchAndOneThatIsCutShortLeaveTheInitialMesh) {
  const CurvedMesh mesh = example_mesh("puzzle.svg");
  SearchLimits none, short_one;
  none.searchable = mesh.triangle_count() - 1;
  short_one.tried_often = 0;
  short_one.iterations = 3;
  for (const SearchLimits& limits : {none, short_one}) {
    const RegionSolution solution = solve_region(mesh, {}, {}, {}, limits);
    EXPECT_TRUE(solution.gave_up);
    EXPECT_FALSE(solution.interrupted);
    EXPECT_EQ(solution.mesh.control, mesh.control);
    EXPECT_EQ(static_cast<int>(solution.exceptional.size()), mesh.vertex_count());
    ASSERT_EQ(solution.remedies.size(), 2u);
  }
}

// A time limit, or a caller's wish to stop, is still heard in the one try of a large mesh.
TEST(SearchLimits, DoNotHideTheTimeLimit) {
  SearchLimits limits;
  limits.tried_often = 0;
  const RegionSolution solution = solve_region(
      example_mesh("puzzle.svg"), {}, Checkpoint([] { throw TimeLimitReached(); }), {}, limits);
  EXPECT_TRUE(solution.interrupted);
}

}  // namespace
}  // namespace c1mesh
