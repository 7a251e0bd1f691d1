#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/small_shop.h"

// A fixture that reaches into its part, seen by clash, check and correct.

namespace gouge::testing_samples::setup_test {
namespace {

using Json = nlohmann::json;

class SunkJaw : public testing::Test {
 protected:
  [[nodiscard]] Outcome run(const std::string& command, const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments(command, sample_.toolpath(), more));
  }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text_of(sample_.path + "/" + file)); }

  SampleFolder sample_ = open_sample("sunk_jaw");
};

const std::string kWarning =
    "jaw.stl: warning: the fixture and the part part.stl penetrate each other, 2.000 mm deep at (";
const std::string kAdvice = "); check the set-up, or allow it with --allow-overlap jaw.stl [fixture-overlap]\n";

TEST_F(SunkJaw, ClashHasTheDepthOfTheFormulaAndAShiftThatHolds) {
  const Outcome ran = run_gougecheck(sample_.path, {"clash", "part.stl", "jaw.stl", "--json", "clash.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  const Json clash = json_of("clash.json");
  const double overlap = sample_.expected.at("overlap");
  EXPECT_NEAR(clash.at("depth"), overlap, 1e-6);
  EXPECT_NEAR(clash.at("depth_upper"), overlap, 0.0011);
  std::string place;
  for (const Json& by : clash.at("shift").at("by")) place += (place.empty() ? "" : ",") + by.dump();
  EXPECT_EQ(run_gougecheck(sample_.path, {"clash", "part.stl", "jaw.stl", "--place-b", place}).exit_status, 0) << place;
}

TEST_F(SunkJaw, CheckAndCorrectWarnWithDepthAndPlaceAndKeepTheirStatus) {
  for (const std::string command : {"check", "correct"}) {
    std::vector<std::string> more = {"--json", command + ".json", "--report", command};
    if (command == "correct") more.insert(more.end(), {"-o", "out.apt"});
    const Outcome ran = run(command, more);
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    EXPECT_EQ(ran.err.rfind(kWarning, 0), 0U) << ran.err;
    EXPECT_NE(ran.err.find(kAdvice), std::string::npos) << ran.err;
    const Json report = json_of(command + ".json");
    std::size_t warnings = 0;
    for (const Json& note : report.at("notes")) warnings += note.at("code") == "fixture-overlap" ? 1U : 0U;
    EXPECT_EQ(warnings, 1U);
    EXPECT_NE(text_of(sample_.path + "/" + command + "/report.html").find("[fixture-overlap]"), std::string::npos);
  }
}

TEST_F(SunkJaw, WithWarningsAsErrorsIsNotClean) {
  const Outcome ran = run("check", {"--warnings-as-errors", "--json", "check.json", "--junit", "check.xml"});
  EXPECT_EQ(ran.exit_status, 4) << ran.err;
  EXPECT_NE(ran.out.find("not established: no warning (contradicted): the result has 1 warning"), std::string::npos)
      << ran.out;
  const Json report = json_of("check.json");
  EXPECT_EQ(report.at("verdict"), "not-fully-checked");
  EXPECT_EQ(report.at("exit_status"), 4);
  EXPECT_EQ(report.at("options").at("more").at("warnings-as-errors"), "yes");
  EXPECT_NE(text_of(sample_.path + "/check.xml").find("<error message=\"no warning (contradicted)"), std::string::npos);
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "check.json"}).exit_status, 0);
  EXPECT_EQ(run("check", {"--warnings-as-errors", "--allow-overlap", "jaw.stl"}).exit_status, 0);
  EXPECT_EQ(run("correct", {"--warnings-as-errors", "-o", "out.apt"}).exit_status, 4);
}

TEST_F(SunkJaw, AResultThatHidesItsWarningsIsRefuted) {
  EXPECT_EQ(run("check", {"--warnings-as-errors", "--json", "check.json"}).exit_status, 4);
  std::string changed = text_of(sample_.path + "/check.json");
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
  };
  replace("\"not-fully-checked\"", "\"clean\"");
  replace("\"exit_status\": 4", "\"exit_status\": 0");
  write_text(sample_.path + "/hidden.json", changed);
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "hidden.json"}).exit_status, 1);
}

TEST_F(SunkJaw, AnOverlapThatIsAllowedOrWithinTheToleranceIsNoWarning) {
  const Outcome allowed = run("check", {"--allow-overlap", "jaw.stl", "--json", "allowed.json"});
  EXPECT_EQ(allowed.exit_status, 0);
  EXPECT_EQ(allowed.err, "");
  EXPECT_EQ(json_of("allowed.json").at("options").at("more").at("allow-overlap"), "jaw.stl");
  EXPECT_EQ(run("check", {"--tolerance", "2.001"}).err, "");
}

TEST_F(SunkJaw, AllowingTheOverlapOfAFileThatIsNoFixtureIsAWrongCommandLine) {
  const Outcome ran = run("check", {"--allow-overlap", "part.stl"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("--allow-overlap 'part.stl': expected a file of --fixture"), std::string::npos) << ran.err;
}

TEST(SetUp, AResolutionAboveTheToleranceIsSaidWithItsNumbers) {
  const SmallShop shop;
  const std::string said =
      "path.apt: warning: the resolution of 0.05 mm is more than the tolerance of 0.01 mm: gouges up to 0.06 mm deep may "
      "stay unseen; give a finer --resolution [resolution-large]\n";
  EXPECT_NE(shop.check("a", path_text(stations()), {"--resolution", "0.05"}).err.find(said), std::string::npos);
  for (const std::vector<std::string>& fine :
       {std::vector<std::string>{"--resolution", "0.01"}, {"--tolerance", "0"}, {"--tolerance", "0.0005"}})
    EXPECT_EQ(shop.check("a", path_text(stations()), fine).err, "") << fine.back();
}

TEST(SetUp, AMisspelledShapeOfTheStockIsToldFromAFile) {
  const SmallShop shop;
  const auto error_of = [&](const std::string& stock) {
    return shop.check("a", path_text(stations()), {"--stock", stock}).err;
  };
  EXPECT_NE(error_of("boxx").find("; did you mean box? [usage]"), std::string::npos) << error_of("boxx");
  EXPECT_NE(error_of("raw.stl").find("[file-not-found]"), std::string::npos) << error_of("raw.stl");
  shop.write("boxx", plate_stl(1, 5));
  EXPECT_EQ(error_of("boxx").find("did you mean"), std::string::npos) << error_of("boxx");
}

TEST_F(SunkJaw, IsTheSameAtAnyNumberOfThreads) {
  EXPECT_EQ(run("check", {"--threads", "1"}).err, run("check", {"--threads", "3"}).err);
}

}  // namespace
}  // namespace gouge::testing_samples::setup_test
