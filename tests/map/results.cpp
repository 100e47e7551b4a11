// SPDX-License-Identifier: GPL-3.0-or-later
#include "map/results.h"

#include "c1mesh/parametrize.h"

namespace c1mesh::testing_map {

Result result_of(const std::string& example, int degree) {
  Options options;
  options.degree = degree;
  const Drawing drawing = read_drawings(C1MESH_EXAMPLES "/" + example).at(0);
  return parametrize(make_shape(drawing), options).result;
}

}  // namespace c1mesh::testing_map
