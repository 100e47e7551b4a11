// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the real program in a folder of its own and keeps what it said.
#pragma once

#include <string>
#include <vector>

namespace c1mesh::testing_app {

struct Ran {
  int status = -1;  ///< exit status; 128 + signal if a signal ended it
  std::string out, err;
};

/// A fresh folder, removed at the end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name = "") const;
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  std::vector<std::string> files(const std::string& name = "") const;  ///< sorted, relative

  /// Runs "c1mesh ARGUMENTS" with this folder as the current one. `arguments` goes to the shell.
  Ran run(const std::string& arguments) const;

 private:
  std::string root_;
};

}  // namespace c1mesh::testing_app
