// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>

#include "domain/exceptional.h"
#include "mesh/split.h"
#include "mesh/topology.h"
#include "optimise/refine.h"
#include "optimise/tracing.h"
#include "pipeline/demotion.h"

namespace c1mesh {
namespace {

// The end of a large mesh's search.
struct IterationsSpent {};

// A mesh and what its boundary does; rungs that refine work on another one.
struct Variant {
  CurvedMesh mesh;
  Joints joints;
  DomainShape warm;  // the last valid domain found on this mesh: a start for every later try
};

struct Best {
  bool found = false;
  Attempt attempt;
  CurvedMesh mesh;
  Joints joints;
  Variant* variant = nullptr;  // where it was found; its mesh may have been refined since
  Roles roles;                 // on the variant's mesh
  std::string how;
};

class Ladder {
 public:
  Ladder(const CurvedMesh& initial, const Options& options, const Checkpoint& checkpoint,
         const Roles& start, const SearchLimits& limits)
      : options_(options),
        limits_(limits),
        checkpoint_(bounded(checkpoint.marked([this](TraceRecord& r) { r.pass = pass_; }))),
        bound_(options.alpha * options.mips_bound),
        coarse_{initial, find_joints(initial, options.corner_angle), {}},
        first_roles_(start) {}

  RegionSolution climb() {
    RegionSolution out;
    if (coarse_.mesh.triangle_count() > limits_.searchable) {
      write(out);
      out.remedies.push_back(
          fmt::format("more than {} triangles: no search for a C1 map", limits_.searchable));
      return out;
    }
    try {
      search();
      if (!best_.found && many_tries()) release_joints();
      if (satisfied()) restore();
      if (best_.found) polish();
      if (!best_.found && many_tries()) last_resort();
    } catch (const TimeLimitReached&) {
      out.interrupted = true;
    } catch (const IterationsSpent&) {
      out.remedies.push_back(fmt::format("more than {} triangles: no search beyond {} iterations",
                                         limits_.tried_often, limits_.iterations));
    }
    write(out);
    return out;
  }

 private:
  // The same with a bound for the one try of a large mesh: it is near from the start or far for
  // ever, and its iterations take long.
  Checkpoint bounded(Checkpoint checkpoint) {
    checkpoint.stop = [this, stop = checkpoint.stop] {
      if (stop) stop();
      if (!many_tries() && ++iterations_ > limits_.iterations) throw IterationsSpent{};
    };
    return checkpoint;
  }

  bool many_tries() const { return coarse_.mesh.triangle_count() <= limits_.tried_often; }
  bool satisfied() const { return best_.found && best_.attempt.g <= bound_; }
  // The search ends when the work done exceeds this many triangle-attempts: a bound that does not
  // depend on the clock, so that results repeat.
  bool affordable(const Variant& variant) const {
    return work_ + variant.mesh.triangle_count() <= kWork || attempts_ < 2;
  }

  // A finer variant: the same cuts through the initial pair and through the last domain found.
  template <class Refine>
  Variant& refined(const Refine& refine) {
    Variant& fine = finer_.emplace_back();
    fine.mesh = coarse_.mesh;
    refine(fine.mesh);
    fine.joints = find_joints_again(fine.mesh, coarse_.joints);
    if (!coarse_.warm.empty()) {
      CurvedMesh solved = coarse_.mesh;
      set_domain(solved, coarse_.warm.points);
      refine(solved);
      fine.warm.bends = coarse_.warm.bends;
      fine.warm.points = domain_points(solved);
    }
    return fine;
  }

  struct Settings {
    double wedge = 30;
    bool loose = false;  // the joint stage's domain follows more freely
  };

  // True if the search may end.
  bool attempt(Variant& variant, const Roles& roles, const Settings& wanted,
               const std::string& how) {
    if (!affordable(variant)) return true;
    work_ += variant.mesh.triangle_count();
    ++attempts_;
    begin_pass();
    AttemptOptions settings;
    settings.domain.weights.wedge = wanted.wedge;
    settings.domain.warm = variant.warm;
    if (wanted.loose) {
      settings.joint.rho = 100;
      settings.joint.domain_quality = 0.3;
    }
    settings.no_overlap = settings.domain.no_overlap = options_.no_overlap;
    last_ = attempt_region(variant.mesh, variant.joints, roles, settings, checkpoint_);
    if (last_.domain_valid) variant.warm = last_.domain_stage;
    if (last_.success) consider(variant, how);
    return satisfied();
  }

