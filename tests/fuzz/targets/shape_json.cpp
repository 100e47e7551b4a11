// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as JSON, and the check of what was read.
#include "fuzz/targets/drawings.h"

C1MESH_FUZZ_TARGET(shape_json) {
  using namespace c1mesh;
  std::vector<Drawing> drawings;
  if (fuzz::accepted([&] { drawings = read_drawings_from(bytes, "fuzz"); }))
    fuzz::examine(drawings);
}
