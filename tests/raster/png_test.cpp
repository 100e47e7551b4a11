// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/png.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <thread>

#include "raster/pixels.h"

namespace c1mesh {
namespace {

using testing_pixels::Pixels;
using testing_pixels::pixels_of;
using testing_pixels::Rgba;

constexpr Rgba kWhite{255, 255, 255, 255}, kBlack{0, 0, 0, 255}, kRed{255, 0, 0, 255},
    kBlue{0, 0, 255, 255};

std::string svg(const std::string& body, const std::string& size = "width=\"40\" height=\"20\"",
                const std::string& box = "0 0 40 20") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + " viewBox=\"" + box + "\">" + body +
         "</svg>";
}

Pixels painted(const std::string& body) {
  return pixels_of(png_of(svg(body)));
}

TEST(Png, HasTheSizeThatThePictureStates) {
  const std::string png = png_of(svg("<rect x=\"5\" width=\"5\" height=\"100%\" fill=\"#f00\"/>",
                                     "width=\"40\" height=\"20\"", "0 0 20 10"));
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(12, 12), std::string("IHDR\0\0\0\x28\0\0\0\x14", 12));
  const Pixels pixels = pixels_of(png);
  ASSERT_EQ(pixels.width, 40);
  ASSERT_EQ(pixels.height, 20);
  EXPECT_EQ(pixels.at(9, 19), kWhite);
  EXPECT_EQ(pixels.at(10, 0), kRed);  // enlarged twice
  EXPECT_EQ(pixels.at(19, 19), kRed);
  EXPECT_EQ(pixels.at(20, 10), kWhite);
}

TEST(Png, RulesWinOverAttributesAndStyleOverRules) {
  const Pixels pixels = painted(
      "<style>.a{fill:#f00}.in .b{fill:#00f}.b{fill:#f00}rect{fill:#fff}</style>"
      "<rect class=\"a\" width=\"5\" height=\"5\" fill=\"#00f\"/>"
      "<g class=\"in\"><rect class=\"b\" x=\"5\" width=\"5\" height=\"5\"/></g>"
      "<rect class=\"b\" x=\"10\" width=\"5\" height=\"5\"/>"
      "<rect class=\"a\" x=\"15\" width=\"5\" height=\"5\" style=\"fill:#000;stroke:none\"/>"
      "<g fill=\"#00f\"><path d=\"M20,0h5v5h-5Z\"/></g>");
  EXPECT_EQ(pixels.at(2, 2), kRed);
  EXPECT_EQ(pixels.at(7, 2), kBlue);
  EXPECT_EQ(pixels.at(12, 2), kRed);
  EXPECT_EQ(pixels.at(17, 2), kBlack);
  EXPECT_EQ(pixels.at(22, 2), kBlue);  // inherited
}

TEST(Png, FillRulesClipsAndMoves) {
  const std::string twice = "d=\"M1,1H11V11H1Z M3,3H9V9H3Z\"/>";
  EXPECT_EQ(painted("<path " + twice).at(6, 6), kBlack);
  EXPECT_EQ(painted("<path fill-rule=\"evenodd\" " + twice).at(6, 6), kWhite);
  const Pixels pixels = painted(
      "<clipPath id=\"c\"><rect x=\"2\" y=\"2\" width=\"4\" height=\"4\"/></clipPath>"
      "<g clip-path=\"url(#c)\"><rect width=\"100%\" height=\"100%\" fill=\"#f00\"/></g>"
      "<g transform=\"translate(20 10) scale(2)\"><rect width=\"2\" height=\"2\"/></g>"
      "<path transform=\"rotate(-90 30 10)\" d=\"M30,10h8v1h-8Z\"/>");
  EXPECT_EQ(pixels.at(2, 2), kRed);
  EXPECT_EQ(pixels.at(5, 5), kRed);
  EXPECT_EQ(pixels.at(6, 5), kWhite);
  EXPECT_EQ(pixels.at(23, 13), kBlack);
  EXPECT_EQ(pixels.at(24, 13), kWhite);
  EXPECT_EQ(pixels.at(30, 3), kBlack);  // a bar that points up
  EXPECT_EQ(pixels.at(33, 10), kWhite);
}

