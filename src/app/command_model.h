// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as plain data, taken from its definition: what manual pages and completions are
// made of, so that they name every option there is and no other.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace c1mesh::app {

struct OptionModel {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional one its name
  bool positional = false, flag = false, required = false, many = false;
  std::string value;                 ///< what stands for the value, "TEXT"
  std::string range;                 ///< "at least 1", empty: none is said
  std::vector<std::string> choices;  ///< the values there are, where they can be listed
  std::string initial;               ///< the value it has if not given
  std::string help;
  std::string group;  ///< a heading
};

struct CommandModel {
  std::string name;         ///< empty: the program itself
  std::string description;  ///< one line
  std::vector<OptionModel> options;
  std::string footer;

  /// The options that begin with a dash, or the others.
  std::vector<OptionModel> with_dashes(bool wanted) const;
};

/// The program (its options and footer), then its commands in the order in which they were defined.
std::vector<CommandModel> models_of(const CLI::App& program);

}  // namespace c1mesh::app
