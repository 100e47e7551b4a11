// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "base/hostile_text.h"
#include "base/read_blocks.h"
#include "c1mesh/shape.h"
#include "read/formats.h"

namespace c1mesh {
namespace detail {

void refuse(DefectKind kind, const std::string& message, const std::string& remedy,
            std::vector<std::string> curves) {
  constexpr std::size_t kMostBytes = 600;  // messages quote the input, which may say anything
  Defect defect;
  defect.kind = kind;
  defect.curves = std::move(curves);
  defect.message = clipped(message, kMostBytes);
  defect.remedy = remedy;
  throw InputError({defect});
}

}  // namespace detail

namespace {

using detail::refuse;

[[noreturn]] void refuse_size(std::size_t max_bytes) {
  refuse(DefectKind::limit, fmt::format("the input is larger than {} bytes", max_bytes),
         "split the drawing or raise the limit (--max-bytes)");
}

std::string read_all(std::istream& in, std::size_t max_bytes) {
  std::optional<std::string> text = read_at_most(in, max_bytes);
  if (!text) refuse_size(max_bytes);
  return std::move(*text);
}

enum class Format { json, svg, unknown };

Format format_of(const std::string& text) {
  // UTF-16 marks: JSON is UTF-8 by definition, so this can only be XML.
  if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0)
    return Format::svg;
  const std::size_t mark = text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  const std::size_t first = text.find_first_not_of(" \t\r\n", mark);
  if (first == std::string::npos) return Format::unknown;
  if (text[first] == '<') return Format::svg;
  return text[first] == '[' || text[first] == '{' ? Format::json : Format::unknown;
}

}  // namespace

std::string read_bytes(const std::string& path, std::size_t max_bytes) {
  if (path == "-") return read_all(std::cin, max_bytes);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw FileError(path + ": is a directory");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be opened: " + std::strerror(errno));
  std::string text = read_all(in, max_bytes);
  if (in.bad()) throw FileError(path + ": cannot be read");
  return text;
}

std::vector<Drawing> read_drawings_from(const std::string& text, const std::string& name,
                                        const ReadOptions& options) {
  if (text.size() > options.max_bytes) refuse_size(options.max_bytes);
  switch (format_of(text)) {
    case Format::json:
      return {detail::read_json(text, name, options)};
    case Format::svg:
      return detail::read_svg(text, name, options);
    case Format::unknown:
      break;
  }
  refuse(DefectKind::malformed,
         text.empty() ? "the input is empty" : "the input is neither JSON nor SVG",
         "give a JSON list of Bezier curves or an SVG drawing");
}

std::vector<Drawing> read_drawings(const std::string& path, const ReadOptions& options) {
  const std::string name = path == "-" ? "stdin" : std::filesystem::path(path).stem().string();
  return read_drawings_from(read_bytes(path, options.max_bytes), name, options);
}

}  // namespace c1mesh
