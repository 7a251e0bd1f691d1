#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// correct tilts where a holder collides, as users run it.

namespace gouge::testing_samples {
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
  EXPECT_EQ(more(), Json({{"max-tilt", "30"}, {"tilt", "both"}, {"blend", "10"}}));
  correct(sample, {"--max-tilt", "20", "--tilt", "side", "--blend", "0.5in", "--axis-cone", "0,0,1,60", "--max-turn",
                   "4", "--max-turn-step", "9", "--max-rotary-speed", "3600", "--allow-multax", "--report", "r"});
  EXPECT_EQ(more(), Json({{"max-tilt", "20"},
                          {"tilt", "side"},
                          {"blend", "0.5in"},
                          {"axis-cone", "0,0,1,60"},
                          {"max-turn", "4"},
                          {"max-turn-step", "9"},
                          {"max-rotary-speed", "3600"},
                          {"allow-multax", "yes"}}));
  const std::string html = text_of(sample.path + "/r/report.html");
  for (const char* shown : {"axis-cone", "0,0,1,60", "max-turn-step", "0.5in"})
    EXPECT_NE(html.find(shown), std::string::npos) << shown;
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

}  // namespace
}  // namespace gouge::testing_samples
