// SPDX-License-Identifier: GPL-3.0-or-later
// A text from strangers, set in a font of ours.
#include "c1mesh/font.h"
#include "fuzz/targets/drawings.h"

C1MESH_FUZZ_TARGET(font_text) {
  using namespace c1mesh;
  for (const bool together : {false, true}) {
    ReadOptions options;
    options.together = together;
    fuzz::accepted([&] { fuzz::examine(read_font(C1MESH_FUZZ_FONT, bytes, options)); });
  }
}
