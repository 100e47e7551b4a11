// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "domain/exceptional.h"
#include "mesh/split.h"
#include "mesh/topology.h"
#include "pipeline/demotion.h"

namespace c1mesh {
namespace {

// A mesh and what its boundary does; rungs that refine work on another one.
struct Variant {
  CurvedMesh mesh;
  Joints joints;
};

struct Best {
  Attempt attempt;
  const Variant* variant = nullptr;
  std::string how;
};

class Ladder {
 public:
  Ladder(const CurvedMesh& initial, const Options& options, const Checkpoint& checkpoint)
      : options_(options),
        checkpoint_(checkpoint),
        bound_(options.alpha * options.mips_bound),
        coarse_{initial, find_joints(initial, options.corner_angle)} {}

  RegionSolution climb() {
    RegionSolution out;
    try {
      search();
      if (!best_.variant) last_resort();
    } catch (const TimeLimitReached&) {
      out.interrupted = true;
    }
    write(out);
    return out;
  }

 private:
  bool satisfied() const { return best_.variant && best_.attempt.g <= bound_; }
  // The search ends when the work done exceeds this many triangle-attempts: a bound that does not
  // depend on the clock, so that results repeat.
  bool affordable(const Variant& variant) const {
    return work_ + variant.mesh.triangle_count() <= kWork || attempts_ < 2;
  }

  const Variant& refined() {
    if (!fine_) {
      fine_.emplace();
      fine_->mesh = coarse_.mesh;
      refine_uniform(fine_->mesh);
      fine_->joints = find_joints(fine_->mesh, options_.corner_angle);
    }
    return *fine_;
  }

  // True if the search may end.
  bool attempt(const Variant& variant, const Roles& roles, double wedge, const std::string& how) {
    if (!affordable(variant)) return true;
    work_ += variant.mesh.triangle_count();
    ++attempts_;
    AttemptOptions settings;
    settings.domain.weights.wedge = wedge;
    last_ = attempt_region(variant.mesh, variant.joints, roles, settings, checkpoint_);
    if (last_.success) consider(variant, how);
    return satisfied();
  }

  // Within the bound first, then the fewest exceptional vertices, then the lowest distortion.
  void consider(const Variant& variant, const std::string& how) {
    const auto rank = [&](const Attempt& a) {
      return std::make_tuple(!(a.g <= bound_), count_exceptional(a.roles), a.g);
    };
    if (best_.variant && !(rank(last_) < rank(best_.attempt))) return;
    best_ = {last_, &variant, how};
  }

  // The placement of missing corners whose domain stage ends lowest.
  Roles placed_roles() {
    const Roles natural = natural_roles(coarse_.joints);
    Roles best = place_exceptional(coarse_.mesh, coarse_.joints, natural, Placement::curvature);
    if (best == natural) return best;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Placement placement : {Placement::curvature, Placement::spread, Placement::shifted}) {
      const Roles roles = place_exceptional(coarse_.mesh, coarse_.joints, natural, placement);
      DomainReport report;
      DomainOptions settings;
      settings.final_exponent = 1;
      solve_domain(coarse_.mesh, coarse_.joints, roles, settings, report, checkpoint_);
      const double score = report.energy + (report.crossings ? 1e6 : 0);
      if (!report.valid || score >= lowest) continue;
      lowest = score;
      best = roles;
    }
    return best;
  }

  void search() {
    Roles roles = placed_roles();
    if (attempt(coarse_, roles, 30, "")) return;
    if (attempt(coarse_, roles, 300, "wedge weight 300")) return;
    const Variant& fine = refined();
    const Roles fine_roles = roles_on(coarse_.joints, roles, fine.joints);
    if (attempt(fine, fine_roles, 30, "refined 1 to 4")) return;
    if (attempt(fine, fine_roles, 300, "refined 1 to 4, wedge weight 300")) return;
    if (give_up_more(fine, fine_roles)) return;
    Roles every = place_exceptional(coarse_.mesh, coarse_.joints, roles, Placement::curvature);
    demote_all_joints(coarse_.joints, every);
    if (best_.variant) return;
    if (attempt(coarse_, every, 30, "every joint exceptional")) return;
    attempt(fine, roles_on(coarse_.joints, every, fine.joints), 30,
            "every joint exceptional, refined 1 to 4");
  }

  // One more exceptional vertex, then two, four, … near where the last try failed.
  bool give_up_more(const Variant& variant, Roles roles) {
    int total = 0;
    for (int count = 1; count <= 16; count *= 2) {
      if (options_.exceptional >= 0 && best_.variant) return true;
      const int changed = demote_near(variant.mesh, variant.joints, last_.trouble, count, roles);
      if (changed == 0) return false;
      total += changed;
      for (const double wedge : {30.0, 300.0}) {
        if (attempt(variant, roles, wedge,
                    fmt::format("refined 1 to 4, {} more exceptional", total)))
          return true;
        if (last_.success) break;
      }
    }
    return false;
  }

  void last_resort() {
    last_ = attempt_on_initial_domain(coarse_.mesh, coarse_.joints, {}, checkpoint_);
    if (last_.success) best_ = {last_, &coarse_, "every boundary vertex exceptional"};
  }

  void write(RegionSolution& out) const {
    if (!best_.variant) {
      give_up_everything(out);
      return;
    }
    out.mesh = best_.variant->mesh;
    out.joints = best_.variant->joints;
    for (int v = 0; v < out.mesh.vertex_count(); ++v)
      out.mesh.domain[v] = best_.attempt.domain.row(v).transpose();
    out.mesh.control = best_.attempt.control;
    out.g = best_.attempt.g;
    if (!best_.how.empty()) out.remedies.push_back(best_.how);
    std::vector<char> is_exceptional(out.mesh.vertex_count(), 0);
    for (std::size_t l = 0; l < out.joints.size(); ++l)
      for (std::size_t k = 0; k < out.joints[l].size(); ++k)
        if (best_.attempt.roles[l][k] == Role::exceptional) {
          is_exceptional[out.joints[l][k].vertex] = 1;
          out.exceptional.push_back(out.joints[l][k].vertex);
        }
    std::sort(out.exceptional.begin(), out.exceptional.end());
    for (const MeshEdge& e : MeshTopology(out.mesh).edges)
      if (e.triangle[1] >= 0 && (is_exceptional[e.a] || is_exceptional[e.b]))
        out.relaxed.push_back({e.a, e.b});
  }

  // The initial mesh as it is: valid by construction, C1 nowhere promised.
  void give_up_everything(RegionSolution& out) const {
    out.mesh = coarse_.mesh;
    out.joints = coarse_.joints;
    for (int v = 0; v < out.mesh.vertex_count(); ++v) out.exceptional.push_back(v);
    for (const MeshEdge& e : MeshTopology(out.mesh).edges)
      if (e.triangle[1] >= 0) out.relaxed.push_back({e.a, e.b});
    out.g = 0;
    for (int t = 0; t < out.mesh.triangle_count(); ++t)
      out.g = std::max(out.g, triangle_bound(out.mesh, t));
    out.remedies.emplace_back("the initial mesh, every vertex exceptional");
  }

  static constexpr long kWork = 12000;
  const Options& options_;
  const Checkpoint& checkpoint_;
  double bound_;
  Variant coarse_;
  std::optional<Variant> fine_;
  Attempt last_;
  Best best_;
  long work_ = 0;
  int attempts_ = 0;
};

}  // namespace

RegionSolution solve_region(const CurvedMesh& initial, const Options& options,
                            const Checkpoint& checkpoint) {
  return Ladder(initial, options, checkpoint).climb();
}

}  // namespace c1mesh
