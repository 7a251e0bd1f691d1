#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/samples/box_stl.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// correct tilts where a holder collides, as users run it.

namespace gouge::testing_samples::tilt_test {
namespace {

using Json = nlohmann::json;

struct Corrected {
  Outcome ran;
  Json correction;
};

Corrected correct(const SampleFolder& sample, std::vector<std::string> more) {
  more.insert(more.end(), {"-o", "corrected.apt", "--json", "result.json"});
  Outcome ran = run_gougecheck(sample.path, sample.arguments("correct", sample.toolpath(), more));
  return {std::move(ran), Json::parse(text_of(sample.path + "/result.json")).at("correction")};
}

std::size_t changes_by(const Corrected& corrected, const std::string& strategy) {
  std::size_t count = 0;
  for (const Json& change : corrected.correction.at("changes")) count += change.at("strategy") == strategy ? 1U : 0U;
  return count;
}

// Its last pass runs the holder into the wall, by 1.0 to 2.1 mm.
TEST(Tilt, OfTheFreeformsLastPassFreesTheHolderAndKeepsTheBallsCentre) {
  const SampleFolder sample = open_sample("freeform");
  const Corrected tilted = correct(sample, {});
  EXPECT_EQ(tilted.ran.exit_status, 0) << tilted.ran.err;
  EXPECT_GT(changes_by(tilted, "tilt"), 50U);
  const double most = tilted.correction.at("quality").at("largest_tilt").at("rad");
  EXPECT_GT(most, 0.05);
  EXPECT_LT(most, 0.3);
  // 5 mm of ball: its tip moves by no more than the centre needs to stay.
  for (const Json& change : tilted.correction.at("changes")) {
    if (change.at("strategy") != "tilt") continue;
    EXPECT_LE(change.at("shift_length").get<double>(), 5.001 * change.at("tilt_rad").get<double>() + 1e-6);
  }
  const Corrected lifted = correct(sample, {"--strategy", "holder=axis"});
  EXPECT_EQ(lifted.ran.exit_status, 0) << lifted.ran.err;
  EXPECT_EQ(changes_by(lifted, "tilt"), 0U);
}

TEST(Tilt, LimitsInForceStandInTheReport) {
  const SampleFolder sample = open_sample("freeform");
  correct(sample, {});
  const auto more = [&] { return Json::parse(text_of(sample.path + "/result.json")).at("options").at("more"); };
  EXPECT_EQ(more(), Json({{"max-tilt", "30"}, {"tilt", "both"}, {"blend", "10mm"}, {"allow-stock", "0.01mm"}}));
  correct(sample, {"--max-tilt", "20", "--tilt", "side", "--blend", "0.5in", "--axis-cone", "0,0,1,60", "--max-turn",
                   "4", "--max-turn-step", "9", "--max-rotary-speed", "3600", "--allow-multax", "--allow-stock", "0.02",
                   "--report", "r"});
  EXPECT_EQ(more(), Json({{"max-tilt", "20"},
                          {"tilt", "side"},
                          {"blend", "0.5in"},
                          {"allow-stock", "0.02mm"},
                          {"axis-cone", "0,0,1,60"},
                          {"max-turn", "4"},
                          {"max-turn-step", "9"},
                          {"max-rotary-speed", "3600"},
                          {"allow-multax", "yes"}}));
  const std::string html = text_of(sample.path + "/r/report.html");
  for (const char* shown : {"axis-cone", "0,0,1,60", "max-turn-step", "0.5in"})
    EXPECT_NE(html.find(shown), std::string::npos) << shown;
}

// The edge of a flat end does what its face did: nothing gouges, but the floor would be left higher. So it is not
// tilted unless that is allowed, and what the lift leaves instead is stated too.
TEST(Tilt, OfAFlatEndThatWouldLeaveStockIsNotMadeUnlessAllowed) {
  const std::string folder = fresh_folder();
  write_text(folder + "/floor.stl", box_stl({-200, -200, -10}, {200, 200, 0}));
  write_text(folder + "/wall.stl", box_stl({13, -30, -5}, {60, 30, 60}));
  std::string path = "UNITS/MM\nMULTAX/ON\nLOADTL/1\nGOTO/0,-80,120,0,0,1\n";
  for (int y = -80; y <= 80; y += 4) path += "GOTO/0," + std::to_string(y) + ",0,0,0,1\n";
  write_text(folder + "/pass.apt", path);
  const auto ran_with = [&](const std::string& shape, const std::string& allowed) {
    write_text(folder + "/tools.json", R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":")" + shape +
                                           R"(","diameter":10,"length":30},
      "shank":[{"lower_diameter":10,"upper_diameter":10,"length":20}],
      "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40}]}]})");
    Corrected corrected;
    corrected.ran =
        run_gougecheck(folder, {"correct", "pass.apt", "--part", "floor.stl", "--part", "wall.stl", "--tools",
                                "tools.json", "-o", "tilted.apt", "--json", "result.json", "--allow-stock", allowed});
    EXPECT_EQ(corrected.ran.exit_status, 0) << corrected.ran.err;
    corrected.correction = Json::parse(text_of(folder + "/result.json")).at("correction");
    return corrected;
  };
  const auto is_said = [](const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
  };
  const Corrected ball = ran_with("ball", "0.01");
  EXPECT_GT(changes_by(ball, "tilt"), 0U);
  EXPECT_TRUE(ball.correction.at("stock").empty());
  EXPECT_FALSE(is_said(ball.ran.err + ball.ran.out, "stock")) << ball.ran.err << ball.ran.out;
  const Corrected lifted = ran_with("flat", "0.01");
  EXPECT_EQ(changes_by(lifted, "tilt"), 0U);
  EXPECT_TRUE(is_said(lifted.ran.err, "the holder collides; the tilt that frees it and leaves least ("))
      << lifted.ran.err;
  EXPECT_TRUE(is_said(lifted.ran.err, "[stock-left]")) << lifted.ran.err;
  EXPECT_TRUE(is_said(lifted.ran.out, "stock: ")) << lifted.ran.out;
  ASSERT_EQ(lifted.correction.at("stock").size(), 1U);
  // The holder begins 50 mm above the tip, the wall ends at 60.
  EXPECT_NEAR(lifted.correction.at("stock")[0].at("thickness").get<double>(), 10, 0.3);
  const Corrected tilted = ran_with("flat", "3");
  EXPECT_GT(changes_by(tilted, "tilt"), 0U);
  ASSERT_EQ(tilted.correction.at("stock").size(), 1U);
  const double most = tilted.correction.at("quality").at("largest_tilt").at("rad");
  EXPECT_NEAR(tilted.correction.at("stock")[0].at("thickness").get<double>(), 10 * std::sin(most), 0.03);
  EXPECT_FALSE(is_said(tilted.ran.err, "[not-tilted]")) << tilted.ran.err;
}

