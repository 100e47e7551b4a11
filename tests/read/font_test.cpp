// SPDX-License-Identifier: GPL-3.0-or-later
// Letters as shapes, against the font's own points and against closed forms.
#include "c1mesh/font.h"

#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_FREETYPE_H

#include <array>
#include <cmath>
#include <fstream>

namespace c1mesh {
namespace {

constexpr const char* kFont = C1MESH_TEST_FONT;
constexpr const char* kCubicFont = C1MESH_TEST_CUBIC_FONT;

// The integral of (x dy - y dx) / 2 along the curve; three Gauss points are exact to degree 5.
double signed_area(const BezierCurve& curve) {
  const auto blossom = [&](double t, int last) {
    std::vector<Point> p(curve.poles.begin(), curve.poles.end());
    for (int level = curve.degree(); level > last; --level)
      for (int i = 0; i < level; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
    return p;
  };
  double area = 0;
  for (const auto& [node, weight] : {std::pair(-std::sqrt(0.6), 5.0 / 9), std::pair(0.0, 8.0 / 9),
                                     std::pair(std::sqrt(0.6), 5.0 / 9)}) {
    const double t = (1 + node) / 2;
    const std::vector<Point> p = blossom(t, 1);
    const Point at = (1 - t) * p[0] + t * p[1], derivative = curve.degree() * (p[1] - p[0]);
    area += weight / 2 * cross(at, derivative) / 2;
  }
  return area;
}

double signed_area(const Drawing& drawing) {
  double area = 0;
  for (const InputCurve& curve : drawing.curves) area += signed_area(curve.curve);
  return area;
}

double signed_area(const Shape& shape, const Loop& loop) {
  double area = 0;
  for (const CurveUse& use : loop)
    area +=
        (use.reversed ? -1 : 1) * signed_area(shape.curves[static_cast<std::size_t>(use.curve)]);
  return area;
}

/// The font's own points, without the reader.
class Face {
 public:
  explicit Face(const char* path = kFont) {
    FT_Init_FreeType(&library_);
    FT_New_Face(library_, path, 0, &face_);
  }
  ~Face() { FT_Done_FreeType(library_); }

  FT_GlyphSlot load(char32_t character) const {
    FT_Load_Glyph(face_, FT_Get_Char_Index(face_, character),
                  FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING);
    return face_->glyph;
  }
  double kerning(char32_t left, char32_t right) const {
    FT_Vector shift;
    FT_Get_Kerning(face_, FT_Get_Char_Index(face_, left), FT_Get_Char_Index(face_, right),
                   FT_KERNING_UNSCALED, &shift);
    return static_cast<double>(shift.x);
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

// By the definition of TrueType outlines: points on the curve, points off it, and the middle of two
// successive ones off it. The segment between a parabola and its chord has 2/3 of the area of the
// triangle (a, c, b) of its control points (Archimedes).
double area_by_archimedes(const FT_Outline& outline) {
  double area = 0;
  for (int contour = 0, first = 0; contour < outline.n_contours; ++contour) {
    const int last = outline.contours[contour];
    std::vector<std::pair<Point, bool>> points;  // with the implied ones; on the curve?
    for (int i = first; i <= last; ++i) {
      const int next = i == last ? first : i + 1;
      const Point p(outline.points[i].x, outline.points[i].y);
      const Point q(outline.points[next].x, outline.points[next].y);
      const bool on = outline.tags[i] & 1, next_on = outline.tags[next] & 1;
      points.emplace_back(p, on);
      if (!on && !next_on) points.emplace_back((p + q) / 2, true);
    }
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [p, on] = points[i];
      const auto& [before, before_on] = points[(i + count - 1) % count];
      const Point& after = points[(i + 1) % count].first;
      if (on && before_on) area += cross(before, p) / 2;
      if (!on) area += cross(before, after) / 2 + 2.0 / 3 * cross(p - before, after - before) / 2;
    }
    first = last + 1;
  }
  return area;
}

// Of outlines of lines and cubics, each of which is three points after the one where it begins:
// with the integrals of the products of cubic Bernstein polynomials and their derivatives.
double area_of_cubics(const FT_Outline& outline) {
  double area = 0;
  for (int contour = 0, first = 0; contour < outline.n_contours; ++contour) {
    const int count = outline.contours[contour] - first + 1;
    const auto at = [&](int i) {
      const FT_Vector& v = outline.points[first + i % count];
      return Point(static_cast<double>(v.x), static_cast<double>(v.y));
    };
    const auto on = [&](int i) { return (outline.tags[first + i % count] & 1) != 0; };
    for (int i = 0; i < count;) {
      EXPECT_TRUE(on(i));
      if (on(i + 1)) {
        area += cross(at(i), at(i + 1)) / 2;
        ++i;
        continue;
      }
      const Point a = at(i), b = at(i + 1), c = at(i + 2), d = at(i + 3);
      area += (6 * cross(a, b) + 3 * cross(a, c) + cross(a, d) + 3 * cross(b, c) + 3 * cross(b, d) +
               6 * cross(c, d)) /
              20;
      i += 3;
    }
    first += count;
  }
  return area;
}

class Letters : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::ifstream(kFont)) GTEST_SKIP() << "no font: install fonts-dejavu-core";
  }
};

TEST_F(Letters, HaveTheAreaOfTheFontsOwnPoints) {
  const Face face;
  for (const char32_t character : std::u32string(U"BgO8&@QéßΩЖ%")) {
    std::string text;  // UTF-8, two bytes at most
    if (character < 0x80)
      text = static_cast<char>(character);
    else
      text = {static_cast<char>(0xc0 | character >> 6), static_cast<char>(0x80 | (character & 63))};
    const std::vector<Drawing> drawings = read_font(kFont, text);
    ASSERT_EQ(drawings.size(), 1u);
    const double expected = area_by_archimedes(face.load(character)->outline);
    EXPECT_NEAR(signed_area(drawings[0]), expected, 1e-9 * std::abs(expected)) << text;
    EXPECT_LT(expected, 0) << text;  // TrueType's outer contours run clockwise
  }
}

TEST(CubicLetters, HaveTheAreaOfTheFontsOwnPointsAndTheirHoles) {
  if (!std::ifstream(kCubicFont)) GTEST_SKIP() << "no font: install fonts-cantarell";
  const Face face(kCubicFont);
  bool cubic = false;
  for (const auto& [text, holes] :
       {std::pair("B", 2u), std::pair("g", 1u), std::pair("S", 0u), std::pair("8", 2u)}) {
    const Drawing drawing = read_font(kCubicFont, text).front();
    const double expected = area_of_cubics(face.load(static_cast<unsigned char>(text[0]))->outline);
    EXPECT_GT(expected, 0) << text;  // CFF's outer contours run counter-clockwise
    EXPECT_NEAR(signed_area(drawing), expected, 1e-9 * expected) << text;
    for (const InputCurve& input : drawing.curves) {
      EXPECT_TRUE(input.curve.degree() == 1 || input.curve.degree() == 3) << input.id;
      cubic |= input.curve.degree() == 3;
      for (const Point& p : input.curve.poles) EXPECT_EQ(p, p.array().round().matrix());
    }
    const Shape shape = make_shape(drawing);
    ASSERT_EQ(shape.regions.size(), 1u) << text;
    EXPECT_EQ(shape.regions[0].holes.size(), holes) << text;
  }
  EXPECT_TRUE(cubic);
}

// Font units are integers; only implied points can be halves. Loops close bit for bit.
TEST_F(Letters, AreExact) {
  bool quadratic = false;
  for (const Drawing& drawing : read_font(kFont, "Sage8&")) {
    EXPECT_EQ(drawing.fill_rule, FillRule::nonzero);
    for (const InputCurve& input : drawing.curves) {
      EXPECT_TRUE(input.curve.degree() == 1 || input.curve.degree() == 2) << input.id;
      quadratic |= input.curve.degree() == 2;
      for (const Point& p : input.curve.poles) {
        EXPECT_EQ(2 * p.x(), std::round(2 * p.x()));
        EXPECT_EQ(2 * p.y(), std::round(2 * p.y()));
      }
      EXPECT_NE(input.curve.start(), input.curve.end()) << input.id;
    }
  }
  EXPECT_TRUE(quadratic);
}

struct Kind {
  const char* text;
  std::size_t regions, holes;
};

TEST_F(Letters, HaveTheHolesThatOneSees) {
  for (const Kind& kind : {Kind{"B", 1, 2}, Kind{"O", 1, 1}, Kind{"8", 1, 2}, Kind{"i", 2, 0},
                           Kind{"C", 1, 0}, Kind{"%", 3, 2}, Kind{"Ä", 3, 1}}) {
    const std::vector<Drawing> drawings = read_font(kFont, kind.text);
    const Shape shape = make_shape(drawings.front());
    EXPECT_EQ(shape.regions.size(), kind.regions) << kind.text;
    std::size_t holes = 0;
    double area = 0;
    for (const Region& region : shape.regions) {
      holes += region.holes.size();
      EXPECT_GT(signed_area(shape, region.outer), 0) << kind.text;
      area += signed_area(shape, region.outer);
      for (const Loop& hole : region.holes) {
        EXPECT_LT(signed_area(shape, hole), 0) << kind.text;
        area += signed_area(shape, hole);
      }
    }
    EXPECT_EQ(holes, kind.holes) << kind.text;
    // By Green, with the inside on the left of every loop.
    EXPECT_NEAR(area, -signed_area(drawings.front()), 1e-9 * area) << kind.text;
  }
}

TEST_F(Letters, StandWhereAdvanceAndKerningPutThem) {
  const Face face;
  const double advance = static_cast<double>(face.load(U'A')->metrics.horiAdvance);
  const double space = static_cast<double>(face.load(U' ')->metrics.horiAdvance);
  const double kerning = face.kerning(U'A', U'V');
  ASSERT_LT(kerning, 0);
  const Drawing alone = read_font(kFont, "V").front();
  for (const auto& [text, shift] :
       {std::pair("AV", advance + kerning),
        std::pair("A V", advance + face.kerning(U'A', U' ') + space + face.kerning(U' ', U'V'))}) {
    const std::vector<Drawing> drawings = read_font(kFont, text);
    ASSERT_EQ(drawings.size(), 2u);
    ASSERT_EQ(drawings[1].curves.size(), alone.curves.size());
    for (std::size_t k = 0; k < alone.curves.size(); ++k)
      for (std::size_t i = 0; i < alone.curves[k].curve.poles.size(); ++i)
        EXPECT_EQ(drawings[1].curves[k].curve.poles[i],
                  alone.curves[k].curve.poles[i] + Point(shift, 0));
  }
}

TEST_F(Letters, HaveDistinctNames) {
  const std::vector<Drawing> drawings = read_font(kFont, "a a/é");
  std::vector<std::string> names;
  for (const Drawing& drawing : drawings) names.push_back(drawing.name);
  EXPECT_EQ(names, (std::vector<std::string>{"DejaVuSans-1-a", "DejaVuSans-3-a",
                                             "DejaVuSans-4-U+002F", "DejaVuSans-5-U+00E9"}));
  EXPECT_EQ(drawings[1].curves[0].id, "3-a:0");
}

TEST_F(Letters, TogetherAreOneShapeUnlessTheyOverlap) {
  ReadOptions together;
  together.together = true;
  const std::vector<Drawing> word = read_font(kFont, "Bo", together);
  ASSERT_EQ(word.size(), 1u);
  EXPECT_EQ(word[0].name, "DejaVuSans");
  EXPECT_EQ(make_shape(word[0]).regions.size(), 2u);
  // A stroke through the letter (U+0338).
  const CheckReport report = check(read_font(kFont, "A\xCC\xB8", together).front());
  EXPECT_FALSE(report.usable());
  bool crossing = false;
  for (const Defect& defect : report.defects) crossing |= defect.kind == DefectKind::crossing;
  EXPECT_TRUE(crossing);
}

std::vector<Defect> refusal_of(const std::string& font, const std::string& text,
                               const ReadOptions& options = {}) {
  try {
    read_font(font, text, options);
  } catch (const InputError& error) {
    return error.defects();
  }
  return {};
}

TEST_F(Letters, WhatCannotBeSetIsRefusedByItsKind) {
  const auto kind = [&](const std::string& text, const ReadOptions& options = {}) {
    const std::vector<Defect> found = refusal_of(kFont, text, options);
    return found.empty() ? DefectKind::note : found.front().kind;
  };
  EXPECT_EQ(kind(""), DefectKind::empty);
  EXPECT_EQ(kind("  "), DefectKind::empty);
  for (const char* bad : {"a\xff", "\x80", "\xC3", "\xC3(", "\xC0\x80", "\xE0\x80\xAF",
                          "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80"})
    EXPECT_EQ(kind(bad), DefectKind::malformed) << bad;
  EXPECT_EQ(kind("a\U00013000b\U00013001"), DefectKind::unsupported);
  EXPECT_EQ(refusal_of(kFont, "a\U00013000b\U00013001").size(), 2u);  // both at once
  ReadOptions few;
  few.max_characters = 3;
  EXPECT_EQ(kind("abc", few), DefectKind::note);
  EXPECT_EQ(kind("abcd", few), DefectKind::limit);
  few.max_curves = 10;
  EXPECT_EQ(kind("abc", few), DefectKind::limit);
}

TEST(Font, WhatIsNoFontIsRefused) {
  EXPECT_THROW(read_font("/nonexistent.ttf", "a"), FileError);
  EXPECT_THROW(read_font(C1MESH_TEST_DATA, "a"), FileError);  // a folder
  const std::vector<Defect> found = refusal_of(C1MESH_TEST_DATA "/nasty/open-loop.json", "a");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, DefectKind::malformed);
}

}  // namespace
}  // namespace c1mesh
