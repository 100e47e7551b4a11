// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/scanner.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "base/float_traps.h"

namespace c1mesh::detail {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

}  // namespace

void Scanner::skip_space() {
  while (!at_end() && is_space(text_[position_])) ++position_;
}

void Scanner::skip_comma() {
  skip_space();
  if (peek() == ',') ++position_;
  skip_space();
}

bool Scanner::digit_at(std::size_t i) const {
  return i < text_.size() && text_[i] >= '0' && text_[i] <= '9';
}

bool Scanner::at_number() const {
  const char c = peek();
  return digit_at(position_) || c == '.' || c == '-' || c == '+';
}

// Where the longest number from here ends: sign? digits? ('.' digits?)? (e sign? digits)?, at least
// one digit before the exponent. An 'e' that no digits follow is not part of it ("2em").
std::size_t Scanner::number_end() const {
  std::size_t i = position_;
  if (i < text_.size() && (text_[i] == '-' || text_[i] == '+')) ++i;
  std::size_t digits = 0;
  for (; digit_at(i); ++i) ++digits;
  if (i < text_.size() && text_[i] == '.')
    for (++i; digit_at(i); ++i) ++digits;
  if (digits == 0) return position_;
  if (i < text_.size() && (text_[i] == 'e' || text_[i] == 'E')) {
    std::size_t j = i + 1;
    if (j < text_.size() && (text_[j] == '-' || text_[j] == '+')) ++j;
    if (digit_at(j)) {
      for (i = j; digit_at(i);) ++i;
    }
  }
  return i;
}

double Scanner::number() {
  const std::size_t end = number_end();
  if (end == position_) fail("expected a number");
  // from_chars reads no leading plus.
  const char* first = text_.data() + position_ + (peek() == '+' ? 1 : 0);
  const char* last = text_.data() + end;
  double value = 0;
  if (std::from_chars(first, last, value).ec == std::errc::result_out_of_range) {
    // Underflow is zero or a subnormal, which is fine; overflow is not.
    const FloatTrapsOff overflow;
    value = std::strtod(std::string(first, last).c_str(), nullptr);
    if (std::isinf(value)) fail("number out of range");
  }
  position_ = end;
  return value;
}

bool Scanner::flag() {
  const char c = peek();
  if (c != '0' && c != '1') fail("expected an arc flag, 0 or 1");
  ++position_;
  return c == '1';
}

std::string_view Scanner::word() {
  const std::size_t start = position_;
  while (!at_end() && ((peek() >= 'a' && peek() <= 'z') || (peek() >= 'A' && peek() <= 'Z')))
    ++position_;
  return text_.substr(start, position_ - start);
}

void Scanner::fail(const std::string& what) const {
  if (at_end()) throw SyntaxError(what + " but the text ends", position_);
  const unsigned char c = static_cast<unsigned char>(peek());
  const std::string found =
      c > 32 && c < 127 ? fmt::format("'{}'", peek()) : fmt::format("byte {}", c);
  throw SyntaxError(fmt::format("{} but found {}", what, found), position_);
}

}  // namespace c1mesh::detail