TEST(Tilt, ThatIsNotFoundIsSaidAndLifted) {
  const SampleFolder sample = open_sample("freeform");
  const Corrected lifted = correct(sample, {"--max-tilt", "0.5"});
  EXPECT_EQ(lifted.ran.exit_status, 0) << lifted.ran.err;
  EXPECT_EQ(changes_by(lifted, "tilt"), 0U);
  EXPECT_NE(lifted.ran.err.find("no tilt within --max-tilt 0.5 degrees frees line"), std::string::npos)
      << lifted.ran.err;
  EXPECT_NE(lifted.ran.err.find("[not-tilted]"), std::string::npos) << lifted.ran.err;
}

/// A ball of 6 mm, stick-out 50 mm, on a block beside a wall that its holder of 32 mm meets by 1 mm. A tilt of 1.23
/// degrees frees it. The machine turns the part by C on A.
class MachineBesideWall : public testing::Test {
 protected:
  MachineBesideWall() {
    write_text(folder_ + "/block.stl", box_stl({-50, 0, 0}, {150, 50, 20}));
    write_text(folder_ + "/wall.stl", box_stl({0, 40, 20}, {100, 60, 88}));
    write_text(folder_ + "/tools.json", R"({"units":"mm","tools":[{"number":2,"cutter":{"shape":"ball","diameter":6,
      "length":20},"shank":[{"lower_diameter":6,"upper_diameter":6,"length":30}],
      "holder":[{"lower_diameter":32,"upper_diameter":32,"length":50}]}]})");
    write_text(folder_ + "/machine.json", R"({"name":"C on A","source":"test","joints":[
      {"name":"C","type":"rotary","side":"table","direction":[0,0,1],"continuous":true,"point":[0,0,0]},
      {"name":"A","type":"rotary","side":"table","direction":[1,0,0],"point":[0,0,0],"min":-120,"max":120},
      {"name":"X","type":"linear","side":"head","direction":[1,0,0]},
      {"name":"Y","type":"linear","side":"head","direction":[0,1,0]},
      {"name":"Z","type":"linear","side":"head","direction":[0,0,1]}],
      "control":{"name":"test","rapid_law":"axis"}})");
    std::string path = "UNITS/MM\nMULTAX\nLOADTL/2\nFEDRAT/500,MMPM\n";
    for (int x = -40; x <= 140; x += 10) path += "GOTO/" + std::to_string(x) + ",25,20,0,0,1\n";
    write_text(folder_ + "/pass.apt", path);
  }

  [[nodiscard]] Corrected correct_with(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"correct",  "pass.apt",    "--part",     "block.stl",   "--part",
                                      "wall.stl", "--tools",     "tools.json", "-o",          "out.apt",
                                      "--json",   "result.json", "--machine",  "machine.json"};
    words.insert(words.end(), more.begin(), more.end());
    Corrected corrected;
    corrected.ran = run_gougecheck(folder_, words);
    corrected.correction = Json::parse(text_of(folder_ + "/result.json")).at("correction");
    return corrected;
  }

  std::string folder_ = fresh_folder();
};

