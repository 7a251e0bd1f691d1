#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/small_shop.h"

// The tolerances of a control that smooths the path, as users see them.

namespace gouge::testing_samples::smoothing_test {
namespace {

using Json = nlohmann::json;

class SmoothingTube : public testing::Test {
 protected:
  [[nodiscard]] Outcome run(const std::string& command, const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments(command, sample_.toolpath(), more));
  }
  /// Returns the depth of the first move that is not clean.
  [[nodiscard]] double depth_with(const std::vector<std::string>& more) const {
    std::vector<std::string> words = more;
    words.insert(words.end(), {"--json", "check.json"});
    EXPECT_EQ(run("check", words).exit_status, 1);
    const Json report = Json::parse(text_of(sample_.path + "/check.json"));
    const Json& move = report.at("moves").at(0);
    EXPECT_EQ(move.at("witness").at("body"), "holder");
    return move.at("depth");
  }

  SampleFolder sample_ = open_sample("smoothing_tube");
};

TEST_F(SmoothingTube, TurnsACleanPathIntoAGougeOfTheFormula) {
  EXPECT_EQ(run("check", {}).exit_status, 0);
  const double lean = std::numbers::pi / 180;
  const double depth = 20 - 21 * std::cos(lean) + 90 * std::sin(lean);
  EXPECT_NEAR(depth_with({"--axis-tolerance", "1"}), depth, 1e-3);
  EXPECT_NEAR(depth_with({"--axis-tolerance", "1", "--tip-tolerance", "0.02"}), depth + 0.02, 1e-3);
  EXPECT_NEAR(depth_with({"--tip-tolerance", "1.5mm"}), 0.5, 1e-3);
  EXPECT_EQ(run("check", {"--tip-tolerance", "0.5", "--axis-tolerance", "0.2"}).exit_status, 0);
}

TEST_F(SmoothingTube, TheGuaranteeStatesItAndVerifyRepeatsIt) {
  const Outcome ran = run("check", {"--axis-tolerance", "0.1", "--tip-tolerance", "0.01", "--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 0);
  EXPECT_NE(ran.out.find("also where the control departs from its law by up to 0.01 mm at the tip and 0.1 deg of the "
                         "tool axis"),
            std::string::npos)
      << ran.out;
  const Json options = Json::parse(text_of(sample_.path + "/check.json")).at("options").at("more");
  EXPECT_EQ(options.at("tip-tolerance"), "0.01mm");
  EXPECT_EQ(options.at("axis-tolerance"), "0.1");
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "check.json"}).exit_status, 0);
  EXPECT_EQ(run("check", {"--axis-tolerance", "1", "--json", "gouge.json"}).exit_status, 1);
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "gouge.json"}).exit_status, 0);
}

TEST_F(SmoothingTube, ACorrectedPathIsCleanWithinIt) {
  EXPECT_EQ(run("correct", {"--axis-tolerance", "1", "-o", "out.apt"}).exit_status, 0);
  EXPECT_EQ(run_gougecheck(sample_.path, sample_.arguments("check", "out.apt", {"--axis-tolerance", "1"})).exit_status,
            0);
}

TEST_F(SmoothingTube, AMachineFileStatesThemForItsControl) {
  const std::string machine = R"({"name": "m", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true},
    {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0]},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
    "control": {"name": "c", "feed_law": "axis", "rapid_law": "axis", "axis_tolerance": 1}})";
  write_text(sample_.path + "/machine.json", machine);
  const double lean = std::numbers::pi / 180;
  EXPECT_NEAR(depth_with({"--machine", "machine.json"}), 20 - 21 * std::cos(lean) + 90 * std::sin(lean), 1e-3);
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "check.json"}).exit_status, 0);
  EXPECT_EQ(run("check", {"--machine", "machine.json", "--axis-tolerance", "0"}).exit_status, 0);
  EXPECT_NE(run_gougecheck(sample_.path, {"machine", "show", "machine.json"}).out.find("axis tolerance"),
            std::string::npos);
  std::string wide = machine;
  write_text(sample_.path + "/machine.json", wide.replace(wide.find("tolerance\": 1"), 13, "tolerance\": 70"));
  const Outcome refused = run("check", {"--machine", "machine.json"});
  EXPECT_EQ(refused.exit_status, 3);
  EXPECT_NE(refused.err.find("machine.json:7: error: '/control/axis_tolerance' is 70; expected a number from 0 to 10"),
            std::string::npos)
      << refused.err;
}

TEST_F(SmoothingTube, WrongTolerancesAreRefused) {
  const auto error_of = [&](const std::vector<std::string>& more) {
    const Outcome ran = run("check", more);
    EXPECT_EQ(ran.exit_status, 2);
    return ran.err;
  };
  EXPECT_NE(error_of({"--axis-tolerance", "11"}).find("expected degrees from 0 to 10"), std::string::npos);
  EXPECT_NE(error_of({"--axis-tolerance", "-1"}).find("expected degrees from 0 to 10"), std::string::npos);
  EXPECT_NE(error_of({"--tip-tolerance", "wide"}).find("--tip-tolerance 'wide'"), std::string::npos);
  EXPECT_NE(error_of({"--tip-tolerance", "0.1", "--head", "part.stl"}).find("not the bodies of --head"),
            std::string::npos);
}

TEST(SmoothingText, ContradictsASmallerTolerance) {
  const SmallShop shop;
  const auto status = [&](const std::string& text, const std::vector<std::string>& more) {
    return shop.check("a", path_text(stations(), std::string(kHead) + "INSERT " + text + "\n"), more).exit_status;
  };
  for (const char* const text : {"G187 E0.5", "CYCLE832(0.144)", "G64 P0.5", "CYCL DEF 32.1 T0.5"}) {
    EXPECT_EQ(status(text, {"--tip-tolerance", "0.01", "--tolerance", "1"}), 4) << text;
    EXPECT_EQ(shop.json("a.json").at("verdict"), "not-fully-checked");
    EXPECT_EQ(status(text, {"--tip-tolerance", "0.5", "--tolerance", "1"}), 0) << text;
    EXPECT_EQ(status(text, {"--tip-tolerance", "0.01", "--tolerance", "1", "--assume", "smoothing"}), 0) << text;
  }
}

TEST(JointLawText, ContradictsTheGreatCircleWhereTheAxisTurns) {
  const SmallShop shop;
  const std::string head = "PARTNO/SHOP\nUNITS/MM\nCUTTER/10\nLOADTL/1\nMULTAX/ON\n";
  const std::string turns = "GOTO/-20,50,30,0,0,1\nGOTO/-20,50,30,0,.6,.8\nFINI\n";
  EXPECT_EQ(shop.check("a", head + turns).exit_status, 0);
  EXPECT_EQ(shop.check("a", head + "INSERT ORIVECT\n" + turns).exit_status, 0);
  EXPECT_EQ(shop.check("a", head + "INSERT ORIAXES\nGOTO/-20,50,30,0,0,1\nGOTO/-20,50,40,0,0,1\nFINI\n").exit_status,
            0);
  const Outcome ran = shop.check("a", head + "INSERT ORIAXES\n" + turns);
  EXPECT_EQ(ran.exit_status, 4);
  EXPECT_NE(ran.out.find("motion-law (contradicted): text for the control in line 6"), std::string::npos) << ran.out;
  EXPECT_EQ(shop.check("a", head + "INSERT ORIAXES\n" + turns, {"--assume", "motion-law"}).exit_status, 0);
}

}  // namespace
}  // namespace gouge::testing_samples::smoothing_test
