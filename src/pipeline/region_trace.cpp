// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/region_trace.h"

#include <memory>

namespace c1mesh {

Trace trace_of_region(const Trace& trace, int region) {
  if (!trace) return {};
  // Copies of a trace share the count.
  return [trace, last = std::make_shared<TraceRecord>(), region](const TraceRecord& told) {
    TraceRecord record = told;
    record.region = region;
    const bool same = record.stage == last->stage && record.pass == last->pass;
    record.iteration = same ? last->iteration + 1 : 1;
    *last = record;
    trace(record);
  };
}

}  // namespace c1mesh
