// SPDX-License-Identifier: GPL-3.0-or-later
// What the program needs of its process before anything else, and the end when all else failed.
#pragma once

namespace c1mesh::app {

/// For the start of main: standard descriptors that were closed become ones that fail, so that no
/// file is opened in their place; a lack of memory in GMP is std::bad_alloc; an exception that
/// nothing catches ends with a status, not with a signal.
void prepare_process();

/// For the end of main: what was printed to standard output is there. False, with a message, if
/// not.
bool standard_output_is_whole();

}  // namespace c1mesh::app
