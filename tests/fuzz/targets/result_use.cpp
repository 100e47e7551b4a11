// SPDX-License-Identifier: GPL-3.0-or-later
// What the other commands do with a result file: draw, convert, evaluate, project.
#include <stdexcept>

#include "c1mesh/evaluate.h"
#include "c1mesh/project.h"
#include "c1mesh/result.h"
#include "c1mesh/write.h"
#include "fuzz/target.h"

C1MESH_FUZZ_TARGET(result_use) {
  using namespace c1mesh;
  constexpr std::size_t kSmall = 64;
  Result result;
  if (!fuzz::accepted([&] { result = parse_result(bytes, "fuzz"); })) return;
  if (result.triangles.size() > kSmall || result.curves.size() > kSmall || result.degree > 6)
    return;
  for (const char* file : {"a.vtu", "a.domain.vtu", "a.msh", "a.mesh", "a.obj", "a.svg"})
    fuzz::accepted([&] { convert(result, file, {VtuCells::lagrange, 2}); });
  fuzz::accepted([&] { evaluate(result); });
  fuzz::accepted([&] { project(result); });
}
