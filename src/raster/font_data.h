// SPDX-License-Identifier: GPL-3.0-or-later
// The two font files that the library carries, byte for byte (DejaVu Sans; its licence, in the
// file's own name table, allows it).
#pragma once

#include <span>

namespace c1mesh {

std::span<const unsigned char> font_data(bool bold);

}  // namespace c1mesh
