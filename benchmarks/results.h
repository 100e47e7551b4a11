// SPDX-License-Identifier: GPL-3.0-or-later
// What the benchmarks work on.
#pragma once

#include <string>

#include "c1mesh/c1mesh.h"

namespace c1mesh::benchmarks {

/// The first shape of examples/NAME.
Shape example(const std::string& name);

/// The map of examples/puzzle.svg with at least `triangles` triangles, made once.
const Result& puzzle_map(int triangles);

}  // namespace c1mesh::benchmarks
