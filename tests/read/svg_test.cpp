// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "read/reading.h"

namespace c1mesh {
namespace {

std::vector<Drawing> read_content(const std::string& content, const ReadOptions& options = {}) {
  return read_text(svg(content), options);
}

const char* const kTriangle = "<path d='M0 0L1 0L0 1Z'/>";

TEST(Svg, YPointsUpward) {
  const auto drawing = read_content("<path id='p' d='M1 2L3 4L5 7Z'/>").at(0);
  ASSERT_EQ(drawing.curves.size(), 3u);
  EXPECT_EQ(drawing.curves[0].curve.poles, (std::vector<Point>{{1, -2}, {3, -4}}));
  EXPECT_EQ(drawing.curves[2].id, "p:2");
  EXPECT_EQ(drawing.name, "test");
  EXPECT_EQ(drawing.fill_rule, FillRule::nonzero);
}

TEST(Svg, NestedTransformsCompose) {
  const auto drawing =
      read_content(
          "<g transform='translate(10,20) rotate(30)'><path transform='scale(2 -1) skewX(10)' "
          "d='M0 0 L20 0 C30 10 10 20 0 20 Z'/></g>")
          .at(0);
  // By hand: skew, scale, rotate, translate, then y upward.
  const auto map = [](double x, double y) {
    const double sx = 2 * (x + std::tan(M_PI / 18) * y), sy = -y;
    const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
    return Point(c * sx - s * sy + 10, -(s * sx + c * sy + 20));
  };
  const std::vector<Point> expected = {map(20, 0), map(30, 10), map(10, 20), map(0, 20)};
  for (int i = 0; i < 4; ++i)
    EXPECT_LT((drawing.curves[1].curve.poles[i] - expected[i]).norm(), 1e-13);
}

TEST(Svg, EveryFilledElementIsADrawing) {
  const auto drawings = read_content(
      "<rect x='5' y='5' width='30' height='20' rx='4'/><circle id='c/1' cx='60' cy='60' r='20'/>"
      "<ellipse cx='20' cy='80' rx='10' ry='5'/><polygon points='80,5 95,5 90,20'/>");
  ASSERT_EQ(drawings.size(), 4u);
  EXPECT_EQ(drawings[0].name, "test-1");
  EXPECT_EQ(drawings[1].name, "test-c_1");
  EXPECT_EQ(drawings[3].name, "test-4");
  EXPECT_EQ(drawings[0].curves.size(), 8u);
  EXPECT_EQ(drawings[1].curves.size(), 4u);
  EXPECT_EQ(drawings[3].curves.size(), 3u);
  for (const Drawing& drawing : drawings) {
    EXPECT_EQ(drawing.curves.front().curve.start(), drawing.curves.back().curve.end());
    EXPECT_EQ(drawing.notes.size(), drawing.name == "test-4" ? 0u : 1u);
  }
  for (const InputCurve& curve : drawings[1].curves)
    EXPECT_EQ((curve.curve.start() - Point(60, -60)).norm(), 20);
}

TEST(Svg, TogetherMakesOneDrawing) {
  ReadOptions together;
  together.together = true;
  const auto drawings = read_content(std::string(kTriangle) + kTriangle, together);
  ASSERT_EQ(drawings.size(), 1u);
  EXPECT_EQ(drawings[0].name, "test");
  EXPECT_EQ(drawings[0].curves.size(), 6u);
  EXPECT_NE(drawings[0].curves[0].id, drawings[0].curves[3].id);
}

TEST(Svg, TogetherTakesLinesAsFeatures) {
  const std::string lines =
      "<g fill='none' stroke='black'><path id='f' d='M 1 1 L 2 3 Q 3 3 4 1 M 5 5 L 6 6 L 6 5 Z'/>"
      "<path d='M 0 0 L 9 9' stroke='none'/></g>";
  ReadOptions together;
  together.together = true;
  const Drawing drawing = read_content(kTriangle + lines, together).at(0);
  std::vector<bool> features;
  for (const InputCurve& curve : drawing.curves) features.push_back(curve.feature);
  // Open subpaths stay open, closed ones keep their last side; what is not drawn is left out.
  EXPECT_EQ(features, (std::vector<bool>{false, false, false, true, true, true, true, true}));
  EXPECT_EQ(drawing.curves[4].curve.end(), Point(4, -1));
  // One by one only filled elements count.
  EXPECT_EQ(read_content(kTriangle + lines).at(0).curves.size(), 3u);
}

TEST(Svg, RoundedRectWithFullRadiiHasNoLines) {
  const auto drawing = read_content("<rect width='4' height='2' rx='9' ry='9'/>").at(0);
  EXPECT_EQ(drawing.curves.size(), 4u);
  EXPECT_EQ(read_content("<rect width='4' height='2'/>").at(0).curves.size(), 4u);
  EXPECT_EQ(read_content("<rect width='1in' height='96px'/>").at(0).curves[0].curve.end(),
            Point(96, 0));
}

TEST(Svg, FillAndRuleComeFromAttributesStyleAndAncestors) {
  EXPECT_EQ(first_kind(svg("<path fill='none' d='M0 0L1 0L0 1Z'/>")), DefectKind::empty);
  EXPECT_EQ(first_kind(svg("<g style='fill: none ;x:y'>" + std::string(kTriangle) + "</g>")),
            DefectKind::empty);
  EXPECT_EQ(first_kind(svg("<g style='display:none'>" + std::string(kTriangle) + "</g>")),
            DefectKind::empty);
  EXPECT_EQ(first_kind(svg("<g visibility='hidden'>" + std::string(kTriangle) + "</g>")),
            DefectKind::empty);
  // Style wins over the attribute; a child may fill what its parent does not.
  EXPECT_EQ(
      read_content("<g fill='none'><path style='fill:#000' fill='none' d='M0 0L1 0L0 1Z'/></g>")
          .size(),
      1u);
  EXPECT_EQ(
      read_content("<g fill-rule='evenodd'>" + std::string(kTriangle) + "</g>").at(0).fill_rule,
      FillRule::even_odd);
  EXPECT_EQ(read_content("<g fill-rule='evenodd'><path style='fill-rule:nonzero' "
                         "d='M0 0L1 0L0 1Z'/></g>")
                .at(0)
                .fill_rule,
            FillRule::nonzero);
}

TEST(Svg, UseMovesItsTargetAndSymbolsScale) {
  const auto drawings = read_content(
      "<defs><path id='t' d='M0 0L1 0L0 1Z'/>"
      "<symbol id='s' viewBox='0 0 10 10'><path d='M0 0L10 0L0 10Z'/></symbol></defs>"
      "<use href='#t' x='5' y='6' transform='scale(2)'/>"
      "<use xlink:href='#s' width='40' height='20'/>");
  ASSERT_EQ(drawings.size(), 2u);
  EXPECT_EQ(drawings[0].curves[0].curve.end(), Point(12, -12));
  // 40 x 20 for 10 x 10, uniformly: factor 2, centred, so x begins at 10.
  EXPECT_EQ(drawings[1].curves[0].curve.poles, (std::vector<Point>{{10, 0}, {30, 0}}));
}

TEST(Svg, CirclesOfUseAndBombsOfUseAreRefused) {
  EXPECT_EQ(first_kind(svg("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>")),
            DefectKind::malformed);
  EXPECT_EQ(first_kind(svg("<use id='a' href='#a'/>")), DefectKind::malformed);
  EXPECT_EQ(first_kind(svg("<use href='#nowhere'/>")), DefectKind::malformed);
  std::string bomb = "<defs><g id='l0'/>";
  for (int k = 1; k < 40; ++k) {
    const std::string below = "<use href='#l" + std::to_string(k - 1) + "'/>";
    bomb += "<g id='l" + std::to_string(k) + "'>" + below + below + "</g>";
  }
  EXPECT_EQ(first_kind(svg(bomb + "</defs><use href='#l39'/>")), DefectKind::limit);
}

TEST(Svg, DeepNestingIsRefused) {
  std::string deep;
  for (int k = 0; k < 100'000; ++k) deep += "<g>";
  deep += kTriangle;
  for (int k = 0; k < 100'000; ++k) deep += "</g>";
  EXPECT_EQ(first_kind(svg(deep)), DefectKind::limit);
}

TEST(Svg, BrokenFilesAreMalformed) {
  EXPECT_EQ(first_kind("<svg><path d='M0 0L1 0L0 1Z'/>"), DefectKind::malformed);
  EXPECT_EQ(first_kind("<svg><pat"), DefectKind::malformed);
  EXPECT_EQ(first_kind("<html/>"), DefectKind::malformed);
  EXPECT_EQ(first_kind(svg("<path d='M0 0L1 0L0 ?Z'/>")), DefectKind::malformed);
  EXPECT_EQ(first_kind(svg("<path transform='bend(3)' d='M0 0L1 0L0 1Z'/>")),
            DefectKind::malformed);
  EXPECT_EQ(first_kind("<!DOCTYPE svg [<!ENTITY a \"b\">]><svg/>"), DefectKind::unsupported);
  EXPECT_EQ(first_kind(svg("<rect width='50%' height='3'/>")), DefectKind::malformed);
  EXPECT_EQ(refusal(svg("<path id='bad' d='M0 0L1'/>")).at(0).curves,
            std::vector<std::string>{"bad"});
}

TEST(Svg, PlainDoctypeAndNamespacePrefixAreFine) {
  const std::string text =
      "<?xml version='1.0'?><!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'svg11.dtd'>"
      "<svg:svg xmlns:svg='http://www.w3.org/2000/svg'><svg:path d='M0 0L1 0L0 1Z'/></svg:svg>";
  EXPECT_EQ(read_text(text).size(), 1u);
}

TEST(Svg, TextAndImagesAreNotedAndFatalOnlyAlone) {
  const auto drawings = read_content("<text>hello</text>" + std::string(kTriangle));
  ASSERT_EQ(drawings.size(), 1u);
  ASSERT_EQ(drawings[0].notes.size(), 1u);
  EXPECT_EQ(drawings[0].notes[0].kind, DefectKind::note);
  EXPECT_NE(drawings[0].notes[0].message.find("text"), std::string::npos);
  EXPECT_EQ(first_kind(svg("<text>hello</text><image/>")), DefectKind::empty);
  EXPECT_EQ(first_kind(svg("")), DefectKind::empty);
}

TEST(Svg, CurvesKeepTheirDegrees) {
  const auto drawing = read_content("<path d='M0 0L1 0Q2 1 1 2C1 3 0 3 0 2Z'/>").at(0);
  std::vector<int> degrees;
  for (const InputCurve& curve : drawing.curves) degrees.push_back(curve.curve.degree());
  EXPECT_EQ(degrees, (std::vector<int>{1, 2, 3, 1}));
}

}  // namespace
}  // namespace c1mesh
