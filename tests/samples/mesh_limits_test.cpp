// Limits of single meshes, from the command line to the verification of the result.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/sealed_result.h"
#include "tests/samples/small_shop.h"

namespace gouge::testing_samples::mesh_limits_test {
namespace {

using nlohmann::json;

constexpr const char* kClamp = "clamp.stl,clearance=5";

std::vector<std::string> words(const std::string& command, const std::string& path,
                               const std::vector<std::string>& more = {}) {
  std::vector<std::string> all{command, path, "--tools", "tools.json", "--part", "part.stl", "--fixture", kClamp};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(MeshLimits, MakeAMoveWithinTheClearanceAGouge) {
  const SampleFolder sample = open_sample("pocket");
  const Outcome ran = run_gougecheck(sample.path, words("check", "pocket.apt", {"--json", "result.json"}));
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("6.000 mm cutter T3 against fixture clamp.stl and its clearance of 5.000 mm"),
            std::string::npos)
      << ran.out;
  const json result = json::parse(text_of(sample.path + "/result.json"));
  EXPECT_EQ(result.at("events").back().at("obstacle"), "clamp.stl");
  EXPECT_EQ(result.at("options").at("more").at("fixture"), kClamp);
}

TEST(MeshLimits, AreVerifiedFromTheResult) {
  const SampleFolder sample = open_sample("pocket");
  ASSERT_EQ(run_gougecheck(sample.path, words("check", "pocket.apt", {"--json", "result.json", "-q"})).exit_status, 1);
  const Outcome verified = run_gougecheck(sample.path, {"verify", "result.json"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  // The same result without the clearance claims a depth that the clamp does not have.
  json result = json::parse(text_of(sample.path + "/result.json"));
  result.at("options").at("more").erase("fixture");
  write_text(sample.path + "/other.json", sealed(result));
  const Outcome refuted = run_gougecheck(sample.path, {"verify", "other.json"});
  EXPECT_NE(refuted.exit_status, 0);
  EXPECT_NE(refuted.out.find("refuted"), std::string::npos) << refuted.out;
}

// A surface that was exported with front and back. A tool that crosses it gouges; a clean path rests on a default.
TEST(ClosedSheet, IsAPartWithoutVolume) {
  const SmallShop shop;
  shop.write("part.stl",
             "solid sheet\n"
             "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 100 0 0\nvertex 100 100 0\nendloop\nendfacet\n"
             "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 100 100 0\nvertex 0 100 0\nendloop\nendfacet\n"
             "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 100 0\nvertex 100 0 0\nendloop\nendfacet\n"
             "facet normal 0 0 -1\nouter loop\nvertex 100 0 0\nvertex 0 100 0\nvertex 100 100 0\nendloop\nendfacet\n"
             "endsolid sheet\n");
  const Outcome gouging = shop.check("gouging", path_text(stations({{50, -2}})));
  EXPECT_EQ(gouging.exit_status, 1) << gouging.err;
  EXPECT_EQ(shop.run({"verify", "gouging.json"}).exit_status, 0);
  const Outcome clean = shop.check("clean", path_text(stations({})));
  EXPECT_EQ(clean.exit_status, 0) << clean.out << clean.err;
  EXPECT_NE(clean.out.find("solid part.stl without volume (default)"), std::string::npos) << clean.out;
  EXPECT_EQ(shop.run({"correct", "path.apt", "--part", "part.stl", "-o", "corrected.apt"}).exit_status, 0);
}

TEST(MeshLimits, WithoutAUnitAreInMmWhateverThePathIsIn) {
  const SampleFolder sample = open_sample("inch");
  const auto check_with = [&](const std::string& part) {
    return run_gougecheck(sample.path, {"check", "inch.apt", "--tools", "tools.json", "--part", part});
  };
  const Outcome bare = check_with("part.stl,tolerance=0.005"), with_unit = check_with("part.stl,tolerance=0.0002in");
  EXPECT_NE((bare.out + bare.err).find("tolerance=0.005 is taken in mm"), std::string::npos) << bare.out << bare.err;
  EXPECT_EQ((with_unit.out + with_unit.err).find("taken in mm"), std::string::npos) << with_unit.out;
}

TEST(MeshLimits, AreKeptByTheCorrectedToolpath) {
  const SampleFolder sample = open_sample("pocket");
  const Outcome corrected = run_gougecheck(sample.path, words("correct", "pocket.apt", {"-o", "corrected.apt"}));
  EXPECT_EQ(corrected.exit_status, 0) << corrected.out << corrected.err;
  const Outcome checked = run_gougecheck(sample.path, words("check", "corrected.apt"));
  EXPECT_EQ(checked.exit_status, 0);
  EXPECT_NE(checked.out.find("no approach to clamp.stl below its clearance of 5 mm"), std::string::npos) << checked.out;
}

}  // namespace
}  // namespace gouge::testing_samples::mesh_limits_test
