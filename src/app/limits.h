// SPDX-License-Identifier: GPL-3.0-or-later
// What a command may spend on strangers' files: one definition of these options for all that read.
#pragma once

#include <CLI/CLI.hpp>

#include "c1mesh/shape.h"

namespace c1mesh::app {

/// --max-bytes, --max-curves, --max-depth and --max-characters.
void add_read_limits(CLI::App& cli, ReadOptions& options);

/// --max-bytes alone, for what is no drawing.
void add_byte_limit(CLI::App& cli, std::size_t& max_bytes);

/// --memory-limit in MB of address space; 0: none. `whose`: "for each process" and the like.
void add_memory_limit(CLI::App& cli, double& megabytes, const char* whose);

/// From now on this process gets no more address space than that; what needs more ends with
/// std::bad_alloc, and so with status 5. For good: a limit cannot be raised again. Does nothing for
/// 0.
void limit_memory(double megabytes);

}  // namespace c1mesh::app
