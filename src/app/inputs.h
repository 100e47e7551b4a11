// SPDX-License-Identifier: GPL-3.0-or-later
// What `run` and `check` read, and `verify` compares with: files, or a text set in a font.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "c1mesh/shape.h"

namespace c1mesh::app {

struct InputArguments {
  std::vector<std::string> files;
  std::string font, text;
};

/// --font, which is returned, and --text; they need each other.
CLI::Option* add_text(CLI::App& cli, InputArguments& arguments);

/// INPUT…, --font and --text.
void add_inputs(CLI::App& cli, InputArguments& arguments);

/// Throws CLI::ParseError unless there is an input, and a text for the font. To be called once the
/// command line is read.
void require_inputs(const InputArguments& arguments);

/// Something to be read, and what messages call it.
struct Input {
  std::string label;
  std::function<std::vector<Drawing>()> read;  ///< at least one; throws as read_input and read_font
};

/// The files in order, then the text.
std::vector<Input> inputs_of(const InputArguments& arguments, const ReadOptions& options);

}  // namespace c1mesh::app
