// SPDX-License-Identifier: GPL-3.0-or-later
#include "result/unfinished.h"

#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "c1mesh/result.h"

namespace c1mesh {
namespace {

enum State : int { unused, named, opening, opened };

/// Static memory: a signal handler can neither allocate nor follow what another thread frees.
struct Slot {
  std::atomic<int> state{unused};
  std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<int>::is_always_lock_free);

// Files that one call has in work together are few; what finds no slot is written all the same.
std::array<Slot, 64> slots;
std::atomic<bool> discarding{false};

int claim(const std::string& path) {
  if (path.size() >= PATH_MAX) return -1;
  for (std::size_t k = 0; k < slots.size(); ++k) {
    int expected = unused;
    if (!slots[k].state.compare_exchange_strong(expected, named)) continue;
    std::memcpy(slots[k].path.data(), path.c_str(), path.size() + 1);
    return static_cast<int>(k);
  }
  return -1;
}

/// No signal is handled in this thread while it lives.
class Undisturbed {
 public:
  Undisturbed() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~Undisturbed() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

// A handler in another thread waits for `opening` to end, so that it sees every file that will
// exist; one in this thread would wait for ever, hence Undisturbed.
int Unfinished::create(const std::string& path, mode_t mode) {
  forget();
  const Undisturbed undisturbed;
  slot_ = claim(path);
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state = opening;
  int descriptor = -1, reason = ECANCELED;
  if (!discarding) {
    descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    reason = errno;
  }
  if (descriptor < 0)
    forget();
  else if (slot_ >= 0)
    slots[static_cast<std::size_t>(slot_)].state = opened;
  errno = reason;
  return descriptor;
}

void Unfinished::forget() {
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state = unused;
  slot_ = -1;
}

void discard_unfinished_files() noexcept {
  constexpr int kMilliseconds = 1000;  // a file system that hangs must not hold the process
  const int reason = errno;
  discarding = true;
  for (Slot& slot : slots) {
    const timespec millisecond = {0, 1'000'000};
    for (int k = 0; slot.state == opening && k < kMilliseconds; ++k)
      nanosleep(&millisecond, nullptr);
    if (slot.state == opened) unlink(slot.path.data());
  }
  errno = reason;
}

}  // namespace c1mesh
