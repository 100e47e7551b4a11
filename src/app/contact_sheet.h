// SPDX-License-Identifier: GPL-3.0-or-later
// draw --contact-sheet: many results on one page, or on several.
#pragma once

#include <string>
#include <vector>

#include "app/console.h"
#include "app/status.h"
#include "c1mesh/shape.h"
#include "c1mesh/write.h"

namespace c1mesh::app {

struct SheetArguments {
  std::vector<std::string> inputs;
  std::string output;
  int per_page = 0;  ///< 0: one page
  bool no_verify = false;
  std::size_t max_bytes = ReadOptions().max_bytes;  ///< of a file
  DrawOptions options;
};

/// Does the name say that pixels are wanted?
bool is_png(const std::string& path);

/// Reads, verifies and draws one result after the other. What cannot be read is said, has its cell,
/// and makes the status `input`; the pages are written all the same.
Status draw_sheets(Console& console, const SheetArguments& arguments);

}  // namespace c1mesh::app
