// SPDX-License-Identifier: GPL-3.0-or-later
// The two formats `read_drawings` tells apart, and what their readers share.
#pragma once

#include <string>
#include <vector>

#include "c1mesh/shape.h"

namespace c1mesh::detail {

/// A list of curves or an object with the list under "curves". Throws InputError (malformed,
/// unsupported, limit, empty) with one defect per bad curve.
Drawing read_json(const std::string& text, const std::string& name, const ReadOptions& options);

/// One drawing per filled element, or one of all with `options.together`; what is stroked and not
/// filled then gives features. Throws InputError.
std::vector<Drawing> read_svg(const std::string& text, const std::string& name,
                              const ReadOptions& options);

/// Throws InputError with this one defect.
[[noreturn]] void refuse(DefectKind kind, const std::string& message, const std::string& remedy,
                         std::vector<std::string> curves = {});

}  // namespace c1mesh::detail
