// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/road.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include "app/command.h"
#include "app/summary.h"
#include "c1mesh/cost.h"
#include "c1mesh/parametrize.h"
#include "c1mesh/png.h"
#include "c1mesh/trade_off.h"
#include "c1mesh/write.h"

namespace c1mesh::app {
namespace {

// All texts exist before the first file does: what can fail fails first.
std::vector<FileText> output_files(const RunOptions& options, const Outcome& outcome) {
  const StageTimer timer("format");
  const Result& result = outcome.result;
  const std::string& folder = options.folder;
  std::vector<FileText> files;
  if (!options.certificate.empty())
    files.push_back({options.certificate, format_certificate(outcome.report.certificate)});
  if (folder == "-") {
    files.push_back({"-", format_result(result)});
    return files;
  }
  const std::string stem = folder + "/" + result.name;
  files.push_back({stem + ".c1.json", format_result(result)});
  if (options.wants("svg")) {
    const StageTimer drawing("draw");
    files.push_back({stem + ".svg", draw_svg(result, {})});
  }
  if (options.wants("png")) {
    const StageTimer drawing("draw");
    files.push_back({stem + ".png", png_of(draw_svg(result, {}))});
  }
  for (const char* mesh : {"vtu", "msh", "mesh"})
    if (options.wants(mesh))
      for (const char* part : {".", ".domain."})
        files.push_back({stem + part + mesh, convert(result, stem + part + mesh)});
  if (options.wants("cert"))
    files.push_back({stem + ".cert.json", format_certificate(outcome.report.certificate)});
  if (options.wants("html")) files.push_back({stem + ".html", format_html(result)});
  if (options.wants("obj")) files.push_back({stem + ".obj", format_obj(result)});
  return files;
}

std::vector<std::string> deliver_all(const std::vector<FileText>& files) {
  const StageTimer timer("write");
  deliver_together(files);
  std::vector<std::string> paths;
  for (const FileText& file : files) paths.push_back(file.path);
  return paths;
}

std::vector<std::string> write_outputs(const RunOptions& options, const Outcome& outcome) {
  const std::vector<FileText> files = output_files(options, outcome);
  if (options.folder != "-") create_folder(options.folder);
  create_folder_of(options.certificate);
  return deliver_all(files);
}

// The time limit is for both, the result first.
bool run_trade_off(Console& console, const RunOptions& run_options, const Shape& shape,
                   const Outcome& outcome, std::vector<std::string>& files_written) {
  constexpr double kNoneLeft = 1e-9;  // 0 would be no limit
  Options options = run_options.options;
  if (options.time_limit > 0)
    for (const auto& [stage, seconds] : outcome.seconds)
      if (stage == "total") options.time_limit = std::max(options.time_limit - seconds, kNoneLeft);
  const TradeOff curve = trade_off(shape, options, console.progress(shape.name));
  console.clear_bar();
  const std::string stem = run_options.folder + "/" + shape.name + ".tradeoff";
  const std::vector<std::string> paths = deliver_all(
      {{stem + ".json", format_trade_off(curve)}, {stem + ".svg", draw_trade_off(curve)}});
  console.say(trade_off_lines(curve, paths));
  files_written.insert(files_written.end(), paths.begin(), paths.end());
  return curve.end != TradeOffEnd::time_limit;
}

// The result is written by now: what ends the trade-off leaves it.
void add_trade_off(Console& console, const RunOptions& run_options, const Shape& shape,
                   const Outcome& outcome, DrawingRun& run) {
  std::string ended;
  try {
    if (run_trade_off(console, run_options, shape, outcome, run.files)) return;
    run.missed.emplace_back("the time limit cut the trade-off short");
  } catch (const Interrupted&) {
    ended = "a signal ended the trade-off";
  } catch (const std::bad_alloc&) {
    ended = "the trade-off ran out of memory";
  }
  run.status = worse(run.status, Status::limit);
  if (ended.empty()) return;
  console.clear_bar();
  console.error(fmt::format("{}: {}; the result was written before", shape.name, ended));
  run.missed.push_back(ended);
}

// Before the work, not after it.
void check_formats(const RunOptions& options, const Shape& shape) {
  const int degree = std::max(options.options.degree, shape.highest_degree());
  const bool wanted = options.folder != "-" && options.wants("msh");
  if (!wanted || degree <= kHighestGmshDegree) return;
  Defect defect;
  defect.kind = DefectKind::unsupported;
  defect.message = fmt::format("the triangles' degree is {}, and msh has none above {}", degree,
                               kHighestGmshDegree);
  defect.remedy = "leave msh out of --formats";
  throw InputError({defect});
}

void say_notes(Console& console, const std::string& input, std::vector<Defect> notes) {
  constexpr std::size_t kShown = 20;
  const std::size_t more = notes.size() > kShown && !console.verbose ? notes.size() - kShown : 0;
  notes.resize(notes.size() - more);
  say_defects(console, input, notes);
  if (more) console.say(fmt::format("{}: {} more notes (--verbose)", printable(input), more));
}

// A map that is not certified must never reach a file: that would be our error, not a missed bound.
// A projection moves the boundary: how far is a bound like others.
void refuse_uncertified(Console& console, const Options& options, const Outcome& outcome) {
  if (!outcome.report.regular() || !(options.project || outcome.report.conforming()))
    throw std::runtime_error("the result failed its verification\n" +
                             item_lines(console, outcome.report));
}

}  // namespace

DrawingRun run_drawing(Console& console, const RunOptions& run_options, const std::string& input,
                       const Drawing& drawing, const Trace& trace) {
  const Options& options = run_options.options;
  const Shape shape = make_shape(drawing);
  say_notes(console, input, shape.notes);
  check_formats(run_options, shape);
  const Outcome outcome = parametrize(shape, options, console.progress(drawing.name), trace);
  console.clear_bar();
  refuse_uncertified(console, options, outcome);
  DrawingRun run;
  run.files = write_outputs(run_options, outcome);
  run.metrics = outcome.result.metrics;
  run.remedies = outcome.remedies;
  run.missed = missed_bounds(outcome, options);
  if (!run.missed.empty()) run.status = Status::bound_missed;
  if (outcome.time_limit_hit) {
    run.status = Status::limit;
    run.missed.insert(run.missed.begin(), "the time limit ended the run early");
  }
  console.say(summary(console, outcome, options, run.files));
  console.detail(item_lines(console, outcome.report));
  if (run_options.trade_off) add_trade_off(console, run_options, shape, outcome, run);
  return run;
}

}  // namespace c1mesh::app
