// SPDX-License-Identifier: GPL-3.0-or-later
// What signals do: no end leaves a temporary file, and most are orderly.
#pragma once

namespace c1mesh::app {

/// For the start of main. A signal that asks for the end (SIGINT, SIGTERM, SIGHUP, SIGXCPU) ends
/// the program at once with status 5; one that kills (SIGSEGV, …) does so; temporary files are
/// removed first. Broken pipes and file size limits become errors of the write.
void handle_signals();

/// For commands that look at interrupted(): from now on the first signal that asks for the end only
/// sets a flag; a second one of the same kind kills.
void catch_signals();

/// Whether one of them has come.
bool interrupted();

/// The signal by which the children of a batch end when it is gone.
int signal_to_the_abandoned();

}  // namespace c1mesh::app
