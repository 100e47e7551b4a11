// SPDX-License-Identifier: GPL-3.0-or-later
// Which version was linked.
#pragma once

namespace c1mesh {

/// The library's version, for example "0.1.0".
const char* version();

}  // namespace c1mesh
