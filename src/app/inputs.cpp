// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inputs.h"

#include "app/command.h"
#include "c1mesh/font.h"

namespace c1mesh::app {

CLI::Option* add_text(CLI::App& cli, InputArguments& arguments) {
  CLI::Option* font = cli.add_option(
      "--font", arguments.font, "TrueType, OpenType or Type 1 font whose letters are the shapes");
  CLI::Option* text =
      cli.add_option("--text", arguments.text, "The letters, in UTF-8; --together: as one shape");
  font->needs(text);
  text->needs(font);
  return font;
}

void add_inputs(CLI::App& cli, InputArguments& arguments) {
  cli.add_option("INPUT", arguments.files, "JSON or SVG files, - for standard input");
  add_text(cli, arguments);
}

void require_inputs(const InputArguments& arguments) {
  if (arguments.files.empty() && arguments.font.empty())
    throw CLI::ValidationError("INPUT", "a file, or --font and --text, is required");
}

std::vector<Input> inputs_of(const InputArguments& arguments, const ReadOptions& options) {
  std::vector<Input> inputs;
  for (const std::string& file : arguments.files)
    inputs.push_back({file, [file, options] { return read_input(file, options); }});
  if (!arguments.font.empty())
    inputs.push_back({arguments.font, [arguments, options] {
                        return read_font(arguments.font, arguments.text, options);
                      }});
  return inputs;
}

}  // namespace c1mesh::app
