// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <memory>
#include <new>
#include <stdexcept>

#include "base/c_callback.h"
#include "raster/font_data.h"

namespace c1mesh {
namespace {

// Font units as they are: no hinting, so that letters have one form at every size.
constexpr FT_Int32 kLoad = FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP;

struct Release {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};

struct Sink {
  std::vector<GlyphStep>* steps;
  double unit, x;
  Point at = Point::Zero();
  Point place(const FT_Vector* v) const {
    return {x + unit * static_cast<double>(v->x), unit * static_cast<double>(v->y)};
  }
};

template <class Work>
int guarded(const Work& work) {
  return called_back(work, FT_Err_Out_Of_Memory);
}

int on_straight(char kind, const FT_Vector* to, void* data) {
  return guarded([&] {
    Sink& sink = *static_cast<Sink*>(data);
    sink.at = sink.place(to);
    sink.steps->push_back({kind, sink.at, sink.at, sink.at});
  });
}
int on_move(const FT_Vector* to, void* data) {
  return on_straight('m', to, data);
}
int on_line(const FT_Vector* to, void* data) {
  return on_straight('l', to, data);
}
int on_cubic(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* data) {
  return guarded([&] {
    Sink& sink = *static_cast<Sink*>(data);
    sink.at = sink.place(to);
    sink.steps->push_back({'c', sink.place(a), sink.place(b), sink.at});
  });
}
int on_conic(const FT_Vector* control, const FT_Vector* to, void* data) {
  return guarded([&] {
    Sink& sink = *static_cast<Sink*>(data);
    const Point middle = sink.place(control), end = sink.place(to);
    const Point first = sink.at + (middle - sink.at) * (2.0 / 3);
    const Point second = end + (middle - end) * (2.0 / 3);
    sink.at = end;
    sink.steps->push_back({'c', first, second, end});
  });
}

class Font {
 public:
  explicit Font(bool bold) {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();
    library_.reset(library);
    const auto data = font_data(bold);
    FT_Face face = nullptr;
    if (FT_New_Memory_Face(library, data.data(), static_cast<FT_Long>(data.size()), 0, &face) != 0)
      throw std::runtime_error("the font for pictures cannot be read");
    face_.reset(face);
  }

  /// Visits the glyphs with the place, in ems, where each starts; returns where the line ends.
  template <class Visit>
  double walk(std::string_view text, const Visit& visit) const {
    double x = 0;
    FT_UInt before = 0;
    for (const char32_t character : characters_of(text)) {
      const FT_UInt glyph = FT_Get_Char_Index(face_.get(), character);
      FT_Vector kerning = {0, 0};
      if (before && FT_Get_Kerning(face_.get(), before, glyph, FT_KERNING_UNSCALED, &kerning) == 0)
        x += unit() * static_cast<double>(kerning.x);
      before = glyph;
      if (FT_Load_Glyph(face_.get(), glyph, kLoad) != 0) continue;
      visit(face_->glyph, x);
      x += unit() * static_cast<double>(face_->glyph->metrics.horiAdvance);
    }
    return x;
  }
  double unit() const { return 1.0 / face_->units_per_EM; }

 private:
  std::unique_ptr<std::remove_pointer_t<FT_Library>, Release> library_;
  std::unique_ptr<std::remove_pointer_t<FT_Face>, Release> face_;
};

// FreeType's faces hold the glyph loaded last, so every thread has its own.
const Font& font(bool bold) {
  thread_local const Font fonts[2] = {Font(false), Font(true)};
  return fonts[bold ? 1 : 0];
}

}  // namespace

std::vector<char32_t> characters_of(std::string_view text) {
  constexpr char32_t kReplacement = 0xFFFD;
  std::vector<char32_t> out;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const int more = byte < 0x80       ? 0
                     : byte >> 5 == 6  ? 1
                     : byte >> 4 == 14 ? 2
                     : byte >> 3 == 30 ? 3
                                       : -1;
    char32_t value = more <= 0 ? byte : byte & (0x3Fu >> more);
    std::size_t used = 1;
    for (; more > 0 && used <= static_cast<std::size_t>(more) && i + used < text.size(); ++used) {
      const auto next = static_cast<unsigned char>(text[i + used]);
      if (next >> 6 != 2) break;
      value = value << 6 | (next & 0x3F);
    }
    const bool whole = more >= 0 && used == static_cast<std::size_t>(more) + 1;
    out.push_back(whole ? value : kReplacement);
    i += used;
  }
  return out;
}

double text_width(std::string_view text, bool bold) {
  return font(bold).walk(text, [](FT_GlyphSlot, double) {});
}

std::string text_within(const std::string& text, double width, bool bold) {
  constexpr std::size_t kLongest = 2000;  // bytes; no picture has room for more
  if (text.size() <= kLongest && text_width(text, bold) <= width) return text;
  std::string out = text.substr(0, kLongest);
  const auto continues = [&] { return (static_cast<unsigned char>(out.back()) & 0xC0) == 0x80; };
  while (!out.empty() && text_width(out + "…", bold) > width) {
    while (out.size() > 1 && continues()) out.pop_back();
    out.pop_back();
  }
  return out + "…";
}

std::vector<GlyphStep> text_outline(std::string_view text, bool bold) {
  const Font& face = font(bold);
  std::vector<GlyphStep> steps;
  const FT_Outline_Funcs draw = {on_move, on_line, on_conic, on_cubic, 0, 0};
  face.walk(text, [&](FT_GlyphSlot glyph, double x) {
    Sink sink{&steps, face.unit(), x};
    if (FT_Outline_Decompose(&glyph->outline, &draw, &sink) == FT_Err_Out_Of_Memory)
      throw std::bad_alloc();
  });
  return steps;
}

}  // namespace c1mesh
