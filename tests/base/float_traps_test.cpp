// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/float_traps.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

#include "base/parallel.h"

#ifdef __GLIBC__
namespace c1mesh {
namespace {

// Opaque to the compiler, which would else know the result.
double logarithm(double x) {
  volatile double opaque = x;
  return std::log(opaque);
}

TEST(FloatTrapsDeathTest, TestsEndOnANaN) {
  EXPECT_DEATH(logarithm(-1), "");
}

TEST(FloatTrapsDeathTest, TestsEndOnAPole) {
  EXPECT_DEATH(logarithm(0), "");
}

TEST(FloatTrapsDeathTest, TestsEndOnOverflow) {
  volatile double large = 1e200;
  EXPECT_DEATH(large = large * large, "");
}

TEST(FloatTraps, AreOffInAScopeAndOnAgainAfterIt) {
  ASSERT_EQ(fegetexcept() & kTrappedFloats, kTrappedFloats);
  {
    const FloatTrapsOff off;
    EXPECT_EQ(fegetexcept() & kTrappedFloats, 0);
    EXPECT_TRUE(std::isnan(logarithm(-1)));
    {
      const FloatTrapsOff twice;
      EXPECT_EQ(logarithm(0), -std::numeric_limits<double>::infinity());
    }
    EXPECT_EQ(fegetexcept() & kTrappedFloats, 0) << "the inner scope must not end the outer one";
  }
  EXPECT_EQ(fegetexcept() & kTrappedFloats, kTrappedFloats);
}

TEST(FloatTraps, ReachTheTasksOfParallelLoops) {
  std::vector<int> trapped(1000, 0);
  parallel_for(
      trapped.size(),
      [&](std::size_t k) {
        double sum = 0;
        for (int i = 1; i < 1000; ++i) sum += std::sqrt(i);  // long enough for others to help
        trapped[k] = sum > 0 ? fegetexcept() & kTrappedFloats : 0;
      },
      1);
  EXPECT_EQ(trapped, std::vector<int>(trapped.size(), kTrappedFloats));
}

// The rounding mode is a setting of the same register. A task that rounds upward, as the intervals
// of the verification do, must not leave that to a task that its thread takes up meanwhile, and a
// loop within an upward scope must not hand it on.
TEST(ParallelLoops, RoundToNearestInEveryTaskWhateverTheCallerDoes) {
  std::vector<int> outer(200, -1), inner(200 * 50, -1), after(200, -1);
  parallel_for(
      outer.size(),
      [&](std::size_t k) {
        outer[k] = std::fegetround();
        std::fesetround(FE_UPWARD);
        parallel_for(
            50, [&](std::size_t i) { inner[k * 50 + i] = std::fegetround(); }, 1);
        after[k] = std::fegetround();
        std::fesetround(FE_TONEAREST);
      },
      1);
  EXPECT_EQ(outer, std::vector<int>(outer.size(), FE_TONEAREST));
  EXPECT_EQ(inner, std::vector<int>(inner.size(), FE_TONEAREST));
  EXPECT_EQ(after, std::vector<int>(after.size(), FE_UPWARD)) << "the caller's own mode is lost";
}

// Short loops one after the other, whose items are at the same places: under the thread sanitizer
// it is seen whether each loop comes after what was before it.
TEST(ParallelLoops, ComeOneAfterTheOther) {
  double sum = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<double> values(200, 1);
    parallel_for(values.size(), [&](std::size_t k) { values[k] += static_cast<double>(k); });
    for (const double value : values) sum += value;
  }
  EXPECT_EQ(sum, 500 * (200 + 199 * 200 / 2));
}

}  // namespace
}  // namespace c1mesh
#endif
