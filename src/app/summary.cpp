// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/summary.h"

#include <fmt/format.h>

namespace c1mesh::app {
namespace {

std::string row(const std::string& label, const std::string& value) {
  return fmt::format("\n  {:<22}{}", label, printable(value));
}

std::string seconds_by_stage(const Outcome& outcome) {
  std::string out;
  double total = 0;
  for (const auto& [stage, seconds] : outcome.seconds) {
    if (stage == "total") continue;
    out += fmt::format("{}{} {:.2f}", out.empty() ? "" : ", ", stage, seconds);
    total += seconds;
  }
  return fmt::format("{:.2f}{}", total, out.empty() ? "" : " (" + out + ")");
}

std::string spread(const Spread& s) {
  return fmt::format("max {:.2e}, 99th percentile {:.2e}, median {:.2e}", s.max, s.p99, s.median);
}

std::string joined(const std::vector<std::string>& parts, const char* between,
                   const char* if_empty) {
  if (parts.empty()) return if_empty;
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : between) + part;
  return out;
}

std::string verdict_row(const Console& console, const Outcome& outcome, const Options& options) {
  std::vector<std::string> missed = missed_bounds(outcome, options);
  if (outcome.time_limit_hit) missed.insert(missed.begin(), "the time limit ended the run early");
  const std::string text = missed.empty() ? console.coloured(Tone::good, "all that was asked holds")
                                          : console.coloured(Tone::warning, "valid, but ") +
                                                printable(joined(missed, "; ", ""));
  return fmt::format("\n  {:<22}{}", "verdict", text);
}

Tone tone_of(Verdict verdict) {
  return verdict == Verdict::valid     ? Tone::good
         : verdict == Verdict::invalid ? Tone::bad
                                       : Tone::warning;
}

}  // namespace

std::vector<std::string> missed_bounds(const Outcome& outcome, const Options& options) {
  if (outcome.within_bounds) return {};
  const Metrics& metrics = outcome.result.metrics;
  std::vector<std::string> missed;
  const double bound = distortion_asked(options);
  if (metrics.mips_bound_max > bound)
    missed.push_back(fmt::format("the distortion bound {:.4g} exceeds the {:.4g} asked for",
                                 metrics.mips_bound_max, bound));
  if (options.exceptional >= 0 && metrics.exceptional > options.exceptional)
    missed.push_back(fmt::format("{} vertices are exceptional where {} were allowed",
                                 metrics.exceptional, options.exceptional));
  if (options.no_overlap && metrics.domain_overlaps)
    missed.emplace_back("the domain overlaps itself in the plane");
  for (const VerifyItem& item : outcome.report.items)
    if (item.verdict != Verdict::valid)
      missed.push_back(fmt::format("{} is {}: {}", item.name, name_of(item.verdict), item.message));
  if (outcome.gave_up) missed.emplace_back("C1 was given up at every boundary vertex of a region");
  if (missed.empty()) missed.emplace_back("a bound that was asked is missed");
  return missed;
}

std::string summary(const Console& console, const Outcome& outcome, const Options& options,
                    const std::vector<std::string>& files) {
  const Metrics& m = outcome.result.metrics;
  std::string out = printable(outcome.result.name);
  out += row("triangles", fmt::format("{} of degree {}", m.triangles, outcome.result.degree));
  out += row("exceptional vertices",
             fmt::format("{} (minimum {}; {} by the count of all corners)", m.exceptional,
                         m.exceptional_minimum, m.exceptional_minimum_paper));
  out += row("C1 deviation", spread(m.d_ei));
  out += row("conformance", fmt::format("{:.2e}", m.conformance_max));
  out += row("distortion bound g", fmt::format("max {:.4g} (asked: {:.4g})", m.mips_bound_max,
                                               distortion_asked(options)));
  out += row("least det coefficient", fmt::format("{:.2e}", m.min_det_coefficient));
  out += row("flatness ratio", fmt::format("{:.4g}", m.flatness_ratio));
  if (m.domain_overlaps) out += row("domain", "overlaps itself in the plane");
  out += row("seconds", seconds_by_stage(outcome));
  out += row("remedies", joined(outcome.remedies, "; ", "none"));
  if (!files.empty()) out += row("files", joined(files, ", ", ""));
  return out + verdict_row(console, outcome, options);
}

std::string cost_lines(const CostLedger& ledger, int triangles) {
  const double each = triangles > 0 ? 1.0 / triangles : 0;
  const auto line = [&](const std::string& stage, double wall, double cpu) {
    return fmt::format("\n  {:<30}{:>10.3f}{:>10.3f}{:>14.2f}", stage, wall, cpu, 1e6 * cpu * each);
  };
  std::string out =
      fmt::format("  {:<30}{:>10}{:>10}{:>14}", "cost of", "seconds", "CPU s", "CPU us/tri.");
  double wall = 0, cpu = 0;
  for (const StageCost& cost : ledger.stages()) {
    out += line(cost.stage, cost.wall, cost.cpu);
    wall += cost.wall;
    cpu += cost.cpu;
  }
  out += line("all stages", wall, cpu);
  const double peak = peak_memory();
  if (peak > 0)
    out += fmt::format("\n  {:<30}{:>7.1f} MiB{:>10}{:>10.2f} KiB", "peak memory", peak / 1048576,
                       "", peak / 1024 * each);
  return out;
}

std::string trade_off_lines(const TradeOff& curve, const std::vector<std::string>& files) {
  std::string out = printable(curve.name) + ": g against exceptional vertices";
  for (const TradeOffPoint& p : curve.points)
    out += row(
        fmt::format("{} exceptional", p.exceptional),
        fmt::format("g max {:.4g}, median {:.4g}; {} triangles{}{}", p.g, p.g_median, p.triangles,
                    p.c1 ? "" : "; not certified C1", p.dominated ? "; no better than fewer" : ""));
  if (curve.end == TradeOffEnd::time_limit) out += row("end", "the time limit cut it short");
  return out + row("files", joined(files, ", ", "none"));
}

std::string item_lines(const Console& console, const VerifyReport& report) {
  std::string out;
  for (const VerifyItem& item : report.items) {
    const std::string verdict = fmt::format("{:<10}", name_of(item.verdict));
    out += fmt::format("{}  {:<22}{}{}", out.empty() ? "" : "\n", printable(item.name),
                       console.coloured(tone_of(item.verdict), verdict), printable(item.message));
  }
  return out;
}

}  // namespace c1mesh::app