  // Refined if its distortion exceeds the bound. Within the bound first, then the fewest
  // exceptional vertices, then the lowest distortion.
  void consider(Variant& variant, const std::string& how) {
    Best next{true, last_, variant.mesh, variant.joints, &variant, last_.roles, how};
    RefineOptions settings;
    settings.target = bound_;
    if (options_.refine > 0) settings.growth = options_.refine;
    refine(next, settings);
    if (next.attempt.g > bound_) {
      // Not reached: a lower aim takes more triangles at a time.
      settings.target = RefineOptions().target;
      refine(next, settings);
    }
    const auto rank = [&](const Attempt& a) {
      return std::make_tuple(!(a.g <= bound_), count_exceptional(a.roles), a.g);
    };
    if (best_.found && !(rank(next.attempt) < rank(best_.attempt))) return;
    best_ = std::move(next);
  }

  void refine(Best& best, const RefineOptions& settings) {
    const int before = best.mesh.triangle_count();
    refine_where_distorted(settings, {}, best.mesh, best.joints, best.attempt, checkpoint_);
    work_ += best.mesh.triangle_count() - before;
  }

  // The last step: lower than the bound asks, as far as triangles may be spent on it.
  void polish() {
    RefineOptions settings;
    if (options_.refine > 0) settings = {0, options_.refine, 2 * settings.rounds};
    settings.growth *=
        static_cast<double>(best_.variant->mesh.triangle_count()) / best_.mesh.triangle_count();
    refine(best_, settings);
  }

  // For a trace an attempt begins with what is tried to place its corners.
  void begin_pass() {
    if (!placing_) ++pass_;
    placing_ = false;
    iterations_ = 0;
  }

  void solve_placed(const Roles& roles, const DomainOptions& settings, DomainReport& report) {
    if (!placing_) ++pass_;
    placing_ = true;
    iterations_ = 0;
    solve_domain(coarse_.mesh, coarse_.joints, roles, settings, report,
                 traced_domain(traced_roles(checkpoint_, coarse_.joints, roles), "placement",
                               coarse_.mesh, coarse_.joints, roles));
  }

  // The placement of missing corners whose domain stage ends lowest.
  Roles placed_roles() {
    const Roles natural = natural_roles(coarse_.joints);
    Roles best = place_exceptional(coarse_.mesh, coarse_.joints, natural, Placement::curvature);
    if (best == natural) return best;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Placement placement :
         {Placement::curvature, Placement::tips, Placement::spread, Placement::shifted}) {
      const Roles roles = place_exceptional(coarse_.mesh, coarse_.joints, natural, placement);
      DomainReport report;
      DomainOptions settings;
      settings.final_exponent = 1;
      solve_placed(roles, settings, report);
      const double score = report.energy + (report.crossings ? 1e6 : 0);
      if (!report.valid || score >= lowest) continue;
      lowest = score;
      best = roles;
    }
    return best;
  }

  void search() {
    Roles roles = first_roles_.empty() ? placed_roles() : first_roles_;
    while (count_exceptional(roles) < options_.exceptional && add_corner(roles)) {
    }
    first_roles_ = roles;
    if (attempt(coarse_, roles, {30}, "") || !many_tries()) return;
    if (!last_.success && attempt(coarse_, roles, {30, true}, "loose joint stage")) return;
    if (attempt(coarse_, roles, {300}, "wedge weight 300")) return;
    Variant* last = &coarse_;
    std::string prefix;
    if (has_c1_corner(coarse_.joints, roles)) {
      last = &refined([&](CurvedMesh& mesh) { grade_corners(mesh, coarse_.joints, roles, 2); });
      prefix = "refined towards corners";
      if (both_wedges(*last, roles, prefix)) return;
    }
    if (coarse_.mesh.triangle_count() <= kRefinable) {
      Variant& fine = refined([](CurvedMesh& mesh) { refine_uniform(mesh); });
      if (both_wedges(fine, roles, "refined 1 to 4")) return;
      if (last == &coarse_) {
        last = &fine;
        prefix = "refined 1 to 4";
      }
    }
    if (best_.found && options_.exceptional >= 0) return;
    if (best_.found && add_corners(roles)) return;
    give_up_more(*last, roles, prefix);
  }

