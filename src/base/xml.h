// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace c1mesh {

/// `text` as XML text or attribute value: markup characters escaped, control characters that XML
/// cannot hold left out, bytes that are no UTF-8 replaced by U+FFFD.
std::string xml_escaped(const std::string& text);

}  // namespace c1mesh
