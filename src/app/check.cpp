// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh check: reads and checks only.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/command.h"
#include "app/inputs.h"
#include "app/limits.h"
#include "app/run_options.h"
#include "c1mesh/shape.h"

namespace c1mesh::app {
namespace {

struct CheckArguments {
  InputArguments inputs;
  ReadOptions read;
  double memory_limit = 0;
};

std::string counted(long number, const char* noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

Status check_drawing(Console& console, const std::string& input, const Drawing& drawing) {
  const CheckReport report = check(drawing);
  say_defects(console, input, report.defects);
  const auto harmless =
      std::count_if(report.defects.begin(), report.defects.end(),
                    [](const Defect& d) { return d.repaired || d.kind == DefectKind::note; });
  const long serious = static_cast<long>(report.defects.size()) - harmless;
  const std::string verdict = report.usable() ? console.coloured(Tone::good, "usable")
                                              : console.coloured(Tone::bad, "not usable") + ", " +
                                                    counted(serious, "defect");
  console.say(fmt::format("{}: {}: {}, {}{}", printable(input), printable(drawing.name),
                          counted(static_cast<long>(drawing.curves.size()), "curve"), verdict,
                          harmless ? ", " + counted(harmless, "note or repair") : ""));
  return report.usable() ? Status::ok : Status::input;
}

Status check_inputs(Console& console, const CheckArguments& arguments) {
  limit_memory(arguments.memory_limit);
  Status status = Status::ok;
  for (const Input& input : inputs_of(arguments.inputs, arguments.read))
    status = worse(status, guarded(console, input.label, [&] {
                     Status worst = Status::ok;
                     for (const Drawing& drawing : input.read())
                       worst = worse(worst, check_drawing(console, input.label, drawing));
                     return worst;
                   }));
  return status;
}

}  // namespace

Command add_check(CLI::App& app) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* cli =
      app.add_subcommand("check", "Find every defect of inputs; mesh and write nothing");
  add_inputs(*cli, arguments->inputs);
  add_together(*cli, arguments->read);
  add_read_limits(*cli, arguments->read);
  add_memory_limit(*cli, arguments->memory_limit, "");
  cli->final_callback([arguments] { require_inputs(arguments->inputs); });
  return {cli, [arguments](Console& console) { return check_inputs(console, *arguments); }};
}

}  // namespace c1mesh::app
