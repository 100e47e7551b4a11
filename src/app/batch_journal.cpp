// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch_journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "app/command.h"

namespace c1mesh::app {
namespace {

[[noreturn]] void fail(const std::string& path, const char* action) {
  throw WriteError(fmt::format("cannot {} {}: {}", action, path, std::strerror(errno)));
}

Json to_json(const Finished& input) {
  return {{"key", input.key},
          {"records", input.records},
          {"seconds", input.seconds},
          {"files", input.files}};
}

Finished from_json(const Json& json) {
  return {json.at("key"), json.at("records").get<std::vector<Json>>(), json.at("seconds"),
          json.at("files")};
}

// Copies of trees recurse, and nothing of a journal is deep.
bool refuse_depth(int depth, Json::parse_event_t, Json&) {
  constexpr int kDeepest = 32;
  if (depth > kDeepest)
    throw std::invalid_argument(
        fmt::format("no journal of a batch: nested deeper than {} levels", kDeepest));
  return true;
}

// A sentence for each value that differs.
std::string differences(const Json& before, const Json& now) {
  std::string out;
  for (const auto& [name, value] : now.items()) {
    const Json old = before.contains(name) ? before[name] : Json();
    if (old != value)
      out += fmt::format("{}{} was {} and is {}", out.empty() ? "" : "; ", name, line_of(old),
                         line_of(value));
  }
  return out;
}

}  // namespace

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string hash_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return fmt::format("{:016x}", hash);
}

Journal::Journal(const std::string& path, const Json& header, bool resume) : path_(path) {
  descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path, "open");
  try {
    hold();
    read_lines(header, resume);
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  close(descriptor_);
}

// A record lock is this process's alone: children do not inherit it, so that it ends with us.
// (Closing any other descriptor of the file would end it too; nothing here opens the file twice.)
// File systems without locks go without: only a process that surely holds it is an obstacle.
void Journal::hold() {
  struct flock whole = {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(descriptor_, F_SETLK, &whole) != 0 && (errno == EACCES || errno == EAGAIN))
    throw std::invalid_argument(path_ + ": another process works on this batch");
}

std::string Journal::text() const {
  std::string text;
  std::vector<char> block(1 << 16);
  while (const ssize_t count = ::read(descriptor_, block.data(), block.size())) {
    if (count < 0 && errno != EINTR) fail(path_, "read");
    if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
  }
  return text;
}

void Journal::read_lines(const Json& header, bool resume) {
  const std::string text = this->text();
  const std::size_t whole = text.rfind('\n') + 1;  // npos + 1 is 0
  if (whole < text.size() && ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
    fail(path_, "shorten");
  for (std::size_t at = 0; at < whole;) {
    const std::size_t end = text.find('\n', at);
    try {
      const Json line = Json::parse(text.substr(at, end - at), refuse_depth);
      if (at == 0 && line != header)
        throw std::invalid_argument(
            fmt::format("{} was begun with another program or other options ({}): use those, or "
                        "another folder",
                        path_, differences(line, header)));
      if (at > 0) {
        Finished input = from_json(line);
        finished_.insert_or_assign(input.key, std::move(input));
      }
    } catch (const Json::exception& error) {
      throw std::invalid_argument(
          fmt::format("{} is no journal of a batch: {}", path_, error.what()));
    }
    at = end + 1;
  }
  if (whole == 0) write_line(header);
  if (!finished_.empty() && !resume)
    throw std::invalid_argument(fmt::format(
        "{} says that {} inputs are finished: go on with --resume, or use another folder", path_,
        finished_.size()));
}

const Finished* Journal::find(const std::string& key) const {
  const auto found = finished_.find(key);
  return found == finished_.end() ? nullptr : &found->second;
}

void Journal::append(const Finished& input) {
  write_line(to_json(input));
}

void Journal::write_line(const Json& json) {
  const std::string text = line_of(json) + "\n";
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t now = ::write(descriptor_, text.data() + done, text.size() - done);
    if (now < 0 && errno != EINTR) fail(path_, "write");
    if (now > 0) done += static_cast<std::size_t>(now);
  }
  if (fsync(descriptor_) != 0) fail(path_, "flush");
}

}  // namespace c1mesh::app