// With A below 0 the tool leans away from the wall after half a turn of C, or forward as well.
TEST_F(MachineBesideWall, IsTiltedWithinTheLimitsOfItsJoints) {
  for (const std::string limit : {"A=-120..120", "A=0..2", "A=-1..1.24", "A=-120..1", "A=-120..0", "C=-10..10"}) {
    const Corrected tilted = correct_with({"--feed-law", "axis", "--joint-limit", limit});
    EXPECT_EQ(tilted.ran.exit_status, 0) << limit << tilted.ran.out << tilted.ran.err;
    EXPECT_GT(changes_by(tilted, "tilt"), 0U) << limit;
  }
}

TEST_F(MachineBesideWall, IsLiftedIfAJointCannotTurnSoFar) {
  for (const std::string law : {"axis", "vector", "documented"}) {
    for (const std::string limit : {"A=-1..1", "A=0..0.5"}) {
      const Corrected lifted = correct_with({"--feed-law", law, "--joint-limit", limit});
      EXPECT_EQ(lifted.ran.exit_status, 0) << limit << lifted.ran.out << lifted.ran.err;
      EXPECT_EQ(changes_by(lifted, "tilt"), 0U);
      const std::string& said = lifted.ran.err;
      EXPECT_NE(said.find("1.23 degrees would free it, but joint A would be at 1.2"), std::string::npos) << said;
      const std::string most = limit == "A=0..0.5" ? "0.5" : "1";
      EXPECT_NE(said.find("; its limit is " + most + " degrees"), std::string::npos) << said;
    }
  }
}

// A lift by 18 mm needs Z at 88 mm: 20, the tool and the lift.
TEST_F(MachineBesideWall, NamesALinearJointThatAllowsNoLift) {
  const Corrected left = correct_with({"--feed-law", "axis", "--joint-limit", "A=-1..1", "--zero", "0,0,0",
                                       "--tool-length", "50", "--joint-limit", "Z=..71"});
  EXPECT_EQ(left.ran.exit_status, 1) << left.ran.out << left.ran.err;
  ASSERT_FALSE(left.correction.at("uncorrected").empty());
  for (const Json& one : left.correction.at("uncorrected")) {
    const std::string reason = one.at("reason");
    const std::size_t first = reason.find("joint Z would be beyond its limit, 71 mm");
    EXPECT_NE(first, std::string::npos) << reason;
    EXPECT_EQ(reason.find("joint Z", first + 1), std::string::npos) << reason;
    EXPECT_NE(reason.find("joint A would be at 1.2"), std::string::npos) << reason;
  }
}

TEST_F(MachineBesideWall, IsNotTiltedBeyondALimitOfALinearJoint) {
  // A tilt by A about the zero raises Y from 25 to 25.48 mm. With C turned by half a turn Y is below 0.
  const Corrected lifted = correct_with({"--feed-law", "axis", "--zero", "0,0,0", "--tool-length", "50",
                                         "--joint-limit", "Y=24.9..25.1", "--joint-limit", "Z=..500"});
  EXPECT_EQ(lifted.ran.exit_status, 0) << lifted.ran.out << lifted.ran.err;
  for (const Json& change : lifted.correction.at("changes")) EXPECT_NE(change.at("strategy"), "tilt");
}

}  // namespace
}  // namespace gouge::testing_samples::tilt_test
