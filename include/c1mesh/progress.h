// SPDX-License-Identifier: GPL-3.0-or-later
// How a long run tells where it is and how it is stopped.
#pragma once

#include <functional>
#include <string>

namespace c1mesh {

/// Called often, from the thread that runs the work. `stage` names what is being done, `fraction`
/// in [0, 1] is how much of the whole is done. Returning false stops the run (Interrupted).
using Progress = std::function<bool(const std::string& stage, double fraction)>;

}  // namespace c1mesh
