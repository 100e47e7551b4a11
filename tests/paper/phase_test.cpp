// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "domain/apart.h"
#include "mesh/shapes.h"
#include "mesh/topology.h"
#include "paper/meshes.h"

namespace c1mesh {
namespace {

using namespace testing_tools;
using EdgeSet = std::set<std::pair<int, int>>;

EdgeSet ends_of(const std::vector<C1Edge>& edges) {
  EdgeSet out;
  for (const C1Edge& e : edges) out.insert(std::minmax(e.vertex[0], e.vertex[1]));
  EXPECT_EQ(out.size(), edges.size());
  return out;
}

// One inner vertex 4 of a square, and the triangle at the left alone not warped.
CurvedMesh four_triangles() {
  CurvedMesh mesh = straight_mesh(3, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}},
                                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, {{0, 1, 2, 3}});
  mesh.warped = {1, 0, 0, 0};
  return mesh;
}

TEST(ClassifyEdges, SoftOnesAreBesideAWarpedTriangle) {
  const CurvedMesh mesh = four_triangles();
  const AskedEdges asked = all_edges(mesh);
  EXPECT_EQ(ends_of(asked.soft), (EdgeSet{{0, 4}, {1, 4}}));
  EXPECT_EQ(ends_of(asked.hard), (EdgeSet{{2, 4}, {3, 4}}));
  // Each edge has its own control points, not another's.
  for (const auto* kind : {&asked.soft, &asked.hard})
    for (const C1Edge& e : *kind) {
      EXPECT_EQ(e.edge.front(), e.vertex[0]);
      EXPECT_EQ(e.edge.back(), e.vertex[1]);
    }
}

TEST(ClassifyEdges, ExceptionalEndsAndFeaturesAreLeftOut) {
  CurvedMesh mesh = four_triangles();
  const AskedEdges some = classify_edges(mesh, {0, 1, 1, 0, 0});
  EXPECT_EQ(ends_of(some.soft), (EdgeSet{{0, 4}}));
  EXPECT_EQ(ends_of(some.hard), (EdgeSet{{3, 4}}));
  const AskedEdges none = classify_edges(mesh, {0, 0, 0, 0, 1});
  EXPECT_TRUE(none.soft.empty() && none.hard.empty());
  mesh.features.push_back({{{0, 4, 9, 0, 0.5}, {4, 2, 9, 0.5, 1}}, false});
  const AskedEdges rest = all_edges(mesh);
  EXPECT_EQ(ends_of(rest.soft), (EdgeSet{{1, 4}}));
  EXPECT_EQ(ends_of(rest.hard), (EdgeSet{{3, 4}}));
  for (const C1Edge& e : rest.soft) EXPECT_EQ(e.edge.front(), e.vertex[0]);
}

struct Region {
  CurvedMesh mesh;
  AskedEdges asked;
  PhaseOptions options;
};

Region blob_region(bool domain_free) {
  Region out;
  MeshReport report;
  out.mesh = initial_mesh(test::input_of({test::blob(5, 0.2, 3)}), {}, report);
  out.asked = all_edges(out.mesh);
  out.options.weights.bound = 1000;
  out.options.smoothing[0] = 1e-3;
  out.options.smoothing[1] = 1e-6;
  out.options.iterations = 40;
  out.options.domain_free = domain_free;
  return out;
}

double largest_g(const CurvedMesh& mesh, const Pair& state) {
  const auto g = distortion_bounds(mesh, state.domain, state.control);
  return *std::max_element(g.begin(), g.end());
}

// What has to hold of every state: regular, under the bound, boundary as given bit for bit.
void expect_sound(const Region& region, const Pair& state) {
  EXPECT_LT(largest_g(region.mesh, state), region.options.weights.bound);
  const std::vector<char> fixed = fixed_control(region.mesh, region.mesh.control.size());
  for (std::size_t k = 0; k < fixed.size(); ++k)
    if (fixed[k]) {
      EXPECT_EQ(state.control[k], region.mesh.control[k]);
    }
}

class OneOrTwo : public testing::TestWithParam<bool> {};

