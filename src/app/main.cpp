// SPDX-License-Identifier: GPL-3.0-or-later
// The program: parses the command line, runs one command, returns its status.
#include <CLI/CLI.hpp>
#include <vector>

#include "app/command.h"
#include "app/endings.h"
#include "app/interrupt.h"
#include "app/self_description.h"
#include "app/surroundings.h"
#include "c1mesh/version.h"

namespace {

using c1mesh::app::Status;

int parse_error(const CLI::App& app, const CLI::ParseError& error) {
  const bool wanted = error.get_exit_code() == 0;  // --help, --version
  app.exit(error);
  if (!wanted) return static_cast<int>(Status::usage);
  return static_cast<int>(c1mesh::app::standard_output_is_whole() ? Status::ok : Status::internal);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace c1mesh::app;
  prepare_process();
  handle_signals();
  Console console;
  CLI::App app(
      "Exactly C1 curved-triangle parametrizations of planar shapes bounded by Bezier curves",
      "c1mesh");
  app.set_version_flag("--version", std::string("c1mesh ") + c1mesh::version());
  app.add_flag("-q,--quiet", console.quiet, "Say errors only");
  app.add_flag("-v,--verbose", console.verbose, "Say every stage and note");
  app.require_subcommand(1);
  app.fallthrough();
  const std::vector<Command> commands = {add_run(app),     add_batch(app),     add_check(app),
                                         add_verify(app),  add_project(app),   add_draw(app),
                                         add_convert(app), add_generate(app),  add_evaluate(app),
                                         add_manual(app),  add_completion(app)};
  add_endings(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parse_error(app, error);
  }
  for (const Command& command : commands)
    if (command.cli->parsed())
      return static_cast<int>(
          guarded(console, command.cli->get_name(), [&] { return command.action(console); }));
  return static_cast<int>(Status::usage);
}
