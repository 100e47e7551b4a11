// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/cost.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "c1mesh/c1mesh.h"

namespace c1mesh {
namespace {

void work(double seconds) {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
         seconds) {
  }
}

const StageCost& cost_of(const CostLedger& ledger, const std::string& stage) {
  for (const StageCost& cost : ledger.stages())
    if (cost.stage == stage) return cost;
  throw std::out_of_range(stage);
}

// Each comparison holds however the machine is loaded.
TEST(Cost, AStageWithinAnotherIsTakenAwayFromIt) {
  CostLedger ledger;
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  double within = 0, around = -now();
  {
    const CostRecording recording(ledger);
    const StageTimer outer("outer");
    within -= now();
    for (int k = 0; k < 2; ++k) {
      const StageTimer inner("inner");
      work(0.01);
    }
    within += now();
  }
  around += now();
  ASSERT_EQ(ledger.stages().size(), 2u);
  EXPECT_EQ(ledger.stages()[0].stage, "inner");  // ended first
  const StageCost &inner = cost_of(ledger, "inner"), &outer = cost_of(ledger, "outer");
  EXPECT_GE(inner.wall, 0.02);
  EXPECT_GT(inner.cpu, 0);
  constexpr double kRounding = 1e-9;  // of clocks counted from long ago
  EXPECT_GE(inner.wall + outer.wall, within - kRounding);
  // Had the inner stage not been taken away, the sum would exceed this by the inner stage.
  EXPECT_LE(inner.wall + outer.wall, around + kRounding);
}

TEST(Cost, NothingIsRecordedUnlessAsked) {
  CostLedger ledger;
  { const CostRecording recording(ledger); }
  { const StageTimer timer("later"); }
  EXPECT_TRUE(ledger.stages().empty());
}

TEST(Cost, TheStagesOfARunAreNamedAndItsBytesStayTheSame) {
  const Shape shape = make_shape(read_drawings(C1MESH_EXAMPLES "/letter.svg").at(0));
  const std::string silent = format_result(parametrize(shape).result);
  CostLedger ledger;
  const CostRecording recording(ledger);
  EXPECT_EQ(format_result(parametrize(shape).result), silent);
  for (const char* stage : {"mesh: warp triangles", "map: domain", "map: exact stage",
                            "verify: regularity", "verify: boundary simple", "assembly"})
    EXPECT_GE(cost_of(ledger, stage).cpu, 0) << stage;
  EXPECT_GT(peak_memory(), 1e6);
}

}  // namespace
}  // namespace c1mesh
