// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of `check`, in the order they run. Each reports into the arrangement.
#pragma once

#include <vector>

#include "check/arrangement.h"
#include "check/pieces.h"

namespace c1mesh::detail {

/// Numbers that can be worked with, degrees within reason, an extent. False: nothing more can be
/// said.
bool screen(const Drawing& drawing, Arrangement& arrangement);

/// Removes curves that are shorter than the resolution.
void drop_zero_length(Arrangement& arrangement);

/// Gives straight curves whose end derivative vanishes an even speed.
void respace_straight(Arrangement& arrangement);

/// Reports curves given twice and removes the copies, so that they are not reported again.
void remove_duplicates(Arrangement& arrangement);

/// Moves pairs of dangling ends closer than `tolerance` (relative to the extent) together.
void close_gaps(Arrangement& arrangement, double tolerance);

Nodes find_nodes(const Arrangement& arrangement);

/// Notes lines shorter than `tolerance` (relative to the extent) between much longer curves. They
/// stay: the boundary is the input's.
void note_short(Arrangement& arrangement, const Nodes& nodes, double tolerance);

/// Loops of the curves, each starting with its lowest curve in the direction of most of its curves.
/// Reports open chains, branchings and loops that touch in a node; those form no loop.
std::vector<Loop> join(Arrangement& arrangement, const Nodes& nodes);

/// Reports derivatives that vanish. Returns per curve whether it is regular.
std::vector<char> check_derivatives(Arrangement& arrangement);

/// Reports joints where the boundary turns by 180 degrees. Returns per node whether it is a cusp.
std::vector<char> check_joints(Arrangement& arrangement, const Nodes& nodes,
                               const std::vector<char>& regular);

/// Reports self-intersections, crossings, touchings and overlaps of all regular curves.
void check_intersections(Arrangement& arrangement, const Nodes& nodes, const Pieces& pieces,
                         const std::vector<char>& cusp);

/// Orients and nests simple, disjoint loops by the fill rule. Loops that bound nothing are noted
/// and left out.
std::vector<Region> nest(Arrangement& arrangement, const std::vector<Loop>& loops,
                         const Pieces& pieces);

}  // namespace c1mesh::detail
