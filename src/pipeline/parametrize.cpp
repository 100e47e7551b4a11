// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/parametrize.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "base/extent.h"
#include "c1mesh/cost.h"
#include "c1mesh/error.h"
#include "c1mesh/project.h"
#include "pipeline/assemble.h"
#include "pipeline/ladder.h"
#include "pipeline/mesh_region.h"
#include "pipeline/paper_solution.h"
#include "pipeline/region_trace.h"
#include "pipeline/validate.h"

namespace c1mesh {
namespace {

// Without an initial mesh there is no result at all: for that much longer than the time limit the
// work on it goes on.
constexpr double kMeshSeconds = 1;

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

bool within(const Outcome& outcome, const Options& options) {
  const Metrics& m = outcome.result.metrics;
  return outcome.report.valid() && !outcome.gave_up &&
         m.mips_bound_max <= distortion_asked(options) &&
         !(options.no_overlap && m.domain_overlaps) &&
         (options.exceptional < 0 || m.exceptional <= options.exceptional);
}

// The projection may cost the map its regularity; then it is left undone, and C1 claimed in vain.
void project_outcome(const Shape& shape, Outcome& outcome) {
  const Projection projection = project(outcome.result);
  VerifyReport report = verify(projection.result, shape, claimed_bounds(projection.result));
  if (!report.regular()) {
    outcome.remedies.emplace_back("not projected: triangles would be inverted");
    outcome.gave_up = true;
    return;
  }
  outcome.remedies.push_back(fmt::format("projected: a control point moved by {:.1e} of the extent",
                                         projection.largest_move));
  outcome.result = projection.result;
  outcome.report = std::move(report);
}

// A result that rounding to the input's coordinates has spoilt is the input's defect: the map was
// regular in the normalised frame.
void refuse_coarse_coordinates(const Shape& shape, const Outcome& outcome) {
  if (outcome.report.regular()) return;
  constexpr double kCoarse = 1e-11;
  double largest = 0;
  std::vector<Point> poles;
  for (const BezierCurve& curve : shape.curves)
    for (const Point& p : curve.poles) {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
      poles.push_back(p);
    }
  const double step = std::numeric_limits<double>::epsilon() * largest / extent_of(poles);
  if (!(step > kCoarse)) return;
  Defect defect;
  defect.kind = DefectKind::limit;
  defect.message = fmt::format(
      "the coordinates are too coarse: rounding moves points by {:.1e} of the extent, and "
      "triangles of the map would not be regular",
      step);
  defect.where = {poles.front()};
  defect.remedy = "move the shape towards the origin";
  throw InputError({defect});
}

}  // namespace

Outcome parametrize(const Shape& shape, const Options& options, const Progress& progress,
                    const Trace& trace) {
  validate(options);
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      options.threads > 0 ? options.threads : tbb::info::default_concurrency());
  const Clock clock;
  const int degree = std::max(options.degree, shape.highest_degree());
  const std::size_t count = shape.regions.size();
  Outcome outcome;
  std::vector<RegionSolution> regions;
  double mesh_seconds = 0, map_seconds = 0;
  for (std::size_t r = 0; r < count; ++r) {
    const auto tell = [&](const char* stage, double part) {
      const double fraction = (static_cast<double>(r) + part) / static_cast<double>(count);
      if (progress && !progress(stage, 0.95 * fraction)) throw Interrupted("cancelled");
    };
    tell("initial mesh", 0);
    Clock stage;
    MeshReport report;
    const auto stop_mesh = [&] {
      tell("initial mesh", 0);
      if (options.time_limit > 0 && clock.seconds() > options.time_limit + kMeshSeconds)
        throw Interrupted("the time limit came before the initial mesh was complete");
    };
    const CurvedMesh mesh =
        mesh_region(shape, static_cast<int>(r), degree, {options.mips_bound, stop_mesh}, report);
    mesh_seconds += stage.seconds();
    outcome.remedies.insert(outcome.remedies.end(), report.notes.begin(), report.notes.end());

    stage = Clock();
    int steps = 0;
    const auto stop = [&] {
      // How long the search takes is not known; the bar approaches the end without reaching it.
      tell("optimising", 1 - 1 / (1 + 0.01 * ++steps));
      if (options.time_limit > 0 && clock.seconds() > options.time_limit) throw TimeLimitReached();
    };
    const Checkpoint checkpoint(stop, trace_of_region(trace, static_cast<int>(r)));
    const StageTimer timer("map: rest");
    regions.push_back(options.method == Method::paper
                          ? solve_region_as_paper(mesh, options, checkpoint)
                          : solve_region(mesh, options, checkpoint));
    map_seconds += stage.seconds();
    outcome.time_limit_hit |= regions.back().interrupted;
    outcome.gave_up |= regions.back().gave_up;
    for (const std::string& remedy : regions.back().remedies)
      outcome.remedies.push_back(count > 1 ? fmt::format("region {}: {}", r, remedy) : remedy);
  }
  if (progress && !progress("verifying", 0.96)) throw Interrupted("cancelled");
  const Clock stage;
  std::optional<StageTimer> timer(std::in_place, "assembly");
  outcome.result = assemble_result(shape, regions, options, degree);
  timer.reset();
  outcome.report = verify(outcome.result, shape, claimed_bounds(outcome.result));
  refuse_coarse_coordinates(shape, outcome);
  if (options.project) project_outcome(shape, outcome);
  outcome.result.metrics = outcome.report.metrics;
  outcome.seconds = {{"mesh", mesh_seconds},
                     {"map", map_seconds},
                     {"verify", stage.seconds()},
                     {"total", clock.seconds()}};
  outcome.within_bounds = within(outcome, options);
  if (progress) progress("done", 1);
  return outcome;
}

}  // namespace c1mesh
