// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interrupt.h"

#include <csignal>

namespace c1mesh::app {
namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void c1mesh_on_signal(int) {
  asked_to_stop = 1;
}

}  // namespace

void catch_signals() {
  struct sigaction action = {};
  action.sa_handler = c1mesh_on_signal;
  // The default action returns after the first signal, so that a second one always ends the
  // program.
  // No SA_RESTART: a signal also ends a read from a terminal.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return asked_to_stop != 0;
}

}  // namespace c1mesh::app
