// SPDX-License-Identifier: GPL-3.0-or-later
// The OBJ file: by hand for one triangle, on a grid by values of the map. Sharing is counted in
// tests/formats.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "c1mesh/write.h"
#include "result/example_results.h"

namespace c1mesh {
namespace {

TEST(Obj, OfOneTriangleByHand) {
  const Result result =
      example::polynomial_result(3, example::identity(), {{0, 0}, {2, 0}, {0, 2}}, {{0, 1, 2}});
  EXPECT_EQ(format_obj(result, 2),
            "# 2 pieces along each edge; vt: the place in the domain\n"
            "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 0\n"
            "vt 0 0\nvt 1 0\nvt 2 0\nvt 0 1\nvt 1 1\nvt 0 2\n"
            "g region_0\nf 1/1 2/2 4/4\nf 2/2 5/5 4/4\nf 2/2 3/3 5/5\nf 4/4 5/5 6/6\n");
}

TEST(Obj, PointsAreImagesOfTheirTextureCoordinates) {
  const auto map = example::cubic_map();
  for (const int cuts : {1, 3, 8}) {
    std::istringstream text(format_obj(example::grid(2, 4, map), cuts));
    std::vector<Point> points, places;
    std::size_t faces = 0;
    for (std::string line; std::getline(text, line);) {
      std::istringstream words(line);
      std::string key;
      double x, y;
      words >> key;
      faces += key == "f";
      if (key != "v" && key != "vt") continue;
      words >> x >> y;
      (key == "v" ? points : places).emplace_back(x, y);
    }
    EXPECT_EQ(faces, 8u * cuts * cuts);
    // A grid of 2 x 2 squares, each edge cut: (2 cuts + 1)^2 points.
    ASSERT_EQ(points.size(), static_cast<std::size_t>((2 * cuts + 1) * (2 * cuts + 1)));
    ASSERT_EQ(places.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      EXPECT_LT((points[k] - example::evaluate(map, places[k])).norm(), 1e-15);
  }
}

}  // namespace
}  // namespace c1mesh