  // More exceptional vertices, ever more, by turns: corners where they help the domain most, and
  // vertices released near the trouble. What of them was not needed, `restore` takes back.
  void give_up_more(Variant& variant, Roles placed, const std::string& prefix) {
    constexpr int kMost = 16;
    Roles roles = roles_on(coarse_.joints, placed, variant.joints);
    const std::string start = prefix.empty() ? "" : prefix + ", ";
    for (int count = 1, added = 0, given_up = 0; count <= kMost; count *= 2) {
      if (best_.found && options_.exceptional >= 0) return;
      while (added < count && add_corner(placed)) ++added;
      add_what_gives_up(roles_on(coarse_.joints, placed, variant.joints), roles);
      const auto how = [&] {
        std::string text = fmt::format("{}{} more exceptional by placement", start, added);
        if (given_up > 0) text += fmt::format(", {} near the trouble", given_up);
        return text;
      };
      if (both_wedges_on(variant, roles, how())) return;
      given_up += demote_near(variant.mesh, variant.joints, last_.trouble, count, roles);
      if (both_wedges_on(variant, roles, how())) return;
    }
  }

  static void add_what_gives_up(const Roles& from, Roles& roles) {
    for (std::size_t l = 0; l < roles.size(); ++l)
      for (std::size_t k = 0; k < roles[l].size(); ++k)
        if (gives_up_c1(from[l][k]) && !gives_up_c1(roles[l][k])) roles[l][k] = from[l][k];
  }

  // What was given up by the half dozen may not all have been needed: tries without ever smaller
  // parts of it.
  void restore() {
    constexpr int kTries = 14;
    work_ = kWork / 3;  // less than the search may do
    Variant& variant = *best_.variant;
    const Roles first = roles_on(coarse_.joints, first_roles_, variant.joints);
    const std::string how = best_.how + ", some of them restored";
    int tries = 0;
    for (std::size_t part = extra(first).size() / 2; part > 0; part /= 2)
      for (std::size_t at = 0; at < extra(first).size() && tries < kTries;) {
        if (!affordable(variant)) return;
        const auto places = extra(first);
        Roles roles = best_.roles;
        for (std::size_t i = at; i < std::min(at + part, places.size()); ++i)
          roles[places[i].loop][places[i].position] = first[places[i].loop][places[i].position];
        ++tries;
        attempt(variant, roles, {30}, how);
        if (extra(first).size() == places.size()) at += part;
      }
  }

  // Where the best so far gives up C1 and `first` does not.
  std::vector<Place> extra(const Roles& first) const {
    std::vector<Place> out;
    for (std::size_t l = 0; l < first.size(); ++l)
      for (std::size_t k = 0; k < first[l].size(); ++k)
        if (gives_up_c1(best_.roles[l][k]) && !gives_up_c1(first[l][k]))
          out.push_back({static_cast<int>(l), static_cast<int>(k)});
    return out;
  }

  // A map exists but its distortion is above the bound: more corners for the domain, one after the
  // other, each where it helps the domain stage most.
  bool add_corners(Roles roles) {
    constexpr int kMost = 8;
    for (int added = 1; added <= kMost && add_corner(roles); ++added) {
      const std::string how = fmt::format("{} more exceptional by placement", added);
      if (attempt(coarse_, roles, {30}, how)) return true;
      if (!last_.success && attempt(coarse_, roles, {30, true}, how + ", loose joint stage"))
        return true;
    }
    return false;
  }

  // False if there is no place left.
  bool add_corner(Roles& roles) {
    constexpr int kCandidates = 4;
    double lowest = std::numeric_limits<double>::infinity();
    Roles best;
    for (const Roles& candidate : one_more(coarse_.mesh, coarse_.joints, roles, kCandidates)) {
      DomainReport report;
      DomainOptions settings;
      settings.warm = coarse_.warm;
      solve_placed(candidate, settings, report);
      const double score = report.largest + (report.crossings ? 1e6 : 0);
      if (!report.valid || score >= lowest) continue;
      lowest = score;
      best = candidate;
    }
    if (best.empty()) return false;
    roles = best;
    return true;
  }

