// SPDX-License-Identifier: GPL-3.0-or-later
// The lexical grammar that path data, point lists, transforms and lengths share.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace c1mesh::detail {

/// Attribute text that does not follow its grammar; `position` counts bytes from 0.
struct SyntaxError : std::runtime_error {
  SyntaxError(const std::string& what, std::size_t at) : std::runtime_error(what), position(at) {}
  std::size_t position;
};

/// Reads tokens of SVG attribute text from left to right.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() const { return position_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[position_]; }
  std::size_t position() const { return position_; }
  void advance() { ++position_; }
  void skip_space();
  /// Space, then at most one comma, then space.
  void skip_comma();
  /// Is the next character one a number can begin with?
  bool at_number() const;
  /// The next number, correctly rounded (as strtod reads it). Throws SyntaxError if there is none
  /// or if it overflows.
  double number();
  /// An arc flag: one character, '0' or '1', that nothing need separate from what follows.
  bool flag();
  /// The letters from here on.
  std::string_view word();
  [[noreturn]] void fail(const std::string& what) const;

 private:
  bool digit_at(std::size_t i) const;
  std::size_t number_end() const;

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace c1mesh::detail
