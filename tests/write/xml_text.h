// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of XML files read.
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh::testing_xml {

inline pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document doc;
  EXPECT_TRUE(doc.load_string(text.c_str()));
  return doc;
}

/// All points of a path's data, pairs of numbers whatever the commands are.
inline std::vector<Point> path_points(std::string data) {
  for (char& c : data)
    if (c == ',' || std::isalpha(static_cast<unsigned char>(c))) c = ' ';
  std::istringstream in(data);
  std::vector<Point> out;
  for (double x, y; in >> x >> y;) out.emplace_back(x, y);
  return out;
}

}  // namespace c1mesh::testing_xml
