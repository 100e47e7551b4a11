// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "c1mesh/cost.h"
#include "check/stages.h"

namespace c1mesh {
namespace {

using detail::Arrangement;

bool harmless(const Defect& defect) {
  return defect.repaired || defect.kind == DefectKind::note;
}

bool usable(const std::vector<Defect>& defects) {
  return std::all_of(defects.begin(), defects.end(), harmless);
}

struct Checked {
  Arrangement arrangement;
  std::vector<Region> regions;
};

// All stages. Those that look at single curves and pairs run on whatever is left; nesting needs
// simple loops.
Checked run_stages(const Drawing& drawing, const CheckOptions& options) {
  Checked out;
  Arrangement& arrangement = out.arrangement;
  arrangement.defects = drawing.notes;
  {
    const StageTimer timer("check: curves");
    if (!detail::screen(drawing, arrangement)) return out;
    detail::drop_zero_length(arrangement);
    detail::respace_straight(arrangement);
    detail::remove_duplicates(arrangement);
    if (arrangement.curves.empty()) {
      arrangement.report(DefectKind::empty, {}, {}, "no curve has any length",
                         "give at least one closed loop");
      return out;
    }
  }
  std::optional<StageTimer> timer(std::in_place, "check: ends");
  detail::close_gaps(arrangement, options.gap_tolerance);
  detail::unite_ends(arrangement);
  detail::remove_near_copies(arrangement);
  arrangement.frame = detail::frame_of(arrangement.curves, arrangement.extent);
  timer.emplace("check: features");
  detail::Nodes nodes = detail::find_nodes(arrangement);
  detail::tell_features(arrangement, nodes);
  for (const auto stage : {&detail::attach_ends, &detail::cut_crossings})
    if (stage(arrangement, nodes, options.gap_tolerance)) {
      nodes = detail::find_nodes(arrangement);
      detail::tell_features(arrangement, nodes);
    }
  detail::report_copies(arrangement);
  detail::note_short(arrangement, nodes, options.gap_tolerance);
  timer.emplace("check: loops");
  const std::vector<Loop> loops = detail::join(arrangement, nodes);
  const std::vector<char> regular = detail::check_derivatives(arrangement);
  const std::vector<char> cusp = detail::check_joints(arrangement, nodes, regular);
  const detail::Pieces pieces = detail::cut(arrangement, nodes, regular);
  timer.emplace("check: intersections");
  detail::check_intersections(arrangement, nodes, pieces, cusp);
  timer.emplace("check: nesting");
  const std::vector<FeaturePath> features = detail::feature_paths(arrangement, nodes);
  detail::check_features(arrangement, nodes, loops, features, pieces);
  if (usable(arrangement.defects))
    out.regions = detail::nest(arrangement, loops, features, nodes, pieces);
  return out;
}

}  // namespace

bool CheckReport::usable() const {
  return c1mesh::usable(defects);
}

CheckReport check(const Drawing& drawing, const CheckOptions& options) {
  return {run_stages(drawing, options).arrangement.defects};
}

Shape make_shape(const Drawing& drawing, const CheckOptions& options) {
  Checked checked = run_stages(drawing, options);
  std::vector<Defect>& defects = checked.arrangement.defects;
  if (!usable(defects)) {
    // The first one becomes the exception's text.
    std::stable_partition(defects.begin(), defects.end(),
                          [](const Defect& defect) { return !harmless(defect); });
    throw InputError(std::move(defects));
  }
  Shape shape;
  shape.name = drawing.name;
  shape.curves = std::move(checked.arrangement.curves);
  shape.curve_ids = std::move(checked.arrangement.ids);
  shape.regions = std::move(checked.regions);
  shape.notes = std::move(defects);
  shape.frame = checked.arrangement.frame;
  return shape;
}

}  // namespace c1mesh
