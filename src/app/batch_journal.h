// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch remembers of finished inputs, so that it can be ended at any moment and resumed.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace c1mesh::app {

/// Keys stay in the order in which they were set: lines of an index sort by their first, the input.
using Json = nlohmann::ordered_json;

/// One line of text without line break; bytes that are no UTF-8 become U+FFFD.
std::string line_of(const Json& json);

/// A 64-bit FNV-1a hash in hexadecimal: tells changes of files, not attacks.
std::string hash_of(const std::string& bytes);

/// An input that needs no more work.
struct Finished {
  std::string key;                 ///< of path, stem and content
  std::vector<Json> records;       ///< lines of the index
  std::vector<double> seconds;     ///< per record
  std::vector<std::string> files;  ///< of its results, relative to the output folder
};

/// An append-only file: a first line that says what every result depends on, then one line per
/// finished input, each on the disk before append() returns. Only one process can hold it.
class Journal {
 public:
  /// Opens or begins the journal. A last line without an end is cut off: it was torn. Throws
  /// std::invalid_argument if the journal holds finished inputs and `resume` is not set, if it was
  /// begun with another `header`, or if another process holds it; WriteError if it cannot be
  /// written.
  Journal(const std::string& path, const Json& header, bool resume);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The finished input of this key, or null.
  const Finished* find(const std::string& key) const;
  void append(const Finished& input);

 private:
  void hold();
  std::string text() const;
  void read_lines(const Json& header, bool resume);
  void write_line(const Json& json);

  std::string path_;
  int descriptor_ = -1;
  std::map<std::string, Finished> finished_;
};

}  // namespace c1mesh::app
