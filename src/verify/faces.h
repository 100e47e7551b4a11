// SPDX-License-Identifier: GPL-3.0-or-later
// The faces into which feature edges divide the surface, by the closed runs of edges around them.
#pragma once

#include <vector>

#include "verify/checks.h"

namespace c1mesh::verification {

/// The simple closed runs of boundary and feature edges that have a face on their left, as vertex
/// ids. Walks around faces are cut where they come back to a vertex; edges run to and fro are left
/// out.
std::vector<std::vector<int>> face_cycles(const Subject& subject);

/// Vertices where three or more boundary and feature edges meet, increasing.
std::vector<int> branch_points(const Subject& subject);

}  // namespace c1mesh::verification
