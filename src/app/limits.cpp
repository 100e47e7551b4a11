// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/limits.h"

#include <gmp.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <limits>
#include <new>

#include "app/status.h"
#include "app/validators.h"

// Of the OpenMP library, if CHOLMOD was built with one.
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));

namespace c1mesh::app {
namespace {

// Where a library cannot start a thread, or allocate, in code that must not throw.
[[noreturn]] void end_for_lack_of_memory() {
  constexpr char kText[] = "error: out of memory (--memory-limit); nothing more was written\n";
  if (::write(STDERR_FILENO, kText, sizeof kText - 1) < 0)
    _exit(static_cast<int>(Status::internal));
  _exit(static_cast<int>(Status::limit));
}

// GMP's own functions end the process with a signal where there is no memory. It allows others to
// throw; what it held then is lost, which matters little to a process that is short of memory.
void* allocate(std::size_t size) {
  if (void* found = std::malloc(size)) return found;
  throw std::bad_alloc();
}

void* reallocate(void* old, std::size_t, std::size_t size) {
  if (void* found = std::realloc(old, size)) return found;
  throw std::bad_alloc();
}

void release(void* old, std::size_t) {
  std::free(old);
}

}  // namespace

void add_byte_limit(CLI::App& cli, ReadOptions& options) {
  cli.add_option("--max-bytes", options.max_bytes, "Larger files are refused")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000'000}).description(""));
}

void add_read_limits(CLI::App& cli, ReadOptions& options) {
  // More levels would need more stack than a program has by default.
  constexpr int kDeepest = 1000;
  add_byte_limit(cli, options);
  cli.add_option("--max-curves", options.max_curves, "Drawings of more curves are refused")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}).description(""));
  cli.add_option("--max-depth", options.max_depth, "Files nested deeper are refused")
      ->capture_default_str()
      ->check(CLI::Range(1, kDeepest).description("up to 1000"));
  cli.add_option("--max-characters", options.max_characters, "Texts longer than this are refused")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}).description(""));
}

void add_memory_limit(CLI::App& cli, double& megabytes, const char* whose) {
  cli.add_option("--memory-limit", megabytes, fmt::format("MB of address space{}; 0: none", whose))
      ->capture_default_str()
      ->check(at_least(0));
}

void limit_memory(double megabytes) {
  if (megabytes <= 0) return;
  const double most = static_cast<double>(std::numeric_limits<rlim_t>::max() / 2);
  const auto bytes = static_cast<rlim_t>(std::min(megabytes * 1e6, most));
  const rlimit limit = {bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
  mp_set_memory_functions(allocate, reallocate, release);
  // OpenMP ends the process, with status 1, if there is no memory for the stack of a thread.
  // CHOLMOD asks for numbers of threads; without levels it gets one.
  if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(0);
  std::set_terminate(end_for_lack_of_memory);
}

}  // namespace c1mesh::app
