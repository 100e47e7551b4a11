// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says of itself, and its text.
#include <fmt/format.h>

#include <initializer_list>

#include "c1mesh/verify.h"

namespace c1mesh {
namespace {

/// All of the named items are there and valid.
bool hold(const VerifyReport& report, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    bool found = false;
    for (const VerifyItem& item : report.items)
      if (item.name == name) {
        found = true;
        if (item.verdict != Verdict::valid) return false;
      }
    if (!found) return false;
  }
  return true;
}

std::string text_of(const Spread& s) {
  return fmt::format("median {:.3g}, 99 % {:.3g}, max {:.3g}", s.median, s.p99, s.max);
}

}  // namespace

bool VerifyReport::regular() const {
  return hold(*this, {"structure", "topology", "domain orientation", "winding", "regularity"});
}

bool VerifyReport::conforming() const {
  for (const VerifyItem& item : items)
    if (item.name == "input curves" && item.verdict != Verdict::valid) return false;
  return hold(*this, {"structure", "topology", "coverage", "conformance"});
}

bool VerifyReport::c1() const {
  return hold(*this, {"structure", "topology", "C1", "exceptional vertices"});
}

bool VerifyReport::valid() const {
  for (const VerifyItem& item : items)
    if (item.verdict != Verdict::valid) return false;
  return !items.empty();
}

std::string report_text(const VerifyReport& report) {
  std::string out;
  for (const VerifyItem& item : report.items)
    out += fmt::format("{:<21}{:<10} {}\n", item.name, name_of(item.verdict), item.message);
  const Metrics& m = report.metrics;
  const auto line = [&](const char* name, const std::string& value) {
    out += fmt::format("{:<21}{}\n", name, value);
  };
  line("triangles", fmt::format("{}", m.triangles));
  line("d_ei", text_of(m.d_ei));
  line("gradient angle, deg", text_of(m.gradient_angle_deg));
  line("gradient magnitude", text_of(m.gradient_magnitude));
  line("MIPS bound", fmt::format("{:.6g}", m.mips_bound_max));
  line("least det coefficient", fmt::format(" {:.6g}", m.min_det_coefficient));
  line("flatness ratio", fmt::format("{:.4g}", m.flatness_ratio));
  line("domain overlaps", m.domain_overlaps ? "yes" : "no");
  return out;
}

}  // namespace c1mesh