TEST(Png, CoverageIsAreaOfTheShape) {
  // A circle's ink is its area; a pixel that is half covered is half black.
  EXPECT_NEAR(painted("<circle cx=\"20\" cy=\"10\" r=\"8.3\"/>").ink(),
              std::numbers::pi * 8.3 * 8.3, 0.5);
  const Pixels half = painted("<rect width=\"10.5\" height=\"10\"/>");
  EXPECT_EQ(half.at(9, 5), kBlack);
  EXPECT_NEAR(half.at(10, 5)[0], 128, 2);
  // The area under y(t) = 3 t (1 - t) h over x(t) = w t is w h / 2.
  EXPECT_NEAR(painted("<path d=\"M0,0C10,12 20,12 30,0Z\"/>").ink(), 30 * 12 / 2.0, 0.5);
  // Triangles side by side in one path leave no seam.
  EXPECT_NEAR(painted("<path d=\"M0,0L20,20L0,20ZM0,0L20,0L20,20Z\"/>").ink(), 400, 1e-9);
}

TEST(Png, StrokesHaveTheirWidthDashesAndOpacity) {
  const std::string line = "fill=\"none\" stroke=\"#000\" stroke-width=\"2\" d=\"M5,10H35\"/>";
  const Pixels plain = painted("<path " + line);
  EXPECT_EQ(plain.at(20, 9), kBlack);
  EXPECT_EQ(plain.at(20, 10), kBlack);
  EXPECT_EQ(plain.at(20, 11), kWhite);
  EXPECT_NEAR(plain.ink(), 60, 1e-9);
  EXPECT_NEAR(painted("<path stroke-linecap=\"round\" " + line).ink(), 60 + std::numbers::pi, 0.2);
  EXPECT_NEAR(painted("<path stroke-dasharray=\"5 5\" " + line).ink(), 30, 1e-9);
  EXPECT_NEAR(painted("<path stroke-opacity=\".5\" " + line).ink(), 30, 0.3);
  // A line of length zero with round ends is a dot.
  EXPECT_NEAR(painted("<path stroke-linecap=\"round\" fill=\"none\" stroke=\"#000\" "
                      "stroke-width=\"6\" d=\"M20,10L20,10\"/>")
                  .ink(),
              9 * std::numbers::pi, 0.3);
}

TEST(Png, TextStandsWhereItIsAnchored) {
  const auto columns = [](const Pixels& pixels) {
    int first = pixels.width, last = -1;
    for (int x = 0; x < pixels.width; ++x)
      for (int y = 0; y < pixels.height; ++y)
        if (pixels.at(x, y) != kWhite) {
          first = std::min(first, x);
          last = std::max(last, x);
        }
    return std::pair(first, last);
  };
  const auto text = [&](const std::string& more) {
    return painted("<text x=\"20\" y=\"15\" font-size=\"12\"" + more + ">oo</text>");
  };
  const auto start = columns(text("")), middle = columns(text(" text-anchor=\"middle\"")),
             end = columns(text(" text-anchor=\"end\""));
  EXPECT_GE(start.first, 20);
  EXPECT_LE(end.second, 20);
  EXPECT_NEAR(middle.first + middle.second, 39, 1);
  EXPECT_GT(text(" font-weight=\"bold\"").ink(), 1.2 * text("").ink());
  // Markup in text is text; what the font lacks is drawn as a box.
  EXPECT_GT(painted("<text x=\"2\" y=\"15\" font-size=\"12\">&lt;&amp;</text>").ink(), 10);
  EXPECT_GT(painted("<text x=\"2\" y=\"15\" font-size=\"12\">\xe4\xb8\xad</text>").ink(), 10);
  // A halo is below the letters, not over them.
  const std::string halo = " stroke=\"#fff\" stroke-width=\"3\"";
  EXPECT_LT(text(halo).ink(), 0.5 * text("").ink());
  EXPECT_NEAR(text(halo + " paint-order=\"stroke\"").ink(), text("").ink(), 1e-9);
}

