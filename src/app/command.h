// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands share: registering, errors to statuses, reading, writing, naming.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/status.h"
#include "c1mesh/result.h"
#include "c1mesh/shape.h"

namespace c1mesh::app {

/// A subcommand and what to do when it was chosen.
struct Command {
  CLI::App* cli = nullptr;
  std::function<Status(Console&)> action;
};

Command add_run(CLI::App& app);
Command add_check(CLI::App& app);
Command add_verify(CLI::App& app);
Command add_draw(CLI::App& app);
Command add_project(CLI::App& app);
Command add_convert(CLI::App& app);
Command add_generate(CLI::App& app);
Command add_evaluate(CLI::App& app);
Command add_batch(CLI::App& app);

/// An output file could not be written.
struct WriteError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs `work` for one input, says what went wrong, and turns exceptions into statuses.
Status guarded(Console& console, const std::string& input, const std::function<Status()>& work);

/// The file's drawings, at least one. Throws as c1mesh::read_drawings.
std::vector<Drawing> read_input(const std::string& path, const ReadOptions& options);

/// Prints each defect on a line of its own, prefixed by the input's name.
void say_defects(Console& console, const std::string& input, const std::vector<Defect>& defects);

/// Writes to the file, or to standard output if `path` is "-". Throws WriteError.
void deliver(const std::string& path, const std::string& text);

/// Writes files that belong together, what goes to standard output first: all of them or, throwing
/// WriteError, none.
void deliver_together(const std::vector<FileText>& files);

/// Creates the folder with its parents. Throws WriteError.
void create_folder(const std::string& path);

/// Creates the folder that the file is to be in, if its path names one. Throws WriteError.
void create_folder_of(const std::string& file);

/// `wanted` without separators and control characters, not empty, not hidden, not like an option.
std::string safe_name(const std::string& wanted);

/// Names for output files: free of separators and of control characters, never handed out twice.
class OutputNames {
 public:
  /// `wanted` made safe; if it was claimed before, with "-2", "-3", … appended.
  std::string claim(const std::string& wanted);

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> last_;  // per name: the last number tried
};

}  // namespace c1mesh::app
