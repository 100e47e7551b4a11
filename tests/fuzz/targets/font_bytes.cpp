// SPDX-License-Identifier: GPL-3.0-or-later
// A font from strangers: FreeType parses it, we take its outlines.
#include "c1mesh/font.h"
#include "fuzz/targets/drawings.h"

C1MESH_FUZZ_TARGET(font_bytes) {
  using namespace c1mesh;
  const fuzz::MemoryFile font(bytes);
  fuzz::accepted([&] { fuzz::examine(read_font(font.path(), "AB")); });
}
