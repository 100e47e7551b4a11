// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "app/command.h"

namespace c1mesh::app {
namespace {
namespace fs = std::filesystem;

constexpr std::size_t kLongestList = 200'000'000;  // bytes, about a million paths

std::vector<std::string> files_of_folder(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string extension = it->path().extension().string();
    if (extension == ".json" || extension == ".svg") paths.push_back(it->path().string());
  }
  if (error) throw FileError(folder + ": cannot be read: " + error.message());
  return paths;
}

std::vector<std::string> lines_of_list(const std::string& path) {
  std::vector<std::string> paths;
  std::istringstream text(read_bytes(path, kLongestList));
  for (std::string line; std::getline(text, line);) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
    if (!line.empty() && line.front() != '#') paths.push_back(line);
  }
  return paths;
}

// Does `text` begin with `stem` and one of the characters after it?
bool extends(const std::string& text, const std::string& stem, char separator) {
  return text.size() > stem.size() && text[stem.size()] == separator && text.starts_with(stem);
}

}  // namespace

bool BatchInput::many() const {
  return !path.ends_with(".json");
}

std::string Shard::suffix() const {
  return whole() ? "" : fmt::format(".{}-of-{}", index, count);
}

Shard Shard::parse(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    if (second.ec == std::errc() && second.ptr == end && shard.index >= 1 &&
        shard.index <= shard.count)
      return shard;
  }
  throw std::invalid_argument("must be I/N with 1 <= I <= N");
}

std::vector<BatchInput> batch_inputs(const std::string& list_or_folder) {
  std::error_code ignored;
  std::vector<std::string> paths = fs::is_directory(list_or_folder, ignored)
                                       ? files_of_folder(list_or_folder)
                                       : lines_of_list(list_or_folder);
  std::sort(paths.begin(), paths.end());
  std::vector<BatchInput> inputs;
  Stems stems;
  for (const std::string& path : paths) {
    BatchInput input{path, ""};
    input.stem = stems.claim(fs::path(path).stem().string(), input.many());
    inputs.push_back(std::move(input));
  }
  return inputs;
}

std::vector<BatchInput> part_of(const std::vector<BatchInput>& inputs, const Shard& shard) {
  std::vector<BatchInput> part;
  for (std::size_t i = static_cast<std::size_t>(shard.index - 1); i < inputs.size();
       i += static_cast<std::size_t>(shard.count))
    part.push_back(inputs[i]);
  return part;
}

// write_file calls its temporary files .TARGET.XXXXXX. Whose they are the stems tell, as no two
// clash.
void remove_leftovers(const std::string& folder, const std::vector<BatchInput>& inputs) {
  constexpr std::size_t kRandomPart = 7;
  std::map<std::string, bool> ours;
  for (const BatchInput& input : inputs) ours.emplace(input.stem, input.many());
  std::vector<fs::path> leftovers;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string file = it->path().filename().string();
    if (file.front() != '.' || file.size() <= kRandomPart + 1) continue;
    const std::string target = file.substr(1, file.size() - 1 - kRandomPart);
    for (std::size_t at = target.find_first_of(".-"); at != std::string::npos;
         at = target.find_first_of(".-", at + 1)) {
      const auto owner = ours.find(target.substr(0, at));
      if (owner != ours.end() && (target[at] == '.' || owner->second))
        leftovers.push_back(it->path());
    }
  }
  for (const fs::path& path : leftovers) fs::remove(path, error);
}

// The files of a result are called NAME.ANYTHING, so that "a" and "a.domain" could meet in
// a.domain.vtu; with several drawings they are called STEM-ID.ANYTHING.
bool Stems::clashes(const std::string& stem, bool many) const {
  if (taken_.count(stem)) return true;
  const auto is_longer = [&](char separator) {
    const auto next = taken_.lower_bound(stem + separator);
    return next != taken_.end() && extends(next->first, stem, separator);
  };
  if (is_longer('.') || (many && is_longer('-'))) return true;
  for (std::size_t at = stem.find_first_of(".-"); at != std::string::npos;
       at = stem.find_first_of(".-", at + 1)) {
    const auto shorter = taken_.find(stem.substr(0, at));
    if (shorter != taken_.end() && (stem[at] == '.' || shorter->second)) return true;
  }
  return false;
}

std::string Stems::claim(const std::string& wanted, bool many) {
  const std::string name = safe_name(wanted);
  std::string stem = name;
  // Where the last search ended: a list may give one name a hundred thousand times.
  int& number = last_.emplace(name, 1).first->second;
  while (clashes(stem, many)) {
    ++number;
    // A name whose beginning clashes would clash again with a mark at its end: the mark then goes
    // before the first separator, so that no beginning is the same.
    const std::size_t at = taken_.count(stem) ? name.size() : name.find_first_of(".-");
    stem = name;
    stem.insert(std::min(at, name.size()), fmt::format("~{}", number));
  }
  taken_.emplace(stem, many);
  return stem;
}

}  // namespace c1mesh::app
