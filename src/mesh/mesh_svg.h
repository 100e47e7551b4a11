// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a mesh pair, for looking at one stage alone.
#pragma once

#include <string>

#include "mesh/curved_mesh.h"

namespace c1mesh {

/// An SVG document with the curved mesh T on the left and the straight mesh T^ on the right, 800
/// units each; warped triangles are tinted, edges and vertices on curves stand out. Edges of T are
/// drawn exactly up to degree 3 and by 16 chords above.
std::string mesh_svg(const CurvedMesh& mesh);

}  // namespace c1mesh
