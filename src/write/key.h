// SPDX-License-Identifier: GPL-3.0-or-later
// The key below a picture: what its lines and dots mean.
#pragma once

#include <string>

#include "c1mesh/write.h"

namespace c1mesh {

/// What there is of in a picture.
struct KeyContents {
  bool lines = false, exceptional = false, relaxed = false, features = false, net = false,
       over = false;
};

/// An SVG group `key` with its height in pixels.
struct Key {
  std::string svg;
  double height = 0;
};

/// In rows within `width`; empty if there is nothing to tell.
Key key_of(const KeyContents& contents, double left, double top, double width);

}  // namespace c1mesh
