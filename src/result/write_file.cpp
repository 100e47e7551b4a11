// SPDX-License-Identifier: GPL-3.0-or-later
// A file appears whole, under its name, or not at all.
#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <list>

#include "c1mesh/error.h"
#include "c1mesh/result.h"
#include "result/unfinished.h"

namespace c1mesh {
namespace {

[[noreturn]] void fail(const std::string& action, const std::string& path) {
  const std::string reason = std::strerror(errno);
  throw FileError("cannot " + action + " " + path + ": " + reason);
}

void write_text(int descriptor, const std::string& text, const std::string& path) {
  const char* next = text.data();
  std::size_t left = text.size();
  while (left > 0) {
    const ssize_t done = ::write(descriptor, next, left);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("write", path);
    next += done;
    left -= static_cast<std::size_t>(done);
  }
}

// What a path means: names that are links lead on, so that a link stays what it is.
struct Target {
  std::string path;
  bool in_place = false;  // a device or a pipe, or a file that has no name any more
  mode_t mode = 0666;     // that of the file which is replaced, or, less the umask, a new one's
  bool replaces = false;
};

Target target_of(const std::string& path) {
  Target target{path};
  struct stat now = {}, link = {}, resolved = {};
  if (stat(path.c_str(), &now) != 0) return target;  // whatever is wrong, creating will say it
  if (S_ISDIR(now.st_mode)) {
    errno = EISDIR;
    fail("write", path);
  }
  // rename() asks for the folder's permission only; a file that is protected is to stay.
  if (access(path.c_str(), W_OK) != 0) fail("write", path);
  target.in_place = !S_ISREG(now.st_mode);
  target.replaces = true;
  target.mode = now.st_mode & 0777;
  if (!target.in_place && lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) {
    char* end = realpath(path.c_str(), nullptr);
    if (end != nullptr) target.path = end;
    free(end);
    target.in_place = stat(target.path.c_str(), &resolved) != 0 || resolved.st_ino != now.st_ino ||
                      resolved.st_dev != now.st_dev || target.path == path;
  }
  return target;
}

void write_in_place(const std::string& path, const std::string& text) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) fail("open", path);
  try {
    write_text(descriptor, text, path);
  } catch (...) {
    close(descriptor);
    throw;
  }
  if (close(descriptor) != 0) fail("close", path);
}

// ".NAME.XXXXXX" next to NAME: hidden, never a final name, on the same file system, as rename()
// needs. A long NAME is cut.
std::string temporary_name(const std::string& path) {
  constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  constexpr std::size_t kMark = 6;
  const std::size_t slash = path.find_last_of('/');
  const std::size_t base = slash == std::string::npos ? 0 : slash + 1;
  std::string name = path.substr(0, base) + "." + path.substr(base, NAME_MAX - kMark - 2) + ".";
  unsigned char random[kMark] = {};
  if (getrandom(random, sizeof random, 0) != static_cast<ssize_t>(sizeof random))
    fail("find a name next to", path);
  for (const unsigned char r : random) name += kLetters[r % (sizeof kLetters - 1)];
  return name;
}

/// A temporary file: closed and removed unless keep() was reached.
class Temporary {
 public:
  explicit Temporary(const Target& target) : target_(target.path) {
    constexpr int kTries = 100;
    for (int k = 0; descriptor_ < 0; ++k) {
      name_ = temporary_name(target_);
      descriptor_ = unfinished_.create(name_, target.mode);
      if (descriptor_ < 0 && (errno != EEXIST || k == kTries))
        fail("create a file next to", target_);
    }
    exists_ = true;
    // The umask is for new files; one that replaces another is as public as that was.
    if (target.replaces) chmod_ = target.mode;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    if (exists_) unlink(name_.c_str());
  }

  /// On the disk, all but the name.
  void fill(const std::string& text) {
    write_text(descriptor_, text, target_);
    if (chmod_ != 0 && fchmod(descriptor_, chmod_) != 0) fail("set the permissions of", target_);
    if (fsync(descriptor_) != 0) fail("flush", target_);
    const int closing = close(descriptor_);
    descriptor_ = -1;
    if (closing != 0) fail("close", target_);
  }

  void keep() {
    if (std::rename(name_.c_str(), target_.c_str()) != 0) fail("name", target_);
    exists_ = false;
    unfinished_.forget();
  }

 private:
  std::string target_, name_;
  Unfinished unfinished_;
  int descriptor_ = -1;
  mode_t chmod_ = 0;
  bool exists_ = false;
};

}  // namespace

void write_files(const std::vector<FileText>& files) {
  std::list<Temporary> temporaries;
  std::list<std::pair<std::string, const std::string*>> in_place;
  for (const FileText& file : files) {
    const Target target = target_of(file.path);
    if (target.in_place)
      in_place.emplace_back(file.path, &file.text);
    else
      temporaries.emplace_back(target).fill(file.text);
  }
  for (const auto& [path, text] : in_place) write_in_place(path, *text);
  for (Temporary& temporary : temporaries) temporary.keep();
}

void write_file(const std::string& path, const std::string& text) {
  write_files({{path, text}});
}

}  // namespace c1mesh
