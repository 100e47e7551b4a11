// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/read_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "base/read_blocks.h"
#include "c1mesh/error.h"

namespace c1mesh {

std::string read_file(const std::string& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw FileError(path + " is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError("cannot open " + path + ": " + std::strerror(errno));
  std::optional<std::string> text = read_at_most(file, max_bytes);
  if (!text) {
    Defect defect;
    defect.kind = DefectKind::limit;
    defect.message = fmt::format("the file is larger than {} bytes", max_bytes);
    defect.remedy = "raise the limit (--max-bytes), if it is c1mesh's own";
    throw InputError({defect});
  }
  if (file.bad()) throw FileError("cannot read " + path);
  return *std::move(text);
}

}  // namespace c1mesh