TEST(Png, TransparentWhereNothingIsPainted) {
  const std::string picture = svg("<rect width=\"5\" height=\"5\" fill=\"#f00\"/>");
  const Pixels pixels = pixels_of(png_of(picture, {true}));
  EXPECT_EQ(pixels.at(2, 2), kRed);
  EXPECT_EQ(pixels.at(20, 10)[3], 0);
  EXPECT_EQ(pixels_of(png_of(picture)).at(20, 10), kWhite);
}

// A path long enough to be painted in parts is the same as its rows painted alone.
TEST(Png, LongPathsArePaintedWhole) {
  for (const char* how : {"fill=\"#000\"", "fill=\"none\" stroke=\"#000\" stroke-width=\"1\"",
                          "fill=\"#000\" stroke=\"#000\" stroke-width=\"1\"",
                          "fill=\"#000\" stroke=\"#f00\" stroke-width=\"1\""}) {
    std::string data, body;
    for (int row = 0; row < 100; ++row) {
      std::string squares;
      for (int column = 0; column < 150; ++column)
        squares += fmt::format("M{},{}h2v2h-2Z", 4 * column + 1, 4 * row + 1);
      data += squares;
      body += std::string("<path ") + how + " d=\"" + squares + "\"/>";
    }
    const auto large = [](const std::string& inside) {
      return pixels_of(png_of(svg(inside, "width=\"600\" height=\"400\"", "0 0 600 400")));
    };
    const Pixels whole = large(std::string("<path ") + how + " d=\"" + data + "\"/>");
    const Pixels parts = large(body);
    int apart = 0;
    for (std::size_t k = 0; k < whole.bytes.size(); ++k)
      apart = std::max(apart, std::abs(whole.bytes[k] - parts.bytes[k]));
    EXPECT_EQ(apart, 0) << how;
  }
}

TEST(Png, SamePictureSameBytesInEveryThread) {
  const std::string picture = svg(
      "<text x=\"2\" y=\"15\" font-size=\"12\">Bézier</text><circle cx=\"30\" cy=\"9\" r=\"6\"/>");
  const std::string once = png_of(picture);
  std::string others[2];
  std::thread first([&] { others[0] = png_of(picture); }),
      second([&] { others[1] = png_of(picture); });
  first.join();
  second.join();
  EXPECT_EQ(others[0], once);
  EXPECT_EQ(others[1], once);
}

std::string refusal(const std::string& picture) {
  try {
    png_of(picture);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(Png, RefusesWhatIsTooLargeBeforePainting) {
  for (const char* size : {"width=\"30001\" height=\"2\"", "width=\"2\" height=\"30001\"",
                           "width=\"10001\" height=\"10000\"", "width=\"1e300\" height=\"1e300\""})
    EXPECT_NE(refusal(svg("", size)).find("too large"), std::string::npos) << size;
  EXPECT_NE(refusal(svg("", "width=\"0\" height=\"9\"")), "");
  EXPECT_NE(refusal(svg("", "")), "");
}

// Whatever a picture may gain must be painted, not passed over.
TEST(Png, RefusesWhatItWouldNotPaint) {
  for (const char* body :
       {"<ellipse/>", "<path d=\"M0,0A1,1 0 0 0 2,2\"/>", "<path d=\"M0,0L1\"/>",
        "<path d=\"1,2\"/>", "<rect fill=\"red\"/>", "<rect style=\"filter:blur\"/>",
        "<g transform=\"skewX(3)\"/>", "<style>#a{fill:#000}</style>",
        "<style>a>b{fill:#000}</style>", "<g clip-path=\"url(#none)\"/>", "<text x=\"a\">b</text>",
        "<rect style=\"mix-blend-mode:multiply\"/>"})
    EXPECT_NE(refusal(svg(body)), "") << body;
  EXPECT_NE(refusal("no picture"), "");
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("<svg><g></svg>"), "");
}

}  // namespace
}  // namespace c1mesh
