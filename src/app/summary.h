// SPDX-License-Identifier: GPL-3.0-or-later
// The table that `run` prints per result, and the verdict on what was asked.
#pragma once

#include <string>
#include <vector>

#include "app/console.h"
#include "c1mesh/cost.h"
#include "c1mesh/options.h"
#include "c1mesh/parametrize.h"
#include "c1mesh/trade_off.h"

namespace c1mesh::app {

/// What the result misses of what was asked, a sentence each; empty: nothing.
std::vector<std::string> missed_bounds(const Outcome& outcome, const Options& options);

/// Several lines without a final newline.
std::string summary(const Console& console, const Outcome& outcome, const Options& options,
                    const std::vector<std::string>& files);

/// What each stage cost, all together, and the process's peak of memory so far; in all and per
/// triangle (`triangles` 0: in all only).
std::string cost_lines(const CostLedger& ledger, int triangles);

/// The curve, a line per point, without a final newline.
std::string trade_off_lines(const TradeOff& curve, const std::vector<std::string>& files);

/// "name  verdict  message" for every item of a verification.
std::string item_lines(const Console& console, const VerifyReport& report);

}  // namespace c1mesh::app
