// SPDX-License-Identifier: GPL-3.0-or-later
// The command line's options of the paper's method.
#pragma once

#include <CLI/CLI.hpp>

#include "c1mesh/options.h"

namespace c1mesh::app {

/// Adds --method and the parameters of --method paper.
void add_paper_options(CLI::App& cli, Options& options);

}  // namespace c1mesh::app
