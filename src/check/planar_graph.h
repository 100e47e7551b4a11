// SPDX-License-Identifier: GPL-3.0-or-later
// The graph of curves and end points: what holds it together, and its faces.
#pragma once

#include <vector>

#include "check/arrangement.h"

namespace c1mesh::detail {

/// The blocks of the graph that the curves with `use` set form: maximal sets of curves any two of
/// which lie on a common simple loop. A curve that lies on no loop is a block of its own.
std::vector<std::vector<int>> blocks_of(const Arrangement& arrangement, const Nodes& nodes,
                                        const std::vector<char>& use);

/// The outermost loop of a block of curves that meet in end points only: the boundary of the
/// unbounded face. Not in any promised order.
std::vector<int> rim_of(const Arrangement& arrangement, const Nodes& nodes,
                        const std::vector<int>& block);

}  // namespace c1mesh::detail
