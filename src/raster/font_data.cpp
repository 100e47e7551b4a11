// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/font_data.h"

// The assembler copies the files: as C++ text they would be some megabytes to compile.
asm(".section .rodata\n"
    ".balign 16\n"
    "c1mesh_font_begin: .incbin \"" C1MESH_FONT
    "\"\n"
    "c1mesh_font_end:\n"
    ".balign 16\n"
    "c1mesh_bold_font_begin: .incbin \"" C1MESH_BOLD_FONT
    "\"\n"
    "c1mesh_bold_font_end:\n"
    ".global c1mesh_font_begin, c1mesh_font_end, c1mesh_bold_font_begin, c1mesh_bold_font_end\n"
    ".text\n");

extern "C" {
extern const unsigned char c1mesh_font_begin[], c1mesh_font_end[];
extern const unsigned char c1mesh_bold_font_begin[], c1mesh_bold_font_end[];
}

namespace c1mesh {

std::span<const unsigned char> font_data(bool bold) {
  return bold ? std::span<const unsigned char>(c1mesh_bold_font_begin, c1mesh_bold_font_end)
              : std::span<const unsigned char>(c1mesh_font_begin, c1mesh_font_end);
}

}  // namespace c1mesh
