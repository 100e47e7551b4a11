// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/version.h"

namespace c1mesh {

const char* version() {
  return C1MESH_VERSION;
}

}  // namespace c1mesh
