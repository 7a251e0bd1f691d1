// Read the wrong way round an arc meets a post that it clears read right; and one part in five dialects has one
// verdict.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "lib/motion/motion_law.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/laws/guarantee.h"
#include "tests/support/real_arcs.h"
#include "tests/support/shapes.h"
#include "tests/support/source_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::arc_sense_test {
namespace {

class ArcSense : public ::testing::TestWithParam<real_arcs::ArcCase> {};

INSTANTIATE_TEST_SUITE_P(All, ArcSense, ::testing::ValuesIn(real_arcs::kArcs),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ArcSense, OnlyTheWrongWayRoundMeetsThePost) {
  ReadOutcome outcome = read_toolpath("real.apt", GetParam().text);
  ASSERT_TRUE(outcome.toolpath);
  Toolpath& path = *outcome.toolpath;
  path.tools.resize(1);
  for (Move& move : path.moves) move.tool = 0;
  const Vec3 middle = MotionLaw().of(path, 2).at(0.5).tip;
  PathArc& arc = path.arcs.at(0);
  const Vec3 across = 2 * (arc.center - arc.axis.dot(arc.center - middle) * arc.axis) - middle;
  Scene scene;
  scene.parts.push_back(shapes::box(across - Vec3(0.1, 0.1, 5), across + Vec3(0.1, 0.1, 5)));
  const ToolVariants tool = tools::ball(1);
  EXPECT_EQ(whole_check(path, &tool, scene, {}).verdicts[2].state, MoveState::clean);
  arc.sweep_rad -= std::copysign(2 * std::numbers::pi, arc.sweep_rad);
  EXPECT_EQ(whole_check(path, &tool, scene, {}).verdicts[2].state, MoveState::gouge);
}

TEST(FiveDialects, OfOnePartHaveOneVerdictAndOneDepth) {
  const std::string data = source_folder() + "/../shared/data/";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no real toolpaths beside the checkout (" << data << ")";
  CheckResult first;
  std::size_t gouges = 0;
  for (const char* name : {"autodesk_iso4343.apt", "camplete.apt", "catia.aptsource", "creo.ncl.1", "nccs.cl"}) {
    SCOPED_TRACE(name);
    JobArguments arguments;
    arguments.path = data + "toolpaths/five_axis_part/subset_" + name;
    arguments.parts = {data + "parts/matched/five_axis_part_inch.stl"};
    arguments.stl_units = "inch";
    // The sequences of Creo break the path into other groups of moves, whose gouges are found to the resolution.
    arguments.resolution = "0.00001mm";
    if (std::string(name) == "nccs.cl") arguments.reading.units = "inch";
    const testing_support::TemporaryFolder folder;
    const std::string library = folder.at("tools.json");
    std::ofstream(library) << R"({"units":"inch","tools":[
      {"number":1,"cutter":{"shape":"flat","diameter":0.75,"length":2}},
      {"number":2,"cutter":{"shape":"flat","diameter":0.75,"length":2}},
      {"number":3,"cutter":{"shape":"ball","diameter":0.236,"length":2}}]})";
    arguments.tools_file = library;
    const Job job = guarantee::load(arguments);
    const CheckResult result = guarantee::check_job(job);
    if (first.verdicts.empty()) first = result;
    ASSERT_EQ(result.verdicts.size(), first.verdicts.size());
    EXPECT_EQ(result.counts.not_checked, 0U);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
      ASSERT_EQ(result.verdicts[i].state, first.verdicts[i].state) << i;
      // A clean move need only be no deeper than the tolerance.
      if (result.verdicts[i].state != MoveState::gouge) continue;
      ++gouges;
      ASSERT_NEAR(result.verdicts[i].depth_mm, first.verdicts[i].depth_mm, 1e-5) << i;
    }
  }
  EXPECT_GT(gouges, 100U);
}

}  // namespace
}  // namespace gouge::arc_sense_test
