// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh generate: random shapes as input files.
#include "c1mesh/generate.h"

#include <fmt/format.h>

#include <memory>

#include "app/command.h"
#include "app/interrupt.h"

namespace c1mesh::app {
namespace {

struct GenerateArguments {
  std::string set;
  int count = 100;
  std::uint64_t seed = 1;
  std::string folder;
  std::vector<std::string> formats = {"json"};
};

Status generate_shapes(Console& console, const GenerateArguments& arguments) {
  catch_signals();
  const auto drawings = generate(arguments.set.front(), arguments.count, arguments.seed);
  create_folder(arguments.folder);
  for (const Drawing& drawing : drawings) {
    if (interrupted()) {
      console.error("stopped by a signal before " + drawing.name);
      return Status::limit;
    }
    for (const std::string& format : arguments.formats)
      deliver(fmt::format("{}/{}.{}", arguments.folder, drawing.name, format),
              format == "svg" ? drawing_svg(drawing) : drawing_json(drawing));
  }
  console.say(fmt::format("{} shapes of set {} (seed {}) written to {}", drawings.size(),
                          arguments.set, arguments.seed, arguments.folder));
  return Status::ok;
}

}  // namespace

Command add_generate(CLI::App& app) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* cli = app.add_subcommand("generate", "Write random piecewise smooth shapes, by seed");
  cli->add_option("--set", arguments->set, "A, B or C: 10, 20 or 30 cubics per shape")
      ->required()
      ->check(CLI::IsMember({"A", "B", "C"}));
  cli->add_option("--count", arguments->count, "How many")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000000));
  cli->add_option("--seed", arguments->seed, "Same seed, same bytes")->capture_default_str();
  cli->add_option("-o,--output", arguments->folder, "Folder for SET-0001.json and so on")
      ->required();
  cli->add_option("--formats", arguments->formats, "json, svg")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str()
      ->check(CLI::IsMember({"json", "svg"}));
  return {cli, [arguments](Console& console) { return generate_shapes(console, *arguments); }};
}

}  // namespace c1mesh::app
