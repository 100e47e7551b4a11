// SPDX-License-Identifier: GPL-3.0-or-later
// c1mesh convert: results in other formats, chosen by the output's extension.
#include <memory>

#include "app/command.h"
#include "c1mesh/write.h"

namespace c1mesh::app {
namespace {

struct ConvertArguments {
  std::string result, output;
};

// Refused with the command line, before anything is read.
std::string check_extension(const std::string& path) {
  for (const char* known : {".vtu", ".svg", ".json"})
    if (path.ends_with(known)) return "";
  return "no format is known by the extension of '" + path + "' (.vtu, .svg, .json)";
}

}  // namespace

Command add_convert(CLI::App& app) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* cli = app.add_subcommand("convert", "Write a result in another format, by extension");
  cli->add_option("RESULT", arguments->result, "NAME.c1.json")->required();
  cli->add_option("-o,--output", arguments->output,
                  "NAME.vtu, NAME.domain.vtu, NAME.svg or NAME.json")
      ->required()
      ->check(check_extension);
  return {cli, [arguments](Console& console) {
            return guarded(console, arguments->result, [&] {
              const Result result = read_result(arguments->result);
              deliver(arguments->output, convert(result, arguments->output));
              return Status::ok;
            });
          }};
}

}  // namespace c1mesh::app
