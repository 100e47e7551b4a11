// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch works on: which files, how their results are named, which shard does them. All of it
// is decided by the paths alone, before any work, so that it is the same in every process.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace c1mesh::app {

/// A file with one or, if it is not a `.json`, several drawings.
struct BatchInput {
  std::string path;
  std::string stem;  ///< results are named STEM, or STEM-ID each where there are several

  /// May the file hold several drawings?
  bool many() const;
};

/// The part INDEX of COUNT (from 1) of a batch.
struct Shard {
  int index = 1, count = 1;

  bool whole() const { return count == 1; }
  /// "" for the whole, else ".INDEX-of-COUNT": what the shard's own files have in their names.
  std::string suffix() const;
  /// "I/N" with 1 <= I <= N. Throws std::invalid_argument.
  static Shard parse(const std::string& text);
};

/// Every `.json` and `.svg` of a folder, or the paths in a list (one per line, blank lines and
/// lines that begin with # left out; "-": the list is read from standard input); in order of path,
/// with distinct stems. Throws FileError.
std::vector<BatchInput> batch_inputs(const std::string& list_or_folder);

/// Every COUNTth input, beginning with the INDEXth.
std::vector<BatchInput> part_of(const std::vector<BatchInput>& inputs, const Shard& shard);

/// Removes the temporary files that killed processes of these inputs left in the folder.
void remove_leftovers(const std::string& folder, const std::vector<BatchInput>& inputs);

/// Hands out stems under which no two inputs can write a file of the same name.
class Stems {
 public:
  /// `wanted`, or with "~2", "~3", … appended. `many`: results may be called STEM-ANYTHING.
  std::string claim(const std::string& wanted, bool many);

 private:
  bool clashes(const std::string& stem, bool many) const;

  std::map<std::string, int> last_;  // per name wanted: the last number tried
  // stem -> many; the batch's own files have names too.
  std::map<std::string, bool> taken_ = {{"index", false}, {"times", false}, {"journal", false}};
};

}  // namespace c1mesh::app
