// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh verify: certifies result files from their data alone.
#include "c1mesh/verify.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/command.h"
#include "app/limits.h"
#include "app/summary.h"

namespace c1mesh::app {
namespace {

struct VerifyArguments {
  std::vector<std::string> results;
  std::string input;
  ReadOptions read;
  double memory_limit = 0;
};

// The input's drawing that the result was made of: the only one, or the one of the same name.
Shape input_shape(const VerifyArguments& arguments, const Result& result) {
  std::vector<Drawing> drawings = read_input(arguments.input, arguments.read);
  if (drawings.size() == 1) return make_shape(drawings.front());
  for (const Drawing& drawing : drawings)
    if (drawing.name == result.name) return make_shape(drawing);
  throw FileError(fmt::format("{} holds {} shapes, none named '{}'", arguments.input,
                              drawings.size(), result.name));
}

Status verify_file(Console& console, const VerifyArguments& arguments, const std::string& path) {
  const Result result = read_result(path, arguments.read.max_bytes);
  const VerifyOptions bounds = claimed_bounds(result);
  const VerifyReport report = arguments.input.empty()
                                  ? verify(result, bounds)
                                  : verify(result, input_shape(arguments, result), bounds);
  const bool valid = report.valid();
  console.say(fmt::format(
      "{}: {}\n{}", printable(path),
      valid ? console.coloured(Tone::good, "valid") : console.coloured(Tone::bad, "NOT certified"),
      item_lines(console, report)));
  return valid ? Status::ok : Status::bound_missed;
}

Status verify_files(Console& console, const VerifyArguments& arguments) {
  limit_memory(arguments.memory_limit);
  Status status = Status::ok;
  for (const std::string& path : arguments.results)
    status = worse(status,
                   guarded(console, path, [&] { return verify_file(console, arguments, path); }));
  return status;
}

}  // namespace

Command add_verify(CLI::App& app) {
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* cli = app.add_subcommand("verify", "Certify result files from their data alone");
  cli->add_option("RESULT", arguments->results, "NAME.c1.json files")->required();
  cli->add_option("--input", arguments->input, "Also compare with the shape they were made of");
  cli->add_flag("--together", arguments->read.together, "The input was taken as one arrangement");
  add_read_limits(*cli, arguments->read);
  add_memory_limit(*cli, arguments->memory_limit, "");
  return {cli, [arguments](Console& console) { return verify_files(console, *arguments); }};
}

}  // namespace c1mesh::app
