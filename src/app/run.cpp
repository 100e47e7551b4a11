// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh run: the main job over one or several inputs.
#include <fmt/format.h>

#include <memory>

#include "app/command.h"
#include "app/inputs.h"
#include "app/interrupt.h"
#include "app/limits.h"
#include "app/road.h"

namespace c1mesh::app {
namespace {

struct RunArguments {
  InputArguments inputs;
  std::string trace;  // file, empty: none
  double memory_limit = 0;
  RunOptions options;
};

/// One run of the command: the arguments and what is shared by all inputs.
struct Run {
  Console& console;
  const RunArguments& arguments;
  OutputNames names;
  std::vector<TraceLine> trace = {};
};

void choose_name(Run& run, const std::string& input, Drawing& drawing) {
  const std::string wanted = drawing.name;
  drawing.name = run.names.claim(wanted);
  if (drawing.name != wanted)
    run.console.say(
        printable(fmt::format("{}: '{}' is taken or no file name; the result is named '{}'", input,
                              wanted, drawing.name)));
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

Status run_input(Run& run, const Input& input) {
  Status status = Status::ok;
  for (Drawing& drawing : input.read()) {
    if (interrupted()) return worse(status, Status::limit);
    const std::string label = input.label + " (" + drawing.name + ")";
    status = worse(status, guarded(run.console, label, [&] {
                     choose_name(run, input.label, drawing);
                     return run_drawing(run.console, run.arguments.options, input.label, drawing,
                                        tracer(run, drawing.name))
                         .status;
                   }));
  }
  return status;
}

Status run_inputs(Console& console, const RunArguments& arguments) {
  catch_signals();
  limit_memory(arguments.memory_limit);
  Run run{console, arguments, {}};
  Status status = Status::ok;
  for (const Input& input : inputs_of(arguments.inputs, arguments.options.read)) {
    if (interrupted()) {
      status = worse(status, Status::limit);
      break;
    }
    status = worse(status, guarded(console, input.label, [&] { return run_input(run, input); }));
  }
  return worse(status, write_trace(run));
}

constexpr const char* kRunFooter = R"(
Examples:
  c1mesh run shape.svg -o out
  c1mesh run --font DejaVuSans.ttf --text Bezier -o out    every letter a shape
Many shapes: c1mesh batch.)";

}  // namespace

Command add_run(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* cli = app.add_subcommand("run", "Read, check, mesh, make C1, verify, write");
  add_inputs(*cli, arguments->inputs);
  cli->add_option("-o,--output", arguments->options.folder,
                  "Folder for NAME.c1.json and the rest; -: the JSON alone to standard output")
      ->required();
  add_run_options(*cli, arguments->options);
  add_memory_limit(*cli, arguments->memory_limit, "");
  cli->add_option("--trace", arguments->trace,
                  "Also this file, one JSON object per iteration; c1mesh draw makes a plot of it")
      ->check([](const std::string& path) {
        return path.empty() || path == "-" ? "needs the name of a file" : "";
      });
  cli->footer(kRunFooter + app.get_footer());
  cli->final_callback([arguments] {
    require_inputs(arguments->inputs);
    if (arguments->options.trade_off && arguments->options.folder == "-")
      throw CLI::ValidationError("--trade-off", "needs a folder to write to");
  });
  return {cli, [arguments](Console& console) { return run_inputs(console, *arguments); }};
}

}  // namespace c1mesh::app
