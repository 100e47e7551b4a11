// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/target.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace c1mesh::fuzz {

std::map<std::string, Target>& targets() {
  static std::map<std::string, Target> table;
  return table;
}

void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

bool accepted(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const InputError& error) {
    require(!error.defects().empty(), "an input is refused without a defect");
    for (const Defect& defect : error.defects()) {
      require(!defect.message.empty(), "a defect without a message");
      if (!defect.repaired && defect.kind != DefectKind::note && defect.remedy.empty())
        finding("a defect without a remedy: " + defect.message);
    }
  } catch (const FileError&) {
  } catch (const Interrupted&) {  // a time limit
  }
  return false;
}

MemoryFile::MemoryFile(const std::string& bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
  require(descriptor_ >= 0, "no file in memory");
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t now = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
    require(now > 0, "a file in memory cannot be written");
    done += static_cast<std::size_t>(now);
  }
}

MemoryFile::~MemoryFile() {
  close(descriptor_);
}

std::string MemoryFile::path() const {
  return "/proc/self/fd/" + std::to_string(descriptor_);
}

}  // namespace c1mesh::fuzz
