// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/paper_solution.h"

#include <algorithm>

#include "domain/start.h"
#include "mesh/topology.h"
#include "optimise/stages.h"
#include "paper/paper_method.h"

namespace c1mesh {

RegionSolution solve_region_as_paper(const CurvedMesh& initial, const Options& options,
                                     const Checkpoint& checkpoint) {
  RegionSolution out;
  out.mesh = initial;
  out.joints = find_joints(initial, options.corner_angle);
  const PaperSolution solution = run_paper_method(initial, out.joints, options, checkpoint);
  set_domain(out.mesh, solution.state.domain);
  out.mesh.control = solution.state.control;
  for (int v = 0; v < out.mesh.vertex_count(); ++v)
    if (solution.exceptional[v]) out.exceptional.push_back(v);
  out.relaxed = solution.relaxed;
  out.remedies = solution.notes;
  out.interrupted = solution.interrupted;
  const std::vector<double> g =
      distortion_bounds(initial, solution.state.domain, solution.state.control);
  out.g = *std::max_element(g.begin(), g.end());
  return out;
}

}  // namespace c1mesh
