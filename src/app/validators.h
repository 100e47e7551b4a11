// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges of numbers and sets of names on the command line.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace c1mesh::app {

// CLI::Range lets "nan" through. No comparison with it: that is an invalid operation.
inline CLI::Validator at_least(double least, double most = std::numeric_limits<double>::max()) {
  const bool open = most == std::numeric_limits<double>::max();
  const std::string range =
      open ? fmt::format("at least {}", least) : fmt::format("from {} to {}", least, most);
  return {[=](const std::string& text) {
            double value = 0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && !std::isnan(value) && value >= least && value <= most
                       ? ""
                       : "must be a number " + range;
          },
          range, "at_least"};
}

inline CLI::Validator above(double least) {
  const std::string range = fmt::format("above {}", least);
  return {[=](const std::string& text) {
            double value = 0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && !std::isnan(value) && value > least ? "" : "must be a number " + range;
          },
          range, "above"};
}

// The help and the completions say the names, not the numbers behind them.
template <class Enum>
CLI::Validator one_of(const std::map<std::string, Enum>& choices) {
  std::string names;
  for (const auto& choice : choices) names += (names.empty() ? "" : ",") + choice.first;
  return CLI::CheckedTransformer(choices).description("{" + names + "}");
}

}  // namespace c1mesh::app
