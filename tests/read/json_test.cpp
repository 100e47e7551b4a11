// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/reading.h"

namespace c1mesh {
namespace {

const char* const kLine =
    R"([{"curve_id":0,"type":"BezierCurve","degree":1,"poles":[[0,0],[1,0]]}])";

TEST(Json, ReadsEveryBitOfACoordinate) {
  const auto drawing =
      read_text(R"([{"poles":[[0.1,-1e-320],[1e300,123456789.123456789],[3,4]]}])").at(0);
  ASSERT_EQ(drawing.curves.size(), 1u);
  EXPECT_EQ(drawing.curves[0].curve.poles,
            (std::vector<Point>{{0.1, -1e-320}, {1e300, 123456789.123456789}, {3, 4}}));
  EXPECT_EQ(drawing.fill_rule, FillRule::even_odd);
  EXPECT_EQ(drawing.name, "test");
}

TEST(Json, IdsAreNumbersOrStringsAndExtraKeysAreIgnored) {
  const auto drawing = read_text(R"({"name":"x","curves":[
    {"curve_id":17,"colour":"red","poles":[[0,0],[1,0]]},
    {"curve_id":"left","degree":1,"poles":[[1,0],[0,1]]},
    {"poles":[[0,1],[0,0]]}]})")
                           .at(0);
  ASSERT_EQ(drawing.curves.size(), 3u);
  EXPECT_EQ(drawing.curves[0].id, "17");
  EXPECT_EQ(drawing.curves[1].id, "left");
  EXPECT_EQ(drawing.curves[2].id, "2");
}

TEST(Json, ByteOrderMarkAndCarriageReturnsAreTolerated) {
  std::string text = "\xEF\xBB\xBF \r\n";
  text += kLine;
  EXPECT_EQ(read_text(text + "\r\n").at(0).curves.size(), 1u);
}

TEST(Json, EveryBadCurveIsNamed) {
  const auto found = refusal(R"([
    {"curve_id":"a","poles":[[0,null],[1,0]]},
    {"curve_id":"b","poles":[[0],[1,0]]},
    {"curve_id":"c","poles":[]},
    {"curve_id":"d","poles":[["0",0],[1,0]]},
    {"curve_id":"e","degree":3,"poles":[[0,0],[1,0]]},
    {"curve_id":"f","type":"RationalBezier","poles":[[0,0],[1,0]]},
    {"curve_id":"g","poles":[[0,0],[1,0]],"weights":[1,2]},
    {"curve_id":"h"}, 7,
    {"curve_id":"good","poles":[[0,0],[1,0]]}])");
  ASSERT_EQ(found.size(), 9u);
  const std::string ids = "abcdefgh";
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(found[i].curves, std::vector<std::string>{std::string(1, ids[i])});
    const bool rational = ids[i] == 'f' || ids[i] == 'g';
    EXPECT_EQ(found[i].kind, rational ? DefectKind::unsupported : DefectKind::malformed) << ids[i];
    EXPECT_FALSE(found[i].remedy.empty());
    EXPECT_NE(found[i].message.find("number " + std::to_string(i)), std::string::npos);
  }
}

TEST(Json, FeaturesAreMarked) {
  const Drawing drawing = read_drawings_from(
      R"([{"poles":[[0,0],[1,0]]},{"poles":[[0,0],[0,1]],"feature":true},
          {"poles":[[0,0],[1,1]],"feature":false}])",
      "test")[0];
  EXPECT_FALSE(drawing.curves[0].feature);
  EXPECT_TRUE(drawing.curves[1].feature);
  EXPECT_FALSE(drawing.curves[2].feature);
  EXPECT_EQ(first_kind(R"([{"poles":[[0,0],[1,0]],"feature":1}])"), DefectKind::malformed);
}

TEST(Json, SyntaxErrorsAreMalformed) {
  for (const char* text : {"[", "{", "[1,", "[] x", "{\"curves\":3}", "{\"poles\":[]}", "[NaN]",
                           "[{\"poles\":[[0,0],[1e999,0]]}]", "[\"\xFF\"]", "", "hello", "7"})
    EXPECT_EQ(first_kind(text), DefectKind::malformed) << text;
  EXPECT_EQ(first_kind(std::string(kLine) + " rubbish"), DefectKind::malformed);
  EXPECT_EQ(first_kind("[]"), DefectKind::empty);
  EXPECT_EQ(first_kind("{\"curves\":[]}"), DefectKind::empty);
}

TEST(Json, LimitsHold) {
  EXPECT_EQ(first_kind(std::string(1'000'000, '[')), DefectKind::limit);
  EXPECT_EQ(first_kind("[" + std::string(1'000'000, '{')), DefectKind::limit);
  // Brackets within strings do not nest.
  EXPECT_TRUE(
      refusal("[{\"curve_id\":\"\\\"" + std::string(1000, '[') + "\",\"poles\":[[0,0],[1,0]]}]")
          .empty());
  ReadOptions small;
  small.max_bytes = 20;
  EXPECT_EQ(first_kind(kLine, small), DefectKind::limit);
  ReadOptions few;
  few.max_curves = 1;
  EXPECT_TRUE(refusal(kLine, few).empty());
  EXPECT_EQ(first_kind(R"([{"poles":[[0,0],[1,0]]},{"poles":[[0,0],[1,0]]}])", few),
            DefectKind::limit);
}

TEST(Json, FilesThatAreNotThereThrowFileError) {
  EXPECT_THROW(read_drawings("/nowhere/at/all.json"), FileError);
  EXPECT_THROW(read_drawings("/"), FileError);
}

}  // namespace
}  // namespace c1mesh
