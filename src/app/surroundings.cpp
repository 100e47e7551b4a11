// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/surroundings.h"

#include <fcntl.h>
#include <gmp.h>
#include <pthread.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "app/status.h"
#include "c1mesh/result.h"

namespace c1mesh::app {
namespace {

// Else a result's temporary file could be number 2, and messages would go into it. The way that
// does not fit makes every read or write an error.
void fill_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0) {
      const int wrong_way = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
      if (open("/dev/null", wrong_way) != descriptor) _exit(static_cast<int>(Status::internal));
    }
}

// GMP's own functions abort. Its C code has unwind tables and holds nothing but memory.
void* gmp_allocate(std::size_t size) {
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

void* gmp_reallocate(void* memory, std::size_t, std::size_t size) {
  if (void* moved = std::realloc(memory, size)) return moved;
  throw std::bad_alloc();
}

void gmp_release(void* memory, std::size_t) {
  std::free(memory);
}

void say(const char* text) {
  [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, text, std::strlen(text));
}

bool room_for_a_thread() {
  pthread_t thread;
  if (pthread_create(
          &thread, nullptr, [](void*) -> void* { return nullptr; }, nullptr) != 0)
    return false;
  pthread_join(thread, nullptr);
  return true;
}

// Where an exception may not pass: thrown in a destructor or in a library's callback.
[[noreturn]] void end_by_exception() {
  discard_unfinished_files();
  if (const std::exception_ptr thrown = std::current_exception()) {
    try {
      std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
      say("error: out of memory\n");
      _exit(static_cast<int>(Status::limit));
    } catch (const std::exception& error) {
      // TBB says so where no thread can be made, also in destructors.
      if (!room_for_a_thread()) {
        say("error: out of memory: no more threads\n");
        _exit(static_cast<int>(Status::limit));
      }
      say("error: internal error: ");
      say(error.what());
      say("\n");
    } catch (...) {
      say("error: internal error\n");
    }
  }
  _exit(static_cast<int>(Status::internal));
}

}  // namespace

void prepare_process() {
  fill_standard_descriptors();
  mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_release);
  std::set_terminate(end_by_exception);
}

bool standard_output_is_whole() {
  std::cout.flush();
  const bool whole = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (!whole) say("error: cannot write to standard output\n");
  return whole;
}

}  // namespace c1mesh::app
