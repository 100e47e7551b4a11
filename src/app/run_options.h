// SPDX-License-Identifier: GPL-3.0-or-later
// What `run` and `batch` may be asked of every shape: one definition of the options for both.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "c1mesh/options.h"
#include "c1mesh/shape.h"

namespace c1mesh::app {

struct RunOptions {
  std::string folder;  ///< of the output; "-" (`run` only): the JSON alone to standard output
  std::vector<std::string> formats = {"json", "svg"};
  std::string certificate;  ///< a file for the certificate (`run` only); empty: none
  bool trade_off = false;
  ReadOptions read;
  Options options;

  bool wants(const std::string& format) const;
};

/// --formats, --together, the limits of reading, --trade-off and the options of the method.
void add_run_options(CLI::App& cli, RunOptions& options);

/// --together alone.
void add_together(CLI::App& cli, ReadOptions& options);

/// The values of a command's options, name to text, but for those named: what its results depend
/// on.
std::map<std::string, std::string> values_of(const CLI::App& cli,
                                             const std::set<std::string>& left_out);

}  // namespace c1mesh::app
