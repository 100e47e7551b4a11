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

/// Removes the copies of curves that are given more than once, in whichever direction, and keeps
/// their ids: two sub-shapes may both give the curve they share.
void remove_duplicates(Arrangement& arrangement);

/// Leaves out the curves that are not to be kept.
void keep_only(Arrangement& arrangement, const std::vector<char>& keep);

/// Notes a curve that will be left out as a copy of another.
void add_copy(Arrangement& arrangement, int original, int copy);

/// Ends closer than the resolution become one point, bit for bit.
void unite_ends(Arrangement& arrangement);

/// As remove_duplicates, for curves between the same points whose poles agree to the resolution,
/// raised to one degree.
void remove_near_copies(Arrangement& arrangement);

/// Moves pairs of dangling ends closer than `tolerance` (relative to the extent) together.
void close_gaps(Arrangement& arrangement, double tolerance);

Nodes find_nodes(const Arrangement& arrangement);

/// Dangling ends of features closer than `tolerance` (relative to the extent) to a point where
/// curves meet, to another such end, or to the inside of another curve, are moved there. A curve
/// touched inside, or on whose inside others meet, is cut in two. Returns whether anything was
/// done; nothing is where no curve bounds, or all do.
bool attach_ends(Arrangement& arrangement, const Nodes& nodes, double tolerance);

/// Cuts features that cross each other at the crossing; else as above. No tolerance is needed.
bool cut_crossings(Arrangement& arrangement, const Nodes& nodes, double tolerance);

/// The curve keeps the part before t, the part after it is appended; the common point has the same
/// bits in both.
void cut_curve(Arrangement& arrangement, int curve, double t);

/// Decides which curves are features: those marked, and those that bound nothing. Bridges of the
/// graph of curves have the same on both sides; within a block of it (curves any two of which lie
/// on a common loop) the outermost loop bounds and the rest lies inside. Fills nodes.boundary.
void tell_features(Arrangement& arrangement, Nodes& nodes);

/// Curves given more than once: notes those that are features, reports the others.
void report_copies(Arrangement& arrangement);

/// A closed sequence of features cut where other curves meet it.
std::vector<FeaturePath> paths_of(const std::vector<CurveUse>& loop, const Nodes& nodes);

/// The features as paths. `nodes` as tell_features left it.
std::vector<FeaturePath> feature_paths(const Arrangement& arrangement, const Nodes& nodes);

/// Reports features outside what the loops enclose, and open ones that were meant to close.
void check_features(Arrangement& arrangement, const Nodes& nodes, const std::vector<Loop>& loops,
                    const std::vector<FeaturePath>& features, const Pieces& pieces);

/// Notes lines shorter than `tolerance` (relative to the extent) between much longer curves. They
/// stay: the boundary is the input's.
void note_short(Arrangement& arrangement, const Nodes& nodes, double tolerance);

/// Loops of the curves, each starting with its lowest curve in the direction of most of its curves.
/// Reports loops that touch in a node; those form no loop.
std::vector<Loop> join(Arrangement& arrangement, const Nodes& nodes);

/// Reports derivatives that vanish. Returns per curve whether it is regular.
std::vector<char> check_derivatives(Arrangement& arrangement);

/// Reports joints where the boundary turns by 180 degrees. Returns per node whether it is a cusp.
std::vector<char> check_joints(Arrangement& arrangement, const Nodes& nodes,
                               const std::vector<char>& regular);

/// Reports self-intersections, crossings, touchings and overlaps of all regular curves.
void check_intersections(Arrangement& arrangement, const Nodes& nodes, const Pieces& pieces,
                         const std::vector<char>& cusp);

/// Orients and nests simple, disjoint loops by the fill rule, and gives each region its features:
/// `features` and the loops that bound nothing by the rule, which are noted.
std::vector<Region> nest(Arrangement& arrangement, const std::vector<Loop>& loops,
                         const std::vector<FeaturePath>& features, const Nodes& nodes,
                         const Pieces& pieces);

}  // namespace c1mesh::detail
