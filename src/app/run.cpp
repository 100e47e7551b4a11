// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh run: the main job over one or several inputs.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/summary.h"
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
  ReadOptions read;
  Options options;
};

/// One run of the command: the arguments and what is shared by all inputs.
struct Run {
  Console& console;
  const RunArguments& arguments;
  OutputNames names;

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
  for (const char* mesh : {"vtu", "msh", "mesh"})
    if (run.wants(mesh))
      for (const char* part : {".", ".domain."})
        files.push_back({stem + part + mesh, convert(result, stem + part + mesh)});
  if (run.wants("obj")) files.push_back({stem + ".obj", format_obj(result)});
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

// Before the work, not after it.
void check_formats(const Run& run, const Shape& shape) {
  const int degree = std::max(run.arguments.options.degree, shape.highest_degree());
  const bool wanted = run.arguments.folder != "-" && run.wants("msh");
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

Status run_drawing(Run& run, const std::string& input, Drawing drawing) {
  const Options& options = run.arguments.options;
  choose_name(run, input, drawing);
  const Shape shape = make_shape(drawing);
  say_notes(run.console, input, shape.notes);
  check_formats(run, shape);
  const Outcome outcome = parametrize(shape, options, run.console.progress(drawing.name));
  run.console.clear_bar();
  // A map that is not certified must never reach a file: that would be our error, not a missed
  // bound.
  if (!outcome.report.regular() || !outcome.report.conforming())
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
    if (interrupted()) return worse(status, Status::limit);
    status = worse(status, guarded(console, input, [&] { return run_input(run, input); }));
  }
  return status;
}

std::string check_exceptional(const std::string& text) {
  const bool digits =
      !text.empty() && text.size() < 9 &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits || text == "min" ? "" : "must be a number of vertices or 'min'";
}

// CLI::Range lets "nan" through.
CLI::Validator at_least(double least, double most = std::numeric_limits<double>::max()) {
  const bool open = most == std::numeric_limits<double>::max();
  const std::string range =
      open ? fmt::format("at least {}", least) : fmt::format("from {} to {}", least, most);
  return {[=](const std::string& text) {
            double value = 0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && value >= least && value <= most ? "" : "must be a number " + range;
          },
          range, "at_least"};
}

CLI::Validator above(double least) {
  const std::string range = fmt::format("above {}", least);
  return {[=](const std::string& text) {
            double value = 0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && value > least ? "" : "must be a number " + range;
          },
          range, "above"};
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
  cli->add_option("--formats", arguments->formats,
                  "json (always written), svg, vtu, msh, mesh, obj")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str()
      ->check(CLI::IsMember({"json", "svg", "vtu", "msh", "mesh", "obj"}));
  cli->add_flag("--together", arguments->read.together,
                "Take a whole SVG drawing as one arrangement, unfilled lines as features");
  cli->add_flag("--trade-off", arguments->trade_off,
                "Also NAME.tradeoff.json and .svg: g against the number of exceptional vertices");
  add_method_options(*cli, *arguments);
  cli->final_callback([arguments] {
    if (arguments->trade_off && arguments->folder == "-")
      throw CLI::ValidationError("--trade-off", "needs a folder to write to");
  });
  return {cli, [arguments](Console& console) { return run_inputs(console, *arguments); }};
}

}  // namespace c1mesh::app
