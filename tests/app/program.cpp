// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace c1mesh::testing_app {
namespace fs = std::filesystem;

Folder::Folder() {
  std::string pattern = (fs::temp_directory_path() / "c1mesh_app_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  root_ = pattern;
  fs::create_directory(path("said"));
  fs::create_directory(path("work"));
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

std::string Folder::path(const std::string& name) const {
  return root_ + "/" + name;
}

void Folder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path("work/" + name), std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const {
  std::ifstream file(path("work/" + name), std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> Folder::files(const std::string& name) const {
  std::vector<std::string> found;
  const fs::path base = path("work/" + name);
  if (!fs::exists(base)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(base))
    if (entry.is_regular_file()) found.push_back(fs::relative(entry.path(), base).string());
  std::sort(found.begin(), found.end());
  return found;
}

Ran Folder::run(const std::string& arguments) const {
  const std::string command = "cd '" + path("work") + "' && { '" C1MESH_PROGRAM "' " + arguments +
                              "; } >../said/out 2>../said/err </dev/null";
  const int code = std::system(command.c_str());
  Ran ran;
  ran.status = WIFEXITED(code) ? WEXITSTATUS(code) : 128 + WTERMSIG(code);
  ran.out = read("../said/out");
  ran.err = read("../said/err");
  return ran;
}

}  // namespace c1mesh::testing_app
