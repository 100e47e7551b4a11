// SPDX-License-Identifier: GPL-3.0-or-later
#include "c1mesh/contact_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <pugixml.hpp>
#include <set>

#include "c1mesh/png.h"
#include "raster/pixels.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

struct Cell {
  double left, top, width, height;
};

class Sheet {
 public:
  explicit Sheet(const std::string& svg) { EXPECT_TRUE(doc_.load_string(svg.c_str())); }
  std::vector<Cell> cells() const {
    std::vector<Cell> out;
    for (const auto& found : doc_.select_nodes("//g[starts-with(@id, 'cell-')]")) {
      const pugi::xml_node rect = found.node().child("rect");
      Cell cell{0, 0, rect.attribute("width").as_double(), rect.attribute("height").as_double()};
      EXPECT_EQ(std::sscanf(found.node().attribute("transform").value(), "translate(%lf %lf)",
                            &cell.left, &cell.top),
                2);
      out.push_back(cell);
    }
    return out;
  }
  std::vector<std::string> words(const std::string& inside) const {
    std::vector<std::string> out;
    for (const auto& found : doc_.select_nodes((inside + "/text").c_str()))
      out.push_back(found.node().text().get());
    return out;
  }
  std::size_t count(const std::string& query) const {
    return doc_.select_nodes(query.c_str()).size();
  }
  double page(int which) const {
    double box[4] = {};
    EXPECT_EQ(std::sscanf(doc_.child("svg").attribute("viewBox").value(), "%lf %lf %lf %lf",
                          &box[0], &box[1], &box[2], &box[3]),
              4);
    return box[which];
  }

 private:
  pugi::xml_document doc_;
};

DrawOptions small_pictures(double width = 1200) {
  DrawOptions options;
  options.width = width;
  options.columns = 0;
  options.parts = {Part::shape};
  options.grid_lines = 5;
  options.show_mesh = false;
  return options;
}

std::string sheet_of(int count, const DrawOptions& options) {
  const Result result = example::grid(2, 3, example::cubic_map());
  ContactSheet sheet(count, options);
  for (int k = 0; k < count; ++k)
    sheet.add(result, "name-" + std::to_string(k), result.metrics, SheetMark::certified);
  return sheet.svg();
}

TEST(ContactSheet, CellsAreInsideThePageAndApart) {
  for (const double width : {300.0, 1200.0, 3000.0})
    for (const int count : {1, 2, 30, 300}) {
      const Sheet sheet(sheet_of(count, small_pictures(width)));
      const std::vector<Cell> cells = sheet.cells();
      ASSERT_EQ(cells.size(), static_cast<std::size_t>(count));
      for (std::size_t k = 0; k < cells.size(); ++k) {
        EXPECT_GE(cells[k].left, 0);
        EXPECT_LE(cells[k].left + cells[k].width, sheet.page(2));
        EXPECT_LE(cells[k].top + cells[k].height, sheet.page(3));
        if (k == 0) continue;
        const bool beside = cells[k].left > cells[k - 1].left + cells[k - 1].width;
        const bool below = cells[k].top > cells[k - 1].top + cells[k - 1].height;
        EXPECT_NE(beside && cells[k].top == cells[k - 1].top,
                  below && cells[k].left == cells[0].left);
      }
      // Letters of 9.5 units at least are 7 pixels at least, and a cell has room for some.
      EXPECT_GT(9.5 * width / sheet.page(2), 7);
      EXPECT_GT(cells[0].width, 90);
    }
}

TEST(ContactSheet, ColumnsCanBeChosen) {
  DrawOptions options = small_pictures();
  options.columns = 4;
  std::set<double> lefts;
  for (const Cell& cell : Sheet(sheet_of(10, options)).cells()) lefts.insert(cell.left);
  EXPECT_EQ(lefts.size(), 4u);
}

TEST(ContactSheet, CellsSayNameFiguresAndMark) {
  Result result = example::grid(2, 3, example::cubic_map());
  result.exceptional_vertices = {0, 2};
  Metrics metrics;
  metrics.mips_bound_max = 12.345;
  const std::string hostile = "<script>alert(1)</script> & \"\x01\xff";
  ContactSheet sheet(4, small_pictures());
  sheet.add(result, "first", metrics, SheetMark::certified);
  sheet.add(result, hostile, metrics, SheetMark::not_certified);
  sheet.add(result, std::string(300, 'w'), metrics, SheetMark::none);
  sheet.add_unreadable("broken", "the file ends in the middle of <something>");
  const std::string svg = sheet.svg();
  const Sheet read(svg);
  const std::vector<std::string> first = read.words("//g[@id='cell-1']");
  EXPECT_EQ(first, (std::vector<std::string>{"first", "2 exceptional, g 12.35", "8 triangles"}));
  EXPECT_EQ(read.count("//g[@id='cell-1']/path[@class='certified']"), 1u);
  EXPECT_EQ(read.count("//g[@id='cell-2']/path[@class='not-certified']"), 1u);
  EXPECT_EQ(read.count("//g[@id='cell-3']/path"), 0u);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(read.words("//g[@id='cell-2']")[0].substr(0, 8), "<script>");
  EXPECT_LT(read.words("//g[@id='cell-3']")[0].size(), 60u);
  EXPECT_EQ(read.count("//g[@id='cell-4']/rect[@class='unreadable']"), 1u);
  const std::vector<std::string> broken = read.words("//g[@id='cell-4']");
  EXPECT_EQ(broken.front(), "cannot be read");
  EXPECT_EQ(broken.back(), "broken");
  EXPECT_EQ(read.words("/svg")[0], "4 results");
  EXPECT_EQ(read.words("/svg")[1], "1 certified, 1 not certified, 1 cannot be read");
  EXPECT_FALSE(png_of(svg).empty());
}

TEST(ContactSheet, ColoursMeanTheSameOnEverySheet) {
  DrawOptions options = small_pictures();
  options.colour = Colour::distortion;
  const auto ticks = [&](const example::Polynomial& map) {
    const Result result = example::square(3, map);
    ContactSheet sheet(1, options);
    sheet.add(result, "a", result.metrics, SheetMark::none);
    return Sheet(sheet.svg()).words("//g[@id='legend']");
  };
  EXPECT_EQ(ticks(example::identity()), ticks(example::cubic_map()));
  EXPECT_EQ(ticks(example::identity()).back(), "1000");
}

TEST(ContactSheet, IsTheSameInPixels) {
  for (const double width : {300.0, 3000.0}) {
    const std::string png = png_of(sheet_of(30, small_pictures(width)));
    EXPECT_EQ(testing_pixels::pixels_of(png).width, width);
    EXPECT_EQ(png, png_of(sheet_of(30, small_pictures(width))));
  }
}

}  // namespace
}  // namespace c1mesh
