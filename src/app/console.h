// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says to people: standard error, nothing else.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "c1mesh/error.h"
#include "c1mesh/progress.h"

namespace c1mesh::app {

enum class Tone { plain, good, warning, bad };

class Console {
 public:
  /// Colours and the progress bar appear only when standard error is a terminal that can; NO_COLOR
  /// (any value but empty) takes the colours away.
  Console();

  bool quiet = false;    ///< errors only
  bool verbose = false;  ///< stages and every note too
  /// If set, errors go here instead of standard error.
  std::function<void(const std::string&)> on_error;

  void error(const std::string& text);
  void say(const std::string& text);     ///< unless quiet
  void detail(const std::string& text);  ///< only if verbose
  std::string coloured(Tone tone, const std::string& text) const;

  /// A callback that shows a bar with the stage's name (and, if verbose, a line per stage where
  /// there is no terminal) and that returns false once a signal asked the program to stop.
  Progress progress(const std::string& label);
  void clear_bar();

 private:
  using Clock = std::chrono::steady_clock;

  void print(const std::string& text);
  void draw_bar(const std::string& label, const std::string& stage, double fraction);

  bool terminal_ = false, colours_ = false, bar_shown_ = false;
  Clock::time_point last_drawn_{};
};

/// The text with control characters replaced: names and ids come from files.
std::string printable(const std::string& text);

}  // namespace c1mesh::app
