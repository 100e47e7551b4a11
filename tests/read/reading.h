// SPDX-License-Identifier: GPL-3.0-or-later
// Helpers of the reader's tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "c1mesh/shape.h"

namespace c1mesh {

inline std::vector<Drawing> read_text(const std::string& text, const ReadOptions& options = {}) {
  return read_drawings_from(text, "test", options);
}

/// The defects that reading `text` throws; none if it is read.
inline std::vector<Defect> refusal(const std::string& text, const ReadOptions& options = {}) {
  try {
    read_text(text, options);
  } catch (const InputError& error) {
    return error.defects();
  }
  return {};
}

inline DefectKind first_kind(const std::string& text, const ReadOptions& options = {}) {
  const std::vector<Defect> found = refusal(text, options);
  EXPECT_FALSE(found.empty()) << text;
  return found.empty() ? DefectKind::note : found.front().kind;
}

/// An SVG drawing with this content.
inline std::string svg(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\">" +
         content + "</svg>";
}

}  // namespace c1mesh
