// SPDX-License-Identifier: GPL-3.0-or-later
// Real and hostile files, from reading to the checked shape.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "check/drawings.h"

namespace c1mesh {
namespace {

namespace fs = std::filesystem;

enum class Expected { ok, refuse, either };

struct Case {
  const char* file;
  Expected expected;
  DefectKind kind = DefectKind::note;  // among the faults if refused
};

const Case kCases[] = {
    {"self-cross-lines.json", Expected::refuse, DefectKind::crossing},
    {"loop-in-one-cubic.json", Expected::refuse, DefectKind::self_intersection},
    {"vertex-touch.json", Expected::refuse, DefectKind::touching},
    {"zero-handle-start.json", Expected::refuse, DefectKind::vanishing_derivative},
    {"retraced-line-cubic.json", Expected::refuse, DefectKind::vanishing_derivative},
    {"angle-1e-3-deg.json", Expected::either},
    {"open-loop.json", Expected::refuse, DefectKind::open_loop},
    {"duplicate-curve.json", Expected::refuse, DefectKind::duplicate},
    {"mixed-orientation.json", Expected::ok},
    {"hole-first.json", Expected::ok},
    {"hole-touches.json", Expected::refuse, DefectKind::touching},
    {"offset-1e9.json", Expected::ok},
    {"tiny-1e-160.json", Expected::either, DefectKind::non_finite},
    {"degree1-square.json", Expected::ok},
    {"degree4.json", Expected::ok},
    {"one-curve-drop.json", Expected::ok},
    {"null-pole.json", Expected::refuse, DefectKind::malformed},
    {"pole-1d.json", Expected::refuse, DefectKind::malformed},
    {"empty-poles.json", Expected::refuse, DefectKind::malformed},
    {"type-rational.json", Expected::refuse, DefectKind::unsupported},
    {"empty-list.json", Expected::refuse, DefectKind::empty},
    {"trailing-garbage.json", Expected::refuse, DefectKind::malformed},
    {"bom-crlf.json", Expected::ok},
    {"truncated.svg", Expected::refuse, DefectKind::malformed},
    {"transform.svg", Expected::ok},
    {"arcs-glued-flags.svg", Expected::ok},
    {"numbers-compact.svg", Expected::ok},
    {"basic-shapes.svg", Expected::ok},
    {"open-subpath.svg", Expected::ok},
    {"entity-bomb.svg", Expected::refuse, DefectKind::unsupported},
    {"not-svg.svg", Expected::refuse, DefectKind::malformed},
};

// The real ones by what their names say.
Case real_case(const std::string& name) {
  const std::map<std::string, Case> by_reason = {
      {"real-notsimple", {"", Expected::refuse, DefectKind::crossing}},
      {"real-zerohandle", {"", Expected::refuse, DefectKind::vanishing_derivative}},
      {"real-cusp180", {"", Expected::refuse, DefectKind::cusp}},
      {"real-cusp179", {"", Expected::ok}},
      {"real-zerolen", {"", Expected::ok}}};
  for (const auto& [reason, found] : by_reason)
    if (name.rfind(reason, 0) == 0) return found;
  ADD_FAILURE() << "nothing is expected of " << name;
  return {};
}

// Every drawing of the file meshable and keeping its promises, or the faults of the first that is
// not.
std::vector<Defect> faults_of_file(const fs::path& path) {
  try {
    for (const Drawing& drawing : read_drawings(path.string()))
      EXPECT_EQ(broken_promise(make_shape(drawing)), "") << path;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.defects().empty());
    EXPECT_NE(std::string(error.what()), "");
    return error.defects();
  }
  return {};
}

void expect(const fs::path& path, const Case& expected) {
  const std::vector<Defect> found = faults_of_file(path);
  if (expected.expected == Expected::ok) {
    EXPECT_TRUE(found.empty()) << path << ": " << (found.empty() ? "" : describe(found[0]));
    return;
  }
  if (expected.expected == Expected::either && found.empty()) return;
  bool named = false;
  for (const Defect& defect : found) named |= defect.kind == expected.kind;
  EXPECT_TRUE(named) << path << ": " << (found.empty() ? "accepted" : describe(found[0]));
}

TEST(Files, HostileInputsAsExpected) {
  const fs::path folder = fs::path(C1MESH_TEST_DATA) / "nasty";
  for (const Case& one : kCases) expect(folder / one.file, one);
}

TEST(Files, RealDefectsAsExpected) {
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(C1MESH_TEST_DATA) / "nasty")) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("real-", 0) != 0) continue;
    ++seen;
    expect(entry.path(), real_case(name));
  }
  EXPECT_EQ(seen, 20u);
}

// Where a shape is given as JSON and as SVG: the same curves turned upside down.
TEST(Files, RealShapesAndTheirTwins) {
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(C1MESH_TEST_DATA) / "corpus")) {
    if (entry.path().extension() != ".json") continue;
    const Shape json = make_shape(read_drawings(entry.path().string()).at(0));
    EXPECT_EQ(broken_promise(json), "");
    const fs::path twin = fs::path(entry.path()).replace_extension(".svg");
    if (!fs::exists(twin)) continue;
    ++seen;
    const Shape svg = make_shape(read_drawings(twin.string()).at(0));
    EXPECT_EQ(broken_promise(svg), "");
    EXPECT_EQ(json.name, svg.name);
    ASSERT_EQ(json.curves.size(), svg.curves.size());
    for (std::size_t i = 0; i < json.curves.size(); ++i)
      for (std::size_t k = 0; k < json.curves[i].poles.size(); ++k)
        EXPECT_EQ(json.curves[i].poles[k],
                  Point(svg.curves[i].poles[k].cwiseProduct(Point(1, -1))));
    ASSERT_EQ(json.regions.size(), svg.regions.size());
    for (std::size_t r = 0; r < json.regions.size(); ++r)
      EXPECT_EQ(json.regions[r].holes.size(), svg.regions[r].holes.size());
  }
  EXPECT_EQ(seen, 5u);
}

// No prefix of a good file crashes or hangs; each is refused or meshed.
TEST(Files, TruncatedAnywhere) {
  const fs::path folder = fs::path(C1MESH_TEST_DATA) / "corpus";
  for (const char* file : {"S_oc_food.fruit.candied_apples_ganson_p259.json",
                           "S_oc_food.fruit.candied_apples_ganson_p259.svg"}) {
    std::ifstream in(folder / file);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    std::size_t last = text.size();
    while (last > 0 && text[last - 1] == '\n') --last;
    for (std::size_t length = 0; length < last; ++length)
      EXPECT_THROW(read_drawings_from(text.substr(0, length), "cut"), InputError) << length;
  }
}

}  // namespace
}  // namespace c1mesh
