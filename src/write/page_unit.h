// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace c1mesh {

/// How large a picture of so many pixels draws what is one pixel thick at common sizes (600 to 1200
/// pixels). Larger pictures are the same enlarged; smaller ones shrink half as fast, so that at
/// 300 pixels text can still be read.
inline double page_unit(double width) {
  if (width > 1200) return width / 1200;
  return width < 600 ? 0.5 + 0.5 * width / 600 : 1;
}

}  // namespace c1mesh
