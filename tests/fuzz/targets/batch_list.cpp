// SPDX-License-Identifier: GPL-3.0-or-later
// The list of a batch, and its journal: a first byte J chooses the latter.
#include <set>
#include <stdexcept>

#include "app/batch_inputs.h"
#include "app/batch_journal.h"
#include "fuzz/target.h"

namespace {

using namespace c1mesh;

void read_list(const std::string& bytes) {
  const fuzz::MemoryFile file(bytes);
  std::set<std::string> stems;
  for (const app::BatchInput& input : app::batch_inputs(file.path())) {
    fuzz::require(!input.path.empty(), "an input without a path");
    fuzz::require(stems.insert(input.stem).second, "two inputs of one stem");
    fuzz::require(input.stem.find('/') == std::string::npos, "a stem that leaves the folder");
  }
}

void read_journal(const std::string& bytes) {
  const fuzz::MemoryFile file(bytes);
  try {
    app::Journal(file.path(), {{"c1mesh", "0"}}, true);
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace

C1MESH_FUZZ_TARGET(batch_list) {
  if (!bytes.empty() && bytes.front() == 'J')
    read_journal(bytes.substr(1));
  else
    fuzz::accepted([&] { read_list(bytes); });
}
