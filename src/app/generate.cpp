// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh generate: random shapes and families of hard shapes as input files.
#include "c1mesh/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "app/command.h"
#include "app/interrupt.h"

namespace c1mesh::app {
namespace {

struct GenerateArguments {
  std::string set, family;
  int count = 100;
  std::uint64_t seed = 1;
  std::string folder;
  std::vector<std::string> formats = {"json"};
};

std::vector<Drawing> drawings_of(Console& console, const GenerateArguments& arguments) {
  if (!arguments.set.empty())
    return generate(arguments.set.front(), arguments.count, arguments.seed);
  std::vector<Drawing> drawings;
  for (FamilyShape& shape : generate_family(arguments.family, arguments.count, arguments.seed)) {
    console.detail(fmt::format("{}: {:.6g}", shape.drawing.name, shape.parameter));
    drawings.push_back(std::move(shape.drawing));
  }
  return drawings;
}

Status generate_shapes(Console& console, const GenerateArguments& arguments) {
  catch_signals();
  const auto drawings = drawings_of(console, arguments);
  const bool svg = std::count(arguments.formats.begin(), arguments.formats.end(), "svg") > 0;
  for (const Drawing& drawing : drawings)
    if (svg)
      drawing_svg(drawing);  // throws for degrees that SVG cannot say: before anything is written
  create_folder(arguments.folder);
  for (const Drawing& drawing : drawings) {
    if (interrupted()) {
      console.error("stopped by a signal before " + drawing.name);
      return Status::limit;
    }
    std::vector<FileText> files;
    for (const std::string& format : arguments.formats)
      files.push_back({fmt::format("{}/{}.{}", arguments.folder, drawing.name, format),
                       format == "svg" ? drawing_svg(drawing) : drawing_json(drawing)});
    deliver_together(files);
  }
  console.say(
      fmt::format("{} shapes of {} (seed {}) written to {}", drawings.size(),
                  arguments.set.empty() ? "family " + arguments.family : "set " + arguments.set,
                  arguments.seed, arguments.folder));
  return Status::ok;
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const Family& family : families()) names.push_back(family.name);
  return names;
}

std::string family_list() {
  std::string list;
  for (const Family& family : families())
    list += fmt::format("\n{} ({}, {:g} to {:g})", family.name, family.parameter, family.pleasant,
                        family.nasty);
  return list;
}

}  // namespace

Command add_generate(CLI::App& app) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* cli = app.add_subcommand(
      "generate", "Write random piecewise smooth shapes, by seed, or a family of hard shapes");
  auto* what = cli->add_option_group("What", "One of");
  what->add_option("--set", arguments->set, "A, B or C: 10, 20 or 30 cubics per shape")
      ->check(CLI::IsMember({"A", "B", "C"}));
  what->add_option("--family", arguments->family,
                   "Hard shapes whose parameter runs from pleasant to nasty:" + family_list())
      ->check(CLI::IsMember(family_names()));
  what->require_option(1);
  cli->add_option("--count", arguments->count, "How many")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000000));
  cli->add_option("--seed", arguments->seed, "Same seed, same bytes")->capture_default_str();
  cli->add_option("-o,--output", arguments->folder,
                  "Folder for SET-0001.json or FAMILY-0001.json and so on")
      ->required();
  cli->add_option("--formats", arguments->formats, "json, svg")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str()
      ->check(CLI::IsMember({"json", "svg"}));
  return {cli, [arguments](Console& console) { return generate_shapes(console, *arguments); }};
}

}  // namespace c1mesh::app
