// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "c1mesh/types.h"

namespace c1mesh {

/// There is no mesh: curves come too close to each other to be told apart in double precision, or
/// so close that more triangles would be needed than can be afforded.
class NoMesh : public std::runtime_error {
 public:
  explicit NoMesh(const std::string& what) : std::runtime_error(what) {}
  /// `curve` as in LoopCurve; `where` in the frame of the mesh's input.
  NoMesh(const std::string& what, int at_curve, const Point& at)
      : std::runtime_error(what), curve(at_curve), where(at) {}

  int curve = -1;  ///< -1: not known, nor is `where`
  Point where = Point::Zero();
};

}  // namespace c1mesh
