// SPDX-License-Identifier: GPL-3.0-or-later
// Files of this project's own formats, as a whole.
#pragma once

#include <string>

namespace c1mesh {

/// Throws FileError, and InputError (limit) if the file is larger than `max_bytes`.
std::string read_file(const std::string& path, std::size_t max_bytes);

}  // namespace c1mesh
