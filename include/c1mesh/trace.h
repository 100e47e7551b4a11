// SPDX-License-Identifier: GPL-3.0-or-later
// What an optimisation does, iteration by iteration.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace c1mesh {

/// The state after one iteration; lengths and areas in the normalised frame (extent 1/2 to 1).
struct TraceRecord {
  int region = 0;        ///< of the shape, from 0
  int pass = 1;          ///< counts the attempts at the region, or the repetitions
  std::string stage;     ///< the active stage, e.g. "phase one"; a new name starts a new count
  int iteration = 0;     ///< within the stage, from 1
  double e_s = 0;        ///< E_s of eq. (4.2): sum of d_ei, un-smoothed, over the edges asked
  double e_reg = 0;      ///< E_reg of eq. (4.3); for the exact method the mean triangle energy
  double g = 0;          ///< max over triangles of g(t), eq. (4.5)
  double step = 0;       ///< step length taken, 0: none was possible
  int exceptional = -1;  ///< exceptional vertices of the state; -1: not determined yet
};

/// Called after every iteration, from the thread that runs the work; empty: nothing is recorded.
using Trace = std::function<void(const TraceRecord&)>;

/// A line of a trace file: a record, and the shape it belongs to.
struct TraceLine {
  std::string shape;   ///< the name of its result
  TraceRecord record;  ///< one iteration
};

/// The text of a trace file (docs/format.md): a JSON object for each line, in this order. What is
/// not finite is written as null.
std::string format_trace(const std::vector<TraceLine>& lines);

/// The inverse, null being infinite. Throws InputError that names the number of the first line that
/// is malformed.
std::vector<TraceLine> parse_trace(const std::string& text);

/// Is this the text of a trace? By its first line; the rest may be malformed.
bool is_trace(const std::string& text);

/// An SVG picture over the iterations counted through: E_s, below it g, below that E_reg, each on a
/// logarithmic axis; bands in the colours of the stages, lines between the passes. `width` in
/// pixels, at least 300.
std::string draw_trace(const std::string& title, const std::vector<TraceRecord>& records,
                       double width = 1200);

}  // namespace c1mesh
