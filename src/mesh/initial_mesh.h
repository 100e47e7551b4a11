// SPDX-License-Identifier: GPL-3.0-or-later
// The initial triangulation: regular, conforming, of proven distortion (paper, section 4.1).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/curved_mesh.h"

namespace c1mesh {

/// One curve of a loop in the normalised frame, raised to the working degree, directed with the
/// interior on its left. `curve` and `reversed` say where it comes from.
struct LoopCurve {
  BezierCurve bezier;
  int curve = -1;
  bool reversed = false;
};

/// Feature curves that follow one another between two ends, or closed (see FeaturePath).
struct FeatureInput {
  std::vector<LoopCurve> curves;
  bool closed = false;
};

/// One region to mesh: loops[0] counter-clockwise, the others clockwise; curve ends agree bit for
/// bit, those of features too.
struct MeshInput {
  int degree = 3;
  std::vector<std::vector<LoopCurve>> loops;
  std::vector<FeatureInput> features;
};

struct MeshOptions {
  double mips_bound = 10;  ///< mu
  /// Called now and then, if there is one; what it throws ends the work.
  std::function<void()> stop = {};
};

struct MeshReport {
  double mips_bound = 0;  ///< the bound that holds: max over triangles of max n_i / min d_i
  int warp_triangles = 0;
  int splits = 0;                  ///< how often an input curve was halved
  std::vector<std::string> notes;  ///< where mu had to be raised, and why
};

/// Triangulates one region. Every triangle t has g(t) <= report.mips_bound, the domain mesh is the
/// straight triangulation the warp elements were cut from (valid: positive areas, no overlap).
/// Throws NoMesh (mesh/no_mesh.h).
CurvedMesh initial_mesh(const MeshInput& input, const MeshOptions& options, MeshReport& report);

}  // namespace c1mesh
