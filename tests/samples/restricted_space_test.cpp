// The public benchmark of a restricted space (L. Su and others, "A benchmark for robotic milling in restricted spaces"):
// an end mill of radius 12.5 mm with a corner of 5 mm and a robot's spindle go 1.3 m through a slot between leaning
// blocks, 651 positions 2 mm apart. The benchmark names no coordinates: here the tip goes along X at y = 100, z = 0, the
// axis programmed as (0, 0.8, 0.6), where the tool alone is free and the spindle is up to 65 mm deep in the block above.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/source_folder.h"

namespace gouge::testing_samples::restricted_space_test {
namespace {

using Json = nlohmann::json;

constexpr double kSpindle_mm[][2] = {{0, 140}, {45, 140}, {45, 180}, {65, 180}, {65, 580}, {0, 580}};  // r, z

/// In metres, as the benchmark's space is.
void write_spindle(const std::string& path) {
  constexpr int kAround = 48;
  std::ofstream out(path);
  out << "solid spindle\n";
  const auto corner = [&](std::size_t k, int i) {
    const double angle = 2 * std::numbers::pi * (i % kAround) / kAround, r = kSpindle_mm[k][0] / 1000;
    out << "vertex " << r * std::cos(angle) << ' ' << r * std::sin(angle) << ' ' << kSpindle_mm[k][1] / 1000 << '\n';
  };
  for (std::size_t k = 0; k + 1 < std::size(kSpindle_mm); ++k) {
    for (int i = 0; i < kAround; ++i) {
      const auto facet = [&](std::size_t ka, int ia, std::size_t kb, int ib, std::size_t kc, int ic) {
        out << "facet normal 0 0 0\nouter loop\n";
        corner(ka, ia);
        corner(kb, ib);
        corner(kc, ic);
        out << "endloop\nendfacet\n";
      };
      if (kSpindle_mm[k][0] > 0) facet(k, i, k, i + 1, k + 1, i + 1);
      if (kSpindle_mm[k + 1][0] > 0) facet(k, i, k + 1, i + 1, k + 1, i);
    }
  }
  out << "endsolid spindle\n";
}

void write_path(const std::string& path) {
  std::ofstream out(path);
  out << "UNITS/MM\nMULTAX/ON\nLOADTL/1\nFEDRAT/2000, MMPM\n";
  for (int i = 0; i < 651; ++i) out << "GOTO/ " << 2 * i << ", 100, 0, 0, 0.8, 0.6\n";
  out << "FINI\n";
}

struct Tilted {
  int exit_status = -1;
  Json result;
};

class RestrictedSpace : public testing::Test {
 protected:
  void SetUp() override {
    const auto space =
        std::filesystem::path(source_folder()) / "../shared/data/restricted_space/SDG1V7sim350_400E1.STL";
    if (!std::filesystem::exists(space)) GTEST_SKIP() << "the shared data is not here";
    // Corners that should meet are 2e-10 mm apart, which leaves its edges open.
    const Outcome mended = run_gougecheck(
        folder_, {"mesh", space.string(), "--stl-units", "m", "--weld", "0.001", "--repair", "space.stl"});
    ASSERT_NE(mended.out.find("repaired: sound"), std::string::npos) << mended.out << mended.err;
    write_spindle(folder_ + "/spindle.stl");
    write_path(folder_ + "/path.apt");
    write_text(folder_ + "/tools.json", R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"bull_nose",
      "diameter":25,"corner_radius":5,"length":50},"shank":[{"lower_diameter":25,"upper_diameter":25,"length":30}],
      "holder":[{"lower_diameter":50,"upper_diameter":63,"length":60}]}]})");
  }

  /// Tilted one way alone or both, by 27.1 degrees at most.
  Tilted tilted(const std::string& way) {
    const Outcome ran = run_gougecheck(
        folder_, {"correct",       "path.apt", "--part",      "space.stl",  "--stl-units",   "m",       "--tools",
                  "tools.json",    "--head",   "spindle.stl", "--strategy", "tilt",          "--tilt",  way,
                  "--max-tilt",    "27.1",     "--blend",     "40",         "--allow-stock", "100",     "-o",
                  "corrected.apt", "--json",   "result.json", "--force",    "--assume",      "complete"});
    return {ran.exit_status, Json::parse(text_of(folder_ + "/result.json"))};
  }

  std::string folder_ = fresh_folder();
};

TEST_F(RestrictedSpace, IsPassedByTiltsOfTwoWays) {
  const Tilted both = tilted("both");
  EXPECT_EQ(both.exit_status, 0);
  const double most = both.result.at("correction").at("quality").at("largest_tilt").at("rad");
  EXPECT_LT(most * 180 / std::numbers::pi, 27.1);
  EXPECT_GT(most * 180 / std::numbers::pi, 26);
}

TEST_F(RestrictedSpace, IsNotPassedByTiltsToTheSideAlone) { EXPECT_EQ(tilted("side").exit_status, 1); }

TEST_F(RestrictedSpace, IsNotPassedByTiltsAlongTheFeedAlone) { EXPECT_EQ(tilted("lead").exit_status, 1); }

}  // namespace
}  // namespace gouge::testing_samples::restricted_space_test