TEST_P(OneOrTwo, ObjectiveFallsWhileTheSmoothingIsFixed) {
  const bool free = GetParam();
  const Region region = blob_region(free);
  Pair state = initial_pair(region.mesh);
  double smoothing = std::numeric_limits<double>::infinity(), last = 0, first = -1;
  int falls = 0, told = 0;
  std::set<double> levels;
  const PhaseObserver observer = [&](const PaperObjective& f, const Eigen::VectorXd& x,
                                     double step) {
    ++told;
    if (first < 0) first = f.terms(f.pack(initial_pair(region.mesh))).soft;
    if (f.weights.smoothing != smoothing) {
      EXPECT_LT(f.weights.smoothing, smoothing);
      smoothing = f.weights.smoothing;
      levels.insert(smoothing);
      last = std::numeric_limits<double>::infinity();
    }
    const double value = f.value(x);
    EXPECT_LE(value, last);
    EXPECT_EQ(value<last, step> 0 || !std::isfinite(last));
    falls += value < last;
    last = value;
    EXPECT_EQ(f.weights.bound, region.options.weights.bound);
  };
  run_phase(region.mesh, region.asked, region.options, state, Checkpoint([] {}), observer);
  EXPECT_LE(told, region.options.iterations);
  EXPECT_EQ(levels.size(), 4u);
  EXPECT_EQ(*levels.begin(), region.options.smoothing[1]);
  EXPECT_NEAR(*levels.rbegin(), region.options.smoothing[0], 1e-18);
  EXPECT_GT(falls, 8);
  expect_sound(region, state);
  const PaperObjective f(region.mesh, region.asked, state, free);
  EXPECT_LT(f.terms(f.pack(state)).soft, 0.7 * first);
  EXPECT_EQ(state.domain == domain_points(region.mesh), !free);
}

// Whatever the checkpoint throws is passed on, and leaves the state that was told of last.
TEST_P(OneOrTwo, AThrowingCheckpointLeavesTheLastState) {
  const Region region = blob_region(GetParam());
  for (const int allowed : {0, 1, 5, 12}) {
    Pair state = initial_pair(region.mesh), last = state;
    int calls = 0;
    const Checkpoint stop([&] {
      if (++calls > allowed) throw TimeLimitReached();
    });
    const PhaseObserver observer = [&](const PaperObjective& f, const Eigen::VectorXd& x, double) {
      last = f.unpack(x);
    };
    EXPECT_THROW(run_phase(region.mesh, region.asked, region.options, state, stop, observer),
                 TimeLimitReached);
    EXPECT_EQ(calls, allowed + 1);
    EXPECT_EQ(state.domain, last.domain);
    EXPECT_EQ(state.control, last.control);
    EXPECT_EQ(state.control == region.mesh.control, allowed == 0);
    expect_sound(region, state);
  }
}

TEST_P(OneOrTwo, IterationsAreALimit) {
  for (const int iterations : {0, 1, 3, 7}) {
    Region region = blob_region(GetParam());
    region.options.iterations = iterations;
    Pair state = initial_pair(region.mesh);
    int told = 0;
    run_phase(region.mesh, region.asked, region.options, state, Checkpoint([] {}),
              [&](const PaperObjective&, const Eigen::VectorXd&, double) { ++told; });
    EXPECT_LE(told, iterations);
    EXPECT_EQ(told == 0, iterations == 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Domain, OneOrTwo, testing::Bool(),
                         [](const auto& test) { return test.param ? "Free" : "Fixed"; });

// A tight bound is felt: g stays under it where it would not with a loose one.
TEST(Phase, BoundOnDistortionHoldsThroughout) {
  Region region = blob_region(true);
  Pair loose = initial_pair(region.mesh), tight = loose;
  run_phase(region.mesh, region.asked, region.options, loose, Checkpoint([] {}), {});
  const PaperObjective start(region.mesh, region.asked, tight, true);
  region.options.weights.bound = 1.05 * start.largest_distortion(start.pack(tight));
  ASSERT_LT(region.options.weights.bound, largest_g(region.mesh, loose));
  run_phase(region.mesh, region.asked, region.options, tight, Checkpoint([] {}),
            [&](const PaperObjective& f, const Eigen::VectorXd& x, double) {
              EXPECT_LT(f.largest_distortion(x), region.options.weights.bound);
            });
  expect_sound(region, tight);
  EXPECT_FALSE(tight.domain == domain_points(region.mesh));
}

// A spiral, whose windings are beside each other.
TEST(Phase, NoOverlapKeepsTheBoundarySimple) {
  Region region = blob_region(true);
  MeshReport report;
  region.mesh = initial_mesh(test::input_of({test::spiral(1.25)}), {}, report);
  region.asked = all_edges(region.mesh);
  region.options.no_overlap = true;
  region.options.iterations = 20;
  Pair state = initial_pair(region.mesh);
  ASSERT_FALSE(boundary_meets_itself(region.mesh, state.domain));
  run_phase(region.mesh, region.asked, region.options, state, Checkpoint([] {}), {});
  EXPECT_FALSE(boundary_meets_itself(region.mesh, state.domain));
  expect_sound(region, state);
  EXPECT_FALSE(state.domain == domain_points(region.mesh));
}

}  // namespace
}  // namespace c1mesh
