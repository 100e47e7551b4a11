// SPDX-License-Identifier: GPL-3.0-or-later
// A file appears whole, under its name, or not at all.
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "c1mesh/error.h"
#include "c1mesh/result.h"

namespace c1mesh {
namespace {

/// The temporary file: closed and removed unless keep() was reached.
class Temporary {
 public:
  /// Creates a file of a fresh name next to `path`: rename() is atomic within a file system only.
  explicit Temporary(const std::string& path) : target_(path) {
    const std::size_t slash = path.find_last_of('/');
    const std::size_t base = slash == std::string::npos ? 0 : slash + 1;
    name_ = path.substr(0, base) + "." + path.substr(base) + ".XXXXXX";
    descriptor_ = mkstemp(name_.data());
    if (descriptor_ < 0) fail("create a file next to");
    created_ = true;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    if (created_) unlink(name_.c_str());
  }

  void write(const std::string& text) {
    const char* next = text.data();
    std::size_t left = text.size();
    while (left > 0) {
      const ssize_t done = ::write(descriptor_, next, left);
      if (done < 0 && errno == EINTR) continue;
      if (done < 0) fail("write");
      next += done;
      left -= static_cast<std::size_t>(done);
    }
  }

  /// Flushes to the disk, then gives the file its name.
  void keep() {
    // mkstemp makes the file private; a result is as public as any new file of this process.
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(descriptor_, 0666 & ~mask) != 0) fail("set the permissions of");
    if (fsync(descriptor_) != 0) fail("flush");
    const int closing = close(descriptor_);
    descriptor_ = -1;
    if (closing != 0) fail("close");
    if (std::rename(name_.c_str(), target_.c_str()) != 0) fail("name");
    created_ = false;
  }

 private:
  [[noreturn]] void fail(const std::string& action) const {
    const std::string reason = std::strerror(errno);
    throw FileError("cannot " + action + " " + target_ + ": " + reason);
  }

  std::string target_, name_;
  int descriptor_ = -1;
  bool created_ = false;
};

}  // namespace

void write_file(const std::string& path, const std::string& text) {
  Temporary file(path);
  file.write(text);
  file.keep();
}

}  // namespace c1mesh
