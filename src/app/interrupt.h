// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT and SIGTERM ask for an orderly end; a second one kills.
#pragma once

namespace c1mesh::app {

/// From now on the first SIGINT or SIGTERM only sets a flag.
void catch_signals();

/// Whether one of them has come.
bool interrupted();

}  // namespace c1mesh::app
