// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that describe the program itself.
#pragma once

#include "app/command.h"

namespace c1mesh::app {

Command add_manual(CLI::App& app);
Command add_completion(CLI::App& app);

}  // namespace c1mesh::app
