// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/trade_off.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>

#include "c1mesh/verify.h"
#include "domain/exceptional.h"
#include "mesh/topology.h"
#include "pipeline/assemble.h"
#include "pipeline/ladder.h"
#include "pipeline/mesh_region.h"
#include "pipeline/validate.h"

namespace c1mesh {
namespace {

constexpr int kMost = 12;          // vertices beyond the minimum
constexpr double kFall = 0.95;     // g falls if it gets below so much of the lowest so far
constexpr int kPatience = 2;       // so many vertices in a row may not lower it
constexpr double kNotRefined = 1;  // at most so many times the triangles
constexpr double kAnyG = 1e100;    // alpha for "the first map found": finite, and never exceeded

// Each region's mesh, how many places it is asked to give up C1 at, and the map found for that.
struct RegionState {
  CurvedMesh mesh;
  int places = 0;
  RegionSolution solution;
};

// The places that give up C1 anyway: branch points, in each of their paths, and the corners that
// polygons lack. The ladder counts places, not vertices, against what is allowed.
int fewest_places(const CurvedMesh& mesh, const Options& options) {
  const Joints joints = find_joints(mesh, options.corner_angle);
  return count_exceptional(
      place_exceptional(mesh, joints, natural_roles(joints), Placement::curvature));
}

// By nearest rank, as the spreads of the metrics.
double median(std::vector<double> values) {
  const auto middle = values.begin() + (static_cast<std::ptrdiff_t>(values.size()) - 1) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void mark_dominated(std::vector<TradeOffPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TradeOffPoint &a = points[i], &b = points[k];
      const bool equal = a.exceptional == b.exceptional && a.g == b.g;
      if (b.exceptional <= a.exceptional && b.g <= a.g && (!equal || k < i))
        points[i].dominated = true;
    }
}

class Search {
 public:
  Search(const Shape& shape, const Options& options, const Progress& progress)
      : shape_(shape),
        options_(options),
        progress_(progress),
        degree_(std::max(options.degree, shape.highest_degree())) {
    curve_.name = shape.name;
    curve_.bound = options.alpha * options.mips_bound;
  }

  TradeOff run() {
    for (std::size_t r = 0; r < shape_.regions.size(); ++r) {
      tell("initial mesh");
      MeshReport report;
      RegionState state;
      const auto stop = [&] { tell("initial mesh"); };
      state.mesh =
          mesh_region(shape_, static_cast<int>(r), degree_, {options_.mips_bound, stop}, report);
      state.places = fewest_places(state.mesh, options_);
      regions_.push_back(std::move(state));
    }
    climb();
    mark_dominated(curve_.points);
    return std::move(curve_);
  }

 private:
  void climb() {
    for (RegionState& region : regions_)
      if (!solve(region)) return;
    record(0);
    if (curve_.points.empty()) return;
    double lowest = curve_.points.back().g;
    int idle = 0;
    for (int more = 1; more <= kMost; ++more) {
      RegionState& worst = *std::max_element(
          regions_.begin(), regions_.end(),
          [](const RegionState& a, const RegionState& b) { return a.solution.g < b.solution.g; });
      const std::vector<int> before = worst.solution.exceptional;
      const double g_before = worst.solution.g;
      ++worst.places;
      if (!solve(worst)) return;
      // Nothing new: no place is left, or what was asked for last time had been exceeded.
      const bool same = worst.solution.exceptional == before && worst.solution.g == g_before;
      if (!same) record(more);
      const double g = curve_.points.back().g;
      idle = g < kFall * lowest ? 0 : idle + 1;
      lowest = std::min(lowest, g);
      if (idle == kPatience) return;
    }
    curve_.end = TradeOffEnd::most;
  }

  // False if the time limit came first.
  bool solve(RegionState& region) {
    Options settings = options_;
    settings.alpha = kAnyG;
    settings.exceptional = region.places;
    // Refinement stops at a fixed g and would level the curve: on one mesh the vertices alone
    // differ.
    if (settings.refine == 0) settings.refine = kNotRefined;
    const Checkpoint checkpoint = [&] {
      tell("trade-off");
      if (options_.time_limit > 0 && seconds() > options_.time_limit) throw TimeLimitReached();
    };
    region.solution = solve_region(region.mesh, settings, checkpoint, region.solution.first_roles);
    if (region.solution.interrupted) curve_.end = TradeOffEnd::time_limit;
    return !region.solution.interrupted;
  }

  void record(int more) {
    std::vector<RegionSolution> solutions;
    std::vector<double> bounds;
    for (const RegionState& region : regions_) {
      solutions.push_back(region.solution);
      const CurvedMesh& mesh = region.solution.mesh;
      for (int t = 0; t < mesh.triangle_count(); ++t) bounds.push_back(triangle_bound(mesh, t));
    }
    const Result result = assemble_result(shape_, solutions, options_, degree_);
    const VerifyReport report = verify(result, shape_);
    const Metrics& m = report.metrics;
    if (more == 0) {
      curve_.minimum = m.exceptional_minimum;
      curve_.parameters = result.parameters;
      std::erase_if(curve_.parameters, [](const auto& p) { return p.first == "exceptional"; });
    }
    TradeOffPoint point;
    point.asked = curve_.minimum + more;
    point.exceptional = m.exceptional;
    point.surplus = m.surplus;
    point.g = m.mips_bound_max;
    point.g_median = median(std::move(bounds));
    point.triangles = m.triangles;
    point.d_ei_max = m.d_ei.max;
    point.regular = report.regular();
    point.c1 = report.c1();
    curve_.points.push_back(point);
  }

  void tell(const char* stage) const {
    const double fraction =
        static_cast<double>(curve_.points.size()) / static_cast<double>(kMost + 1);
    if (progress_ && !progress_(stage, fraction)) throw Interrupted("cancelled");
  }

  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  const Shape& shape_;
  const Options& options_;
  const Progress& progress_;
  int degree_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<RegionState> regions_;
  TradeOff curve_;
};

}  // namespace

TradeOff trade_off(const Shape& shape, const Options& options, const Progress& progress) {
  validate(options);
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      options.threads > 0 ? options.threads : tbb::info::default_concurrency());
  return Search(shape, options, progress).run();
}

}  // namespace c1mesh
