// SPDX-License-Identifier: GPL-3.0-or-later
// Traces, line by line, and their plot.
#include "c1mesh/trace.h"

#include "fuzz/target.h"

C1MESH_FUZZ_TARGET(trace) {
  using namespace c1mesh;
  is_trace(bytes);
  std::vector<TraceLine> lines;
  if (!fuzz::accepted([&] { lines = parse_trace(bytes); }) || lines.empty()) return;
  const std::string text = format_trace(lines);
  fuzz::require(format_trace(parse_trace(text)) == text, "a trace does not read back");
  std::vector<TraceRecord> records;
  for (const TraceLine& line : lines)
    if (line.shape == lines[0].shape && line.record.region == lines[0].record.region)
      records.push_back(line.record);
  draw_trace("fuzz", records);
}
