// SPDX-License-Identifier: GPL-3.0-or-later
// Glyph outlines by FreeType, exactly as the font has them.
#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "base/c_callback.h"
#include "c1mesh/font.h"
#include "read/formats.h"
#include "read/outline.h"
#include "read/scanner.h"
#include "read/utf8.h"

namespace c1mesh {
namespace {

using detail::Pen;
using detail::refuse;

// Neither scaling nor hinting moves a point: coordinates stay the font's integers.
constexpr FT_Int32 kLoadAsIs = FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP;

// Between two control points of a TrueType outline the middle is implied. FreeType halves integers;
// it is told to double them first, so that the half is exact.
constexpr int kDoubled = 1;

Point point_of(const FT_Vector* v) {
  return {std::ldexp(static_cast<double>(v->x), -kDoubled),
          std::ldexp(static_cast<double>(v->y), -kDoubled)};
}

template <class Draw>
int guarded_draw(const Draw& draw) {
  return called_back(draw, FT_Err_Out_Of_Memory);
}

// A closing line of length zero is FreeType's, not the font's.
int on_move(const FT_Vector* to, void* pen) {
  return guarded_draw([&] { static_cast<Pen*>(pen)->move_to(point_of(to)); });
}
int on_line(const FT_Vector* to, void* pen) {
  return guarded_draw([&] {
    if (static_cast<Pen*>(pen)->at() != point_of(to)) static_cast<Pen*>(pen)->line_to(point_of(to));
  });
}
int on_conic(const FT_Vector* control, const FT_Vector* to, void* pen) {
  return guarded_draw([&] { static_cast<Pen*>(pen)->curve_to({point_of(control), point_of(to)}); });
}
int on_cubic(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* pen) {
  return guarded_draw([&] {
    static_cast<Pen*>(pen)->curve_to({point_of(first), point_of(second), point_of(to)});
  });
}

std::string letter_name(char32_t character) {
  const bool plain = (character >= 'a' && character <= 'z') ||
                     (character >= 'A' && character <= 'Z') ||
                     (character >= '0' && character <= '9');
  if (plain) return std::string(1, static_cast<char>(character));
  return fmt::format("U+{:04X}", static_cast<std::uint32_t>(character));
}

class Font {
 public:
  explicit Font(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw FileError(path + ": is a directory");
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();
    library_.reset(library);
    FT_Face face = nullptr;
    const FT_Error error = FT_New_Face(library, path.c_str(), 0, &face);
    if (error == FT_Err_Cannot_Open_Resource || error == FT_Err_Cannot_Open_Stream)
      throw FileError(path + ": cannot be opened");
    if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
    if (error != 0)
      refuse(DefectKind::malformed, "the file is no font that can be read",
             "give a TrueType, OpenType or Type 1 font");
    face_.reset(face);
    if (!FT_IS_SCALABLE(face))
      refuse(DefectKind::unsupported, "the font has bitmaps, no outlines", "give a scalable font");
    if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) != 0)
      refuse(DefectKind::unsupported, "the font does not say which glyph is which character",
             "give a font with a Unicode character map");
  }

  FT_UInt glyph_of(char32_t character) const { return FT_Get_Char_Index(face_.get(), character); }

  /// In font units; 0 without a kerning table.
  double kerning(FT_UInt left, FT_UInt right) const {
    FT_Vector shift = {0, 0};
    if (FT_Get_Kerning(face_.get(), left, right, FT_KERNING_UNSCALED, &shift) != 0) return 0;
    return static_cast<double>(shift.x);
  }

  /// Loads the glyph: outline_of and advance are of this one. False: its data are damaged.
  bool load(FT_UInt glyph) const {
    return FT_Load_Glyph(face_.get(), glyph, kLoadAsIs) == 0 &&
           face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE;
  }
  double advance() const { return static_cast<double>(face_->glyph->metrics.horiAdvance); }
  bool outline(detail::Outline& out) const {
    const FT_Outline_Funcs draw = {on_move, on_line, on_conic, on_cubic, kDoubled, 0};
    Pen pen;
    if (FT_Outline_Decompose(&face_->glyph->outline, &draw, &pen) != 0) return false;
    out = pen.finish();
    return true;
  }