  // On the mesh as it was, ever more vertices near the trouble, at last every joint. A budget of
  // its own: what it reaches beats the last resort by far.
  void release_joints() {
    work_ = attempts_ = 0;
    Roles roles = first_roles_;
    int total = 0;
    for (int count = 1 + coarse_.mesh.triangle_count() / 200; !best_.found; count *= 2) {
      const int changed = demote_near(coarse_.mesh, coarse_.joints, last_.trouble, count, roles);
      if (changed == 0) break;
      total += changed;
      if (both_wedges_on(coarse_, roles, fmt::format("{} more exceptional", total))) return;
    }
    if (best_.found) return;
    demote_all_joints(coarse_.joints, roles);
    work_ = attempts_ = 0;
    attempt(coarse_, roles, {30}, "every joint exceptional");
  }

  bool both_wedges(Variant& variant, const Roles& coarse_roles, const std::string& how) {
    const Roles roles = roles_on(coarse_.joints, coarse_roles, variant.joints);
    return attempt(variant, roles, {30}, how) ||
           attempt(variant, roles, {300}, how + ", wedge weight 300");
  }

  // The heavier wedges only where the lighter ones failed.
  bool both_wedges_on(Variant& variant, const Roles& roles, const std::string& how) {
    if (attempt(variant, roles, {30}, how)) return true;
    return !last_.success && attempt(variant, roles, {300}, how + ", wedge weight 300");
  }

  void last_resort() {
    begin_pass();
    last_ = attempt_on_initial_domain(coarse_.mesh, coarse_.joints, {}, checkpoint_);
    if (last_.success)
      best_ = {true,
               last_,
               coarse_.mesh,
               coarse_.joints,
               &coarse_,
               last_.roles,
               "every boundary vertex exceptional"};
    gave_up_ = true;
  }

  void write(RegionSolution& out) const {
    out.gave_up = gave_up_ || !best_.found;
    out.first_roles = first_roles_;
    if (!best_.found) {
      give_up_everything(out);
      return;
    }
    out.mesh = best_.mesh;
    out.joints = best_.joints;
    set_domain(out.mesh, best_.attempt.domain.points);
    out.mesh.control = best_.attempt.control;
    out.g = best_.attempt.g;
    if (!best_.how.empty()) out.remedies.push_back(best_.how);
    std::vector<char> is_exceptional(out.mesh.vertex_count(), 0);
    for (std::size_t l = 0; l < out.joints.size(); ++l)
      for (std::size_t k = 0; k < out.joints[l].size(); ++k)
        if (gives_up_c1(best_.attempt.roles[l][k])) {
          is_exceptional[out.joints[l][k].vertex] = 1;
          out.exceptional.push_back(out.joints[l][k].vertex);
        }
    std::sort(out.exceptional.begin(), out.exceptional.end());
    // Branch points are in several paths.
    out.exceptional.erase(std::unique(out.exceptional.begin(), out.exceptional.end()),
                          out.exceptional.end());
    const MeshTopology topology(out.mesh);
    const std::vector<char> feature = feature_flags(out.mesh, topology);
    for (std::size_t i = 0; i < topology.edges.size(); ++i) {
      const MeshEdge& e = topology.edges[i];
      if (e.triangle[1] >= 0 && (is_exceptional[e.a] || is_exceptional[e.b] || feature[i]))
        out.relaxed.push_back({e.a, e.b});
    }
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
  static constexpr int kRefinable = 300;  // larger meshes are not refined as a whole
  const Options& options_;
  const SearchLimits limits_;
  const Checkpoint checkpoint_;
  double bound_;
  Variant coarse_;
  std::list<Variant> finer_;  // a list: best_ points into it
  Roles first_roles_;
  Attempt last_;
  Best best_;
  bool gave_up_ = false;
  long work_ = 0;
  int attempts_ = 0;
  int iterations_ = 0;    // of a try, or of a placement; counted for large meshes alone
  int pass_ = 0;          // counts the attempts, for a trace
  bool placing_ = false;  // the pass has begun, its attempt has not
};

}  // namespace

RegionSolution solve_region(const CurvedMesh& initial, const Options& options,
                            const Checkpoint& checkpoint, const Roles& start,
                            const SearchLimits& limits) {
  return Ladder(initial, options, checkpoint, start, limits).climb();
}

}  // namespace c1mesh
