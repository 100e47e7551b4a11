// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh run: the main job over one or several inputs.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/paper_options.h"
#include "app/summary.h"
#include "app/validators.h"
#include "c1mesh/parametrize.h"
#include "c1mesh/trade_off.h"
#include "c1mesh/write.h"

namespace c1mesh::app {
namespace {

struct RunArguments {
  std::vector<std::string> inputs;
  std::string folder;
  std::vector<std::string> formats = {"json", "svg"};
  std::string exceptional = "min";
  bool trade_off = false;
  std::string trace;  // file, empty: none
  ReadOptions read;
  Options options;
};

/// One run of the command: the arguments and what is shared by all inputs.
struct Run {
  Console& console;
  const RunArguments& arguments;
  OutputNames names;
  std::vector<TraceLine> trace = {};

  bool wants(const std::string& format) const {
    const auto& formats = arguments.formats;
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  }
};

struct OutputFile {
  std::string path, text;
};

// All texts exist before the first file does: what can fail fails first.
std::vector<OutputFile> output_files(const Run& run, const Result& result) {
  const std::string& folder = run.arguments.folder;
  if (folder == "-") return {{"-", format_result(result)}};
  const std::string stem = folder + "/" + result.name;
  std::vector<OutputFile> files = {{stem + ".c1.json", format_result(result)}};
  if (run.wants("svg")) files.push_back({stem + ".svg", draw_svg(result, {})});
  if (run.wants("vtu")) {
    files.push_back({stem + ".vtu", format_vtu(result, false)});
    files.push_back({stem + ".domain.vtu", format_vtu(result, true)});
  }
  return files;
}

std::vector<std::string> write_outputs(const Run& run, const Result& result) {
  const std::vector<OutputFile> files = output_files(run, result);
  if (run.arguments.folder != "-") create_folder(run.arguments.folder);
  std::vector<std::string> paths;
  for (const OutputFile& file : files) {
    deliver(file.path, file.text);
    paths.push_back(file.path);
  }
  return paths;
}

// The time limit is for both, the result first.
Status run_trade_off(Run& run, const Shape& shape, const Outcome& outcome) {
  constexpr double kNoneLeft = 1e-9;  // 0 would be no limit
  Options options = run.arguments.options;
  if (options.time_limit > 0)
    for (const auto& [stage, seconds] : outcome.seconds)
      if (stage == "total") options.time_limit = std::max(options.time_limit - seconds, kNoneLeft);
  const TradeOff curve = trade_off(shape, options, run.console.progress(shape.name));
  run.console.clear_bar();
  const std::string stem = run.arguments.folder + "/" + shape.name + ".tradeoff";
  const std::vector<OutputFile> files = {{stem + ".json", format_trade_off(curve)},
                                         {stem + ".svg", draw_trade_off(curve)}};
  std::vector<std::string> paths;
  for (const OutputFile& file : files) {
    deliver(file.path, file.text);
    paths.push_back(file.path);
  }
  run.console.say(trade_off_lines(curve, paths));
  return curve.end == TradeOffEnd::time_limit ? Status::limit : Status::ok;
}

Status status_of(const Outcome& outcome, const Options& options) {
  if (outcome.time_limit_hit) return Status::limit;
  return missed_bounds(outcome, options).empty() ? Status::ok : Status::bound_missed;
}

void choose_name(Run& run, const std::string& input, Drawing& drawing) {
  const std::string wanted = drawing.name;
  drawing.name = run.names.claim(wanted);
  if (drawing.name != wanted)
    run.console.say(
        printable(fmt::format("{}: '{}' is taken or no file name; the result is named '{}'", input,
                              wanted, drawing.name)));
}

void say_notes(Console& console, const std::string& input, std::vector<Defect> notes) {
  constexpr std::size_t kShown = 20;
  const std::size_t more = notes.size() > kShown && !console.verbose ? notes.size() - kShown : 0;
  notes.resize(notes.size() - more);
  say_defects(console, input, notes);
  if (more) console.say(fmt::format("{}: {} more notes (--verbose)", printable(input), more));
}

// Empty unless a trace was asked for: a run that nobody watches does not stop to measure.
Trace tracer(Run& run, const std::string& shape) {
  if (run.arguments.trace.empty()) return {};
  return [&run, shape](const TraceRecord& record) { run.trace.push_back({shape, record}); };
}

// Whatever became of the shapes.
Status write_trace(const Run& run) {
  const std::string& path = run.arguments.trace;
  if (path.empty()) return Status::ok;
  return guarded(run.console, path, [&] {
    const std::size_t slash = path.find_last_of('/');
    if (slash != std::string::npos && slash > 0) create_folder(path.substr(0, slash));
    deliver(path, format_trace(run.trace));
    run.console.say(fmt::format("trace: {}, {} iterations", printable(path), run.trace.size()));
    return Status::ok;
  });
}

Status run_drawing(Run& run, const std::string& input, Drawing drawing) {
  const Options& options = run.arguments.options;
  choose_name(run, input, drawing);
  const Shape shape = make_shape(drawing);
  say_notes(run.console, input, shape.notes);
  const Outcome outcome =
      parametrize(shape, options, run.console.progress(drawing.name), tracer(run, drawing.name));
  run.console.clear_bar();
  // A map that is not certified must never reach a file: that would be our error, not a missed
  // bound.
  // A projection moves the boundary: how far is a bound like others.
  if (!outcome.report.regular() || !(options.project || outcome.report.conforming()))
    throw std::runtime_error("the result failed its verification\n" +
                             item_lines(run.console, outcome.report));
  const std::vector<std::string> files = write_outputs(run, outcome.result);
  run.console.say(summary(run.console, outcome, options, files));
  run.console.detail(item_lines(run.console, outcome.report));
  const Status status = status_of(outcome, options);
  return run.arguments.trade_off ? worse(status, run_trade_off(run, shape, outcome)) : status;
}

Status run_input(Run& run, const std::string& input) {
  Status status = Status::ok;
  for (Drawing& drawing : read_input(input, run.arguments.read)) {
    if (interrupted()) return worse(status, Status::limit);
    const std::string label = input + " (" + drawing.name + ")";
    status = worse(status, guarded(run.console, label,
                                   [&] { return run_drawing(run, input, std::move(drawing)); }));
  }
  return status;
}

Status run_inputs(Console& console, RunArguments& arguments) {
  catch_signals();
  if (arguments.exceptional != "min")
    arguments.options.exceptional = std::stoi(arguments.exceptional);
  Run run{console, arguments, {}};
  Status status = Status::ok;
  for (const std::string& input : arguments.inputs) {
    if (interrupted()) {
      status = worse(status, Status::limit);
      break;
    }
    status = worse(status, guarded(console, input, [&] { return run_input(run, input); }));
  }
  return worse(status, write_trace(run));
}

std::string check_exceptional(const std::string& text) {
  const bool digits =
      !text.empty() && text.size() < 9 &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits || text == "min" ? "" : "must be a number of vertices or 'min'";
}

void add_method_options(CLI::App& cli, RunArguments& arguments) {
  Options& options = arguments.options;
  cli.add_option("--alpha", options.alpha, "Distortion g <= alpha * mips-bound is asked")
      ->capture_default_str()
      ->check(at_least(1));
  cli.add_option("--mips-bound", options.mips_bound, "Distortion bound of the initial mesh")
      ->capture_default_str()
      ->check(above(2));
  cli.add_option("--degree", options.degree, "Least degree of the triangles")
      ->capture_default_str()
      ->check(CLI::Range(3, 20));
  cli.add_option(
         "--exceptional", arguments.exceptional,
         "How many exceptional vertices are allowed: N, or min (the fewest within the bound)")
      ->capture_default_str()
      ->check(check_exceptional);
  cli.add_option("--refine", options.refine,
                 "At most so many times the triangles, for as low a g as that gives (1: none). "
                 "Without it: up to twice, while g exceeds 20")
      ->check(at_least(1));
  cli.add_flag("--no-overlap", options.no_overlap,
               "The domain must not overlap itself in the plane");
  cli.add_option("--corner-angle", options.corner_angle,
                 "Degrees: joints that turn more are corners")
      ->capture_default_str()
      ->check(at_least(0, 180));
  cli.add_option("--threads", options.threads, "0: as many as cores; results do not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(0, 4096));
  cli.add_option("--seed", options.seed, "Seed of every random choice")->capture_default_str();
  cli.add_option("--time-limit", options.time_limit, "Seconds per shape; 0: none")
      ->capture_default_str()
      ->check(at_least(0));
  add_paper_options(cli, options);
}

}  // namespace

Command add_run(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* cli = app.add_subcommand("run", "Read, check, mesh, make C1, verify, write");
  cli->add_option("INPUT", arguments->inputs, "JSON or SVG files, - for standard input")
      ->required();
  cli->add_option("-o,--output", arguments->folder,
                  "Folder for NAME.c1.json and the rest; -: the JSON alone to standard output")
      ->required();
  cli->add_option("--formats", arguments->formats, "json (always written), svg, vtu")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str()
      ->check(CLI::IsMember({"json", "svg", "vtu"}));
  cli->add_flag("--together", arguments->read.together,
                "Take a whole SVG drawing as one arrangement, unfilled lines as features");
  cli->add_flag("--trade-off", arguments->trade_off,
                "Also NAME.tradeoff.json and .svg: g against the number of exceptional vertices");
  cli->add_option("--trace", arguments->trace,
                  "Also this file, one JSON object per iteration; c1mesh draw makes a plot of it")
      ->check([](const std::string& path) {
        return path.empty() || path == "-" ? "needs the name of a file" : "";
      });
  add_method_options(*cli, *arguments);
  cli->final_callback([arguments] {
    if (arguments->trade_off && arguments->folder == "-")
      throw CLI::ValidationError("--trade-off", "needs a folder to write to");
  });
  return {cli, [arguments](Console& console) { return run_inputs(console, *arguments); }};
}

}  // namespace c1mesh::app
