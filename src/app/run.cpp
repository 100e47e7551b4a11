// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh run: the main job over one or several inputs.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>

#include "app/command.h"
#include "app/inputs.h"
#include "app/interrupt.h"
#include "app/limits.h"
#include "app/road.h"
#include "app/summary.h"

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
  std::string certified = {};  ///< the shape whose certificate was asked for as a file
};

void choose_name(Run& run, const std::string& input, Drawing& drawing) {
  const std::string wanted = drawing.name;
  drawing.name = run.names.claim(wanted);
  if (drawing.name != wanted)
    run.console.say(
        printable(fmt::format("{}: '{}' is taken or no file name; the result is named '{}'", input,
                              wanted, drawing.name)));
}

// A file holds one certificate: a second shape must not take the place of the first.
void reserve_certificate(Run& run, const std::string& shape) {
  const std::string& path = run.arguments.options.certificate;
  if (path.empty()) return;
  if (!run.certified.empty())
    throw std::invalid_argument(fmt::format(
        "{} is for the certificate of '{}'; --formats json,cert writes one for every shape", path,
        run.certified));
  run.certified = shape;
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
    create_folder_of(path);
    deliver(path, format_trace(run.trace));
    run.console.say(fmt::format("trace: {}, {} iterations", printable(path), run.trace.size()));
    return Status::ok;
  });
}

std::vector<Drawing> read_timed(const Input& input) {
  const StageTimer timer("read");
  return input.read();
}

// Reading counts for the first of the drawings.
Status run_input(Run& run, const Input& input) {
  CostLedger ledger;
  std::optional<CostRecording> recording;
  if (run.console.verbose) recording.emplace(ledger);
  Status status = Status::ok;
  for (Drawing& drawing : read_timed(input)) {
    if (interrupted()) return worse(status, Status::limit);
    const std::string label = input.label + " (" + drawing.name + ")";
    status = worse(status, guarded(run.console, label, [&] {
                     choose_name(run, input.label, drawing);
                     reserve_certificate(run, drawing.name);
                     const DrawingRun done =
                         run_drawing(run.console, run.arguments.options, input.label, drawing,
                                     tracer(run, drawing.name));
                     run.console.detail(cost_lines(ledger, done.metrics.triangles));
                     return done.status;
                   }));
    ledger.clear();
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

}  // namespace

Command add_run(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* cli = app.add_subcommand("run", "Read, check, mesh, make C1, verify, write");
  add_inputs(*cli, arguments->inputs);
  cli->add_option("-o,--output", arguments->options.folder,
                  "Folder for NAME.c1.json and the rest; -: the JSON alone to standard output")
      ->required();
  add_run_options(*cli, arguments->options);
  cli->add_option("--certificate", arguments->options.certificate,
                  "Also this file: what was proven and how, for c1mesh verify --certificate");
  add_memory_limit(*cli, arguments->memory_limit, "");
  cli->add_option("--trace", arguments->trace,
                  "Also this file, one JSON object per iteration; c1mesh draw makes a plot of it")
      ->check([](const std::string& path) {
        return path.empty() || path == "-" ? "needs the name of a file" : "";
      });
  cli->final_callback([arguments] {
    require_inputs(arguments->inputs);
    if (arguments->options.trade_off && arguments->options.folder == "-")
      throw CLI::ValidationError("--trade-off", "needs a folder to write to");
  });
  return {cli, [arguments](Console& console) { return run_inputs(console, *arguments); }};
}

}  // namespace c1mesh::app
