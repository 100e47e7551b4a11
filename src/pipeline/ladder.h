// SPDX-License-Identifier: GPL-3.0-or-later
// The ladder of remedies: from the fewest exceptional vertices to what always works.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "c1mesh/options.h"
#include "optimise/attempt.h"

namespace c1mesh {

/// A region's map, always valid; the remedies say what it took.
struct RegionSolution {
  CurvedMesh mesh;  ///< domain and control points final
  Joints joints;
  std::vector<int> exceptional;  ///< vertices, interior ones only in the last resort
  std::vector<std::array<int, 2>> relaxed;
  double g = 0;
  std::vector<std::string> remedies;
  Roles first_roles;         ///< of the first try, on the initial mesh
  bool gave_up = false;      ///< the last resort: no boundary vertex keeps C1
  bool interrupted = false;  ///< the time limit cut the search short
};

/// How much is tried on large meshes, in triangles of the initial mesh.
struct SearchLimits {
  int searchable = 100000;  ///< larger ones have no search for a C1 map; these take up to 5 GiB
  int tried_often = 20000;  ///< larger ones have one try: further ones mostly fail as well
  int iterations = 300;     ///< of that one try; three times what it takes where it succeeds
};

/// `bound`: g asked for (alpha mu). The checkpoint may throw TimeLimitReached, after which the best
/// valid state so far is returned, or anything else, which is passed on. `start`, if not empty:
/// roles to which exceptional vertices are added, the first roles of a solution with fewer.
RegionSolution solve_region(const CurvedMesh& initial, const Options& options,
                            const Checkpoint& checkpoint, const Roles& start = {},
                            const SearchLimits& limits = {});

}  // namespace c1mesh
