// SPDX-License-Identifier: GPL-3.0-or-later
// verify, draw and convert on a result made by hand: the identity map of a square.
#include "c1mesh/verify.h"

#include <gtest/gtest.h>

#include "c1mesh/result.h"
#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

constexpr const char* kSquare =
    R"([{"curve_id":0,"type":"BezierCurve","degree":1,"poles":[[0,0],[3,0]]},
        {"curve_id":1,"type":"BezierCurve","degree":1,"poles":[[3,0],[3,3]]},
        {"curve_id":2,"type":"BezierCurve","degree":1,"poles":[[3,3],[0,3]]},
        {"curve_id":3,"type":"BezierCurve","degree":1,"poles":[[0,3],[0,0]]}])";

// Side 3 and degree 3 put every control point on an integer; control point (x, y) has id 4 y + x.
Result identity_of_square() {
  Result result;
  result.name = "square";
  result.domain_vertices = {Point(0, 0), Point(3, 0), Point(3, 3), Point(0, 3)};
  result.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (int y = 0; y <= 3; ++y)
    for (int x = 0; x <= 3; ++x) result.control_points.emplace_back(x, y);
  std::vector<int> lower, upper;
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i + j <= 3; ++i) {
      lower.push_back(4 * j + i + j);    // (0,0) + i (1,0) + j (1,1)
      upper.push_back(4 * (i + j) + i);  // (0,0) + i (1,1) + j (0,1)
    }
  result.triangle_control_points = {lower, upper};
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    result.curves.push_back({{result.domain_vertices[k], result.domain_vertices[next]}});
    result.boundary_edges.push_back({k, next, k, 0, 1});
    result.boundary_vertices.push_back({k, true});
  }
  result.metrics = verify(result).metrics;
  return result;
}

TEST(VerifyCommand, CertifiesTheIdentityOfASquare) {
  const Folder folder;
  folder.write("square.c1.json", format_result(identity_of_square()));
  folder.write("square.json", kSquare);
  const Ran ran = folder.run("verify square.c1.json --input square.json");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
}

TEST(VerifyCommand, RefusesAnotherInput) {
  const Folder folder;
  folder.write("square.c1.json", format_result(identity_of_square()));
  std::string moved = kSquare;
  for (std::size_t at = moved.find("[3,3]"); at != std::string::npos; at = moved.find("[3,3]"))
    moved.replace(at, 5, "[3,4]");
  folder.write("moved.json", moved);
  EXPECT_EQ(folder.run("verify square.c1.json --input moved.json").status, 4);
}

// It is read once: standard input can be no more often.
TEST(VerifyCommand, ComparesSeveralResultsWithOneInput) {
  const Folder folder;
  for (const char* name : {"one.c1.json", "two.c1.json"})
    folder.write(name, format_result(identity_of_square()));
  folder.write("square.json", kSquare);
  const std::string two = "verify one.c1.json two.c1.json --input ";
  EXPECT_EQ(folder.run(two + "square.json").status, 0);
  const Ran piped = folder.run(two + "- < square.json");
  EXPECT_EQ(piped.status, 0) << piped.err;
}

// The worst status counts: an unreadable file is worse than one that is not certified.
TEST(VerifyCommand, TellsInvalidFromUnreadable) {
  const Folder folder;
  Result bent = identity_of_square();
  bent.control_points[0] += Point(0.25, 0);
  folder.write("good.c1.json", format_result(identity_of_square()));
  folder.write("bent.c1.json", format_result(bent));
  folder.write("cut.c1.json", format_result(bent).substr(0, 200));
  EXPECT_EQ(folder.run("verify good.c1.json").status, 0);
  EXPECT_EQ(folder.run("verify good.c1.json bent.c1.json").status, 4);
  EXPECT_EQ(folder.run("verify bent.c1.json cut.c1.json good.c1.json").status, 3);
}

TEST(DrawCommand, WritesSvgToFileAndStandardOutputAlike) {
  const Folder folder;
  folder.write("square.c1.json", format_result(identity_of_square()));
  ASSERT_EQ(folder.run("draw square.c1.json -o square.svg").status, 0);
  const Ran ran = folder.run("draw square.c1.json -o -");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, folder.read("square.svg"));
  EXPECT_NE(ran.out.find("<svg"), std::string::npos);
}

TEST(ConvertCommand, ChoosesTheFormatByExtension) {
  const Folder folder;
  folder.write("square.c1.json", format_result(identity_of_square()));
  ASSERT_EQ(folder.run("convert square.c1.json -o square.vtu").status, 0);
  EXPECT_NE(folder.read("square.vtu").find("<VTKFile"), std::string::npos);
  const Ran ran = folder.run("convert square.c1.json -o square.doc");
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"square.c1.json", "square.vtu"}));
}

}  // namespace
}  // namespace c1mesh
