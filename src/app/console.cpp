// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/interrupt.h"

namespace c1mesh::app {
namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool is_dumb_terminal() {
  const char* term = std::getenv("TERM");
  return term == nullptr || std::string(term) == "dumb";
}

}  // namespace

std::string printable(const std::string& text) {
  std::string out = text;
  for (char& c : out)
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f) c = '?';
  return out;
}

Console::Console() {
  terminal_ = isatty(STDERR_FILENO) != 0 && !is_dumb_terminal();
  colours_ = terminal_ && !is_set("NO_COLOR");
}

void Console::print(const std::string& text) {
  clear_bar();
  std::fputs((text + "\n").c_str(), stderr);
}

void Console::error(const std::string& text) {
  if (on_error) return on_error(printable(text));
  print(coloured(Tone::bad, "error:") + " " + printable(text));
}

void Console::say(const std::string& text) {
  if (!quiet) print(text);
}

void Console::detail(const std::string& text) {
  if (verbose && !quiet) print(text);
}

std::string Console::coloured(Tone tone, const std::string& text) const {
  constexpr const char* kCodes[] = {"", "32", "33", "31"};
  if (!colours_ || tone == Tone::plain) return text;
  return fmt::format("\033[{}m{}\033[0m", kCodes[static_cast<int>(tone)], text);
}

Progress Console::progress(const std::string& label) {
  return [this, label, stage_before = std::string()](const std::string& stage,
                                                     double fraction) mutable {
    if (terminal_ && !quiet) {
      draw_bar(label, stage, fraction);
    } else if (stage != stage_before) {
      detail(fmt::format("{}: {}", label, stage));
    }
    stage_before = stage;
    return !interrupted();
  };
}

void Console::draw_bar(const std::string& label, const std::string& stage, double fraction) {
  const auto now = Clock::now();
  if (bar_shown_ && now - last_drawn_ < std::chrono::milliseconds(80)) return;
  constexpr int kWidth = 30;
  const double part = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(part * kWidth);
  const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
  std::fputs(fmt::format("\r\033[K[{}] {:3.0f} % {}: {}", bar, 100 * part, printable(label),
                         printable(stage))
                 .c_str(),
             stderr);
  std::fflush(stderr);
  bar_shown_ = true;
  last_drawn_ = now;
}

void Console::clear_bar() {
  if (bar_shown_) std::fputs("\r\033[K", stderr);
  bar_shown_ = false;
}

}  // namespace c1mesh::app
