// SPDX-License-Identifier: GPL-3.0-or-later
// The road of one drawing, from its curves to verified files: `run` and `batch` both go it.
#pragma once

#include <string>
#include <vector>

#include "app/console.h"
#include "app/run_options.h"
#include "app/status.h"
#include "c1mesh/result.h"
#include "c1mesh/shape.h"
#include "c1mesh/trace.h"

namespace c1mesh::app {

/// What became of a drawing whose result was written.
struct DrawingRun {
  Status status = Status::ok;
  Metrics metrics;
  std::vector<std::string> remedies;
  std::vector<std::string> missed;  ///< why the status is not ok, a sentence each
  std::vector<std::string> files;   ///< paths written
};

/// Checks, meshes, makes C1, verifies, writes, and says the summary; `drawing.name` names the
/// files. Throws what these throw, and WriteError; nothing was written then.
DrawingRun run_drawing(Console& console, const RunOptions& options, const std::string& input,
                       const Drawing& drawing, const Trace& trace = {});

}  // namespace c1mesh::app
