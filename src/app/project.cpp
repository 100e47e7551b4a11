// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh project: results made exactly C1 by moving their boundary (paper, section 5.4).
#include "c1mesh/project.h"

#include <fmt/format.h>

#include <memory>

#include "app/command.h"
#include "app/limits.h"
#include "app/summary.h"
#include "app/validators.h"
#include "c1mesh/verify.h"

namespace c1mesh::app {
namespace {

struct ProjectArguments {
  std::vector<std::string> results;
  std::string folder;
  double conformance_bound = 1e-4;
  std::size_t max_bytes = ReadOptions().max_bytes;
};

Status project_file(Console& console, const ProjectArguments& arguments, OutputNames& names,
                    const std::string& path) {
  Projection projection =
      project(read_result(path, arguments.max_bytes), arguments.conformance_bound);
  const VerifyReport report = verify(projection.result, claimed_bounds(projection.result));
  if (!report.regular()) {
    console.say(fmt::format("{}: the projection inverts triangles; nothing was written\n{}",
                            printable(path), item_lines(console, report)));
    return Status::bound_missed;
  }
  projection.result.metrics = report.metrics;
  const std::string file =
      arguments.folder + "/" + names.claim(projection.result.name) + ".c1.json";
  create_folder(arguments.folder);
  deliver(file, format_result(projection.result));
  console.say(fmt::format(
      "{}: residue {:.2e} -> {:.2e}, a control point moved by {:.2e} of the extent, {} domain "
      "vertices "
      "made singular; {}: {}",
      printable(path), projection.before, projection.after, projection.largest_move,
      projection.singular, printable(file),
      report.valid()
          ? console.coloured(Tone::good, "valid")
          : console.coloured(Tone::warning, "valid, but") + "\n" + item_lines(console, report)));
  return report.valid() ? Status::ok : Status::bound_missed;
}

Status project_files(Console& console, const ProjectArguments& arguments) {
  Status status = Status::ok;
  OutputNames names;
  for (const std::string& path : arguments.results)
    status = worse(status, guarded(console, path,
                                   [&] { return project_file(console, arguments, names, path); }));
  return status;
}

}  // namespace

Command add_project(CLI::App& app) {
  auto arguments = std::make_shared<ProjectArguments>();
  CLI::App* cli = app.add_subcommand(
      "project", "Make nearly C1 results exactly C1 by moving control points, the boundary's too");
  cli->add_option("RESULT", arguments->results, "NAME.c1.json files")->required();
  cli->add_option("-o,--output", arguments->folder, "Folder for NAME.c1.json")->required();
  cli->add_option("--conformance-bound", arguments->conformance_bound,
                  "How far the boundary may go, relative to the larger side of the shape")
      ->capture_default_str()
      ->check(above(0));
  add_byte_limit(*cli, arguments->max_bytes);
  return {cli, [arguments](Console& console) { return project_files(console, *arguments); }};
}

}  // namespace c1mesh::app
