// SPDX-License-Identifier: GPL-3.0-or-later
// How the help of each command ends: exit statuses, notes, examples.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace c1mesh::app {

/// What stands before the examples in a footer; each example is a line behind it, indented by two
/// spaces.
inline constexpr const char* kExamples = "Examples:";

/// Gives the program and every command of it a footer that ends with examples.
void add_endings(CLI::App& program);

}  // namespace c1mesh::app
