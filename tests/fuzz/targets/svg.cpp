// SPDX-License-Identifier: GPL-3.0-or-later
// SVG documents, drawing by drawing and together, and the check of what was read.
#include "fuzz/targets/drawings.h"

C1MESH_FUZZ_TARGET(svg) {
  using namespace c1mesh;
  for (const bool together : {false, true}) {
    ReadOptions options;
    options.together = together;
    options.max_curves = 1000;  // a few bytes of nested `use` ask for more than that
    std::vector<Drawing> drawings;
    if (fuzz::accepted([&] { drawings = read_drawings_from(bytes, "fuzz", options); }))
      fuzz::examine(drawings);
  }
}
