// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interrupt.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

#include "app/status.h"
#include "c1mesh/result.h"

namespace c1mesh::app {
namespace {

constexpr std::array kAskToEnd = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};
constexpr std::array kKill = {SIGQUIT, SIGABRT, SIGSEGV, SIGBUS,  SIGFPE, SIGILL,
                              SIGSYS,  SIGTRAP, SIGUSR1, SIGUSR2, SIGALRM};

std::atomic<bool> orderly{false};
std::atomic<unsigned long long> asked_by{0};  // a bit per signal
static_assert(std::atomic<unsigned long long>::is_always_lock_free);

void die_of(int signal) {
  struct sigaction action = {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
  raise(signal);  // comes when the handler returns
}

extern "C" void c1mesh_on_request(int signal) {
  const unsigned long long bit = 1ULL << signal;
  const bool again = (asked_by.fetch_or(bit) & bit) != 0;
  if (orderly && !again) return;
  discard_unfinished_files();
  if (orderly) return die_of(signal);
  constexpr char kText[] = "error: stopped by a signal\n";
  [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, kText, sizeof kText - 1);
  _exit(static_cast<int>(Status::limit));
}

extern "C" void c1mesh_on_death(int signal) {
  discard_unfinished_files();
  die_of(signal);
}

bool has_default(int signal) {
  struct sigaction now = {};
  return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL;
}

void on(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  // No SA_RESTART: a signal also ends a read from a terminal. A stack of its own: an overflow of
  // the stack is one of these signals.
  action.sa_flags = SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

void give_signals_a_stack() {
  static std::array<char, 1 << 16> memory;
  stack_t stack = {};
  stack.ss_sp = memory.data();
  stack.ss_size = memory.size();
  sigaltstack(&stack, nullptr);
}

}  // namespace

void handle_signals() {
  give_signals_a_stack();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // A shell starts jobs in the background with SIGINT ignored, yet one may be sent on purpose;
  // an ignored SIGHUP is nohup's wish.
  for (const int signal : kAskToEnd)
    if (signal != SIGHUP || has_default(signal)) on(signal, c1mesh_on_request);
  for (const int signal : kKill)
    if (has_default(signal)) on(signal, c1mesh_on_death);  // sanitizers have their own
}

void catch_signals() {
  orderly = true;
}

bool interrupted() {
  return asked_by != 0;
}

int signal_to_the_abandoned() {
  return SIGUSR1;
}

}  // namespace c1mesh::app
