// SPDX-License-Identifier: GPL-3.0-or-later
// The page as text: it holds the result bit for bit, needs nothing else, and no name in the result
// can end the element it stands in. What a browser makes of it: tests/page.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <regex>

#include "c1mesh/write.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

using Json = nlohmann::json;

const std::string kHostile =
    "</script><script>alert(1)</script><!-- <script> {{script}} \" ' & \xff\xe2\x80\xa8 \\u003c";

Result example_result() {
  Result result = example::grid(2, 4, example::cubic_map());
  result.name = "example";
  return result;
}

/// What stands between the tag that ends in `open` and the next `close`.
std::string between(const std::string& text, const std::string& open, const std::string& close) {
  const std::size_t from = text.find(open);
  EXPECT_NE(from, std::string::npos) << open;
  const std::size_t start = from + open.size();
  return text.substr(start, text.find(close, start) - start);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t times = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++times;
  return times;
}

Json data_of(const std::string& page) {
  return Json::parse(between(page, "id=\"result\">", "</script>"));
}

TEST(Html, HoldsTheResultBitForBit) {
  Result result = example_result();
  result.control_points[3] = {0.1 + 0.2, -5e-324};
  result.control_points[4] = {-0.0, std::numeric_limits<double>::max()};
  const std::string page = format_html(result);
  EXPECT_NE(page.find(format_result(result)), std::string::npos);
  const Json data = data_of(page);
  EXPECT_EQ(data.at("name"), "example");
  EXPECT_EQ(data.at("result").at("control_points").at(3).at(0).get<double>(), 0.1 + 0.2);
  EXPECT_EQ(format_html(result), page);
}

TEST(Html, NamesStayText) {
  Result result = example_result();
  const std::string plain = format_html(result);
  result.name = kHostile;
  result.parameters.emplace_back(kHostile, kHostile);
  const std::string page = format_html(result);
  for (const char* mark : {"<script", "</script", "<!--", "<style", "<title", "{{script}}"})
    EXPECT_EQ(count(page, mark), count(plain, mark) + (mark[0] == '{' ? 4 : 0)) << mark;
  EXPECT_EQ(count(between(page, "<title>", "</title>"), "<"), 0u);
  // It comes out as it went in, but for the byte that is no UTF-8.
  std::string expected = kHostile;
  expected.replace(expected.find('\xff'), 1, "\xef\xbf\xbd");
  EXPECT_EQ(data_of(page).at("name"), expected);
  EXPECT_EQ(data_of(page).at("result").at("parameters").at(expected), expected);
}

TEST(Html, NeedsNothingElse) {
  const std::string page = format_html(example_result());
  EXPECT_EQ(count(page, "{{"), 0u);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_FALSE(std::regex_search(page, std::regex("(https?:)?//[a-z]+\\.")));
  EXPECT_FALSE(
      std::regex_search(page, std::regex("<(link|img|script|iframe)[^>]*(src|href)=\"(?!data:)")));
  EXPECT_EQ(convert(example_result(), "x.html"), page);
}

}  // namespace
}  // namespace c1mesh
