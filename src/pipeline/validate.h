// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "c1mesh/options.h"

namespace c1mesh {

/// Throws std::invalid_argument for options out of range.
void validate(const Options& options);

}  // namespace c1mesh
