// SPDX-License-Identifier: GPL-3.0-or-later
// The list of curves in JSON text, one entry in memory at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "c1mesh/shape.h"

namespace c1mesh::detail {

/// Calls `entry` for every item of the list, which is the text's root or its "curves", in order and
/// with its number. A tree of the whole text would take twenty times its bytes; here only an item
/// is a tree. Throws InputError: malformed (syntax, no list), empty, limit (nesting, number of
/// items, values in an item).
void for_each_curve(const std::string& text, const ReadOptions& options,
                    const std::function<void(const nlohmann::json&, std::size_t)>& entry);

}  // namespace c1mesh::detail