 private:
  struct Release {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
  };
  std::unique_ptr<std::remove_pointer_t<FT_Library>, Release> library_;
  std::unique_ptr<std::remove_pointer_t<FT_Face>, Release> face_;
};

std::vector<char32_t> characters_of(const std::string& text, const ReadOptions& options) {
  std::vector<char32_t> characters;
  try {
    characters = detail::decode_utf8(text);
  } catch (const detail::SyntaxError& error) {
    refuse(DefectKind::malformed, fmt::format("{} (byte {})", error.what(), error.position + 1),
           "give the text in UTF-8");
  }
  if (characters.size() > options.max_characters)
    refuse(DefectKind::limit,
           fmt::format("the text is longer than {} characters", options.max_characters),
           "split it, or raise the limit (--max-characters)");
  return characters;
}

// All that are missing at once.
std::vector<FT_UInt> glyphs_of(const Font& font, const std::vector<char32_t>& characters) {
  std::vector<FT_UInt> glyphs;
  std::vector<Defect> missing;
  for (std::size_t k = 0; k < characters.size(); ++k) {
    glyphs.push_back(font.glyph_of(characters[k]));
    if (glyphs.back() != 0) continue;
    Defect defect;
    defect.kind = DefectKind::unsupported;
    defect.message =
        fmt::format("the font has no glyph for character {}, {}", k + 1,
                    fmt::format("U+{:04X}", static_cast<std::uint32_t>(characters[k])));
    defect.remedy = "give a font that has it";
    missing.push_back(std::move(defect));
  }
  if (!missing.empty()) throw InputError(std::move(missing));
  return glyphs;
}

// The curves of one character, shifted to its place. Ids are LETTER's name and the curve's number.
Drawing placed(const detail::Outline& outline, const std::string& name, double x) {
  Drawing drawing;
  drawing.name = name;
  drawing.fill_rule = FillRule::nonzero;
  for (const auto& subpath : outline.subpaths)
    for (BezierCurve curve : subpath) {
      for (Point& p : curve.poles) p.x() += x;
      drawing.curves.push_back(
          {fmt::format("{}:{}", name, drawing.curves.size()), std::move(curve)});
    }
  return drawing;
}

std::vector<Drawing> set_in_line(const Font& font, const std::vector<char32_t>& characters,
                                 const ReadOptions& options) {
  const std::vector<FT_UInt> glyphs = glyphs_of(font, characters);
  std::vector<Drawing> drawings;
  std::size_t curves = 0;
  double x = 0;
  for (std::size_t k = 0; k < glyphs.size(); ++k) {
    const std::string name = fmt::format("{}-{}", k + 1, letter_name(characters[k]));
    detail::Outline outline;
    if (!font.load(glyphs[k]) || !font.outline(outline))
      refuse(DefectKind::malformed, "the glyph cannot be read", "give another font", {name});
    if (k > 0) x += font.kerning(glyphs[k - 1], glyphs[k]);
    if (!outline.subpaths.empty()) drawings.push_back(placed(outline, name, x));
    x += font.advance();
    for (const auto& subpath : outline.subpaths) curves += subpath.size();
    if (curves > options.max_curves)
      refuse(DefectKind::limit, fmt::format("more than {} curves", options.max_curves),
             "split the text, or raise the limit (--max-curves)");
  }
  if (drawings.empty())
    refuse(DefectKind::empty, "the text has no outline", "give a text with visible letters");
  return drawings;
}

}  // namespace

std::vector<Drawing> read_font(const std::string& path, const std::string& text,
                               const ReadOptions& options) {
  const std::vector<char32_t> characters = characters_of(text, options);
  std::vector<Drawing> drawings = set_in_line(Font(path), characters, options);
  const std::string name = std::filesystem::path(path).stem().string();
  if (!options.together) {
    for (Drawing& drawing : drawings) drawing.name = name + "-" + drawing.name;
    return drawings;
  }
  Drawing all;
  all.name = name;
  all.fill_rule = FillRule::nonzero;
  for (Drawing& drawing : drawings)
    for (InputCurve& curve : drawing.curves) all.curves.push_back(std::move(curve));
  return {std::move(all)};
}

}  // namespace c1mesh
