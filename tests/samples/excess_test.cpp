#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Material left on the part, as users see it.

namespace gouge::testing_samples::excess_test {
namespace {

using Json = nlohmann::json;

constexpr double kResolution_mm = 0.05, kRadius_mm = 5;

class ExcessSample : public testing::Test {
 protected:
  void SetUp() override { sample_ = open_sample("excess_corner"); }
  [[nodiscard]] Outcome run(const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments("check", sample_.toolpath(), more));
  }
  [[nodiscard]] std::string text(const std::string& file) const { return text_of(sample_.path + "/" + file); }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text(file)); }

  SampleFolder sample_;
};

TEST_F(ExcessSample, TheMaterialInACornerIsMeasured) {
  EXPECT_EQ(run({"--stock", "box"}).exit_status, 0);
  const Outcome ran = run({"--stock", "box", "--excess", "0.1", "--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("part.stl: material left: "), std::string::npos) << ran.out;
  const Json report = json_of("check.json");
  EXPECT_EQ(report.at("verdict"), "material-left");
  EXPECT_EQ(report.at("exit_status"), 1);
  EXPECT_EQ(report.at("totals").at("clean"), report.at("totals").at("moves"));
  const Json& excess = report.at("excess");
  EXPECT_EQ(excess.at("asked"), 0.1);
  EXPECT_EQ(excess.at("resolution"), kResolution_mm);
  ASSERT_EQ(excess.at("places").size(), 1U);
  const Json& place = excess.at("places").at(0);
  const double exact = (1 - std::sqrt(0.5)) * kRadius_mm;
  EXPECT_LE(place.at("height").get<double>(), exact + 1e-9);
  EXPECT_GE(place.at("height").get<double>(), 0.9 * exact);
  EXPECT_GE(place.at("height_upper").get<double>(), exact - kResolution_mm);
  EXPECT_LE(place.at("height_upper").get<double>(), 1.1 * exact + kResolution_mm);
  EXPECT_EQ(place.at("part"), "part.stl");
  EXPECT_TRUE(place.at("unknown_move").is_null());
}

TEST_F(ExcessSample, LessThanAskedIsClean) {
  const Outcome ran = run({"--stock", "box", "--excess", "1.6", "--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out;
  EXPECT_NE(ran.out.find("excess: no more than 1.65 mm of material is left"), std::string::npos) << ran.out;
  EXPECT_TRUE(json_of("check.json").at("excess").at("places").empty());
}

TEST_F(ExcessSample, MotionsThatAreNotKnownLeaveItOpen) {
  std::string program = text(sample_.toolpath());
  const std::size_t fed = program.find("FEDRAT");
  ASSERT_NE(fed, std::string::npos);
  write_text(sample_.path + "/compensated.apt", program.insert(fed, "CUTCOM/LEFT\n"));
  const Outcome ran = run_gougecheck(sample_.path, {"check", "compensated.apt", "--part", "part.stl", "--tools",
                                                    "tools.json", "--stock", "box", "--excess", "0.1"});
  EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("material open: up to "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("whether material is left is open in "), std::string::npos) << ran.out;
}

TEST_F(ExcessSample, AllOutputsHaveThePlace) {
  ASSERT_EQ(run({"--stock", "box", "--excess", "0.1", "--sarif", "r.sarif", "--junit", "r.xml", "--report", "report"})
                .exit_status,
            1);
  for (const char* file : {"r.sarif", "r.xml", "report/report.html"})
    EXPECT_NE(text(file).find("1.45 mm to 1.645 mm"), std::string::npos) << file;
  EXPECT_NE(text("r.xml").find("<failure type=\"excess\""), std::string::npos);
}

TEST_F(ExcessSample, TheResultIsTheSameAtAnyNumberOfThreads) {
  for (const char* threads : {"1", "3"})
    ASSERT_EQ(
        run({"--stock", "box", "--excess", "0.05", "--threads", threads, "--json", std::string(threads) + ".json"})
            .exit_status,
        1);
  EXPECT_EQ(json_of("1.json").at("excess"), json_of("3.json").at("excess"));
}

TEST_F(ExcessSample, InchesAreReadBack) {
  ASSERT_EQ(run({"--stock", "box", "--excess", "0.1", "--json", "check.json"}).exit_status, 1);
  const Outcome compared = run_gougecheck(sample_.path, {"compare", "check.json", "check.json"});
  EXPECT_EQ(compared.exit_status, 0) << compared.err;
}

TEST_F(ExcessSample, WrongValuesAreRefused) {
  EXPECT_EQ(run({"--excess", "0.1"}).exit_status, 2);
  for (const char* wrong : {"0", "-1", "x", "0.0001"}) {
    const Outcome ran = run({"--stock", "box", "--excess", wrong});
    EXPECT_EQ(ran.exit_status, 2) << wrong;
    EXPECT_NE(ran.err.find("--excess"), std::string::npos) << ran.err;
  }
  EXPECT_EQ(run({"--stock", "box", "--excess", "0.02", "--stock-resolution", "0.04"}).exit_status, 2);
}

TEST_F(ExcessSample, AProjectFileAsksForIt) {
  write_text(sample_.path + "/gougecheck.json",
             R"({"part": "part.stl", "tools": "tools.json", "stock": "box", "excess": "0.1"})");
  EXPECT_EQ(run_gougecheck(sample_.path, {"check", sample_.toolpath()}).exit_status, 1);
  write_text(sample_.path + "/gougecheck.json",
             R"({"part": "part.stl", "tools": "tools.json", "stock": "box", "excess": "1.6"})");
  EXPECT_EQ(run_gougecheck(sample_.path, {"check", sample_.toolpath()}).exit_status, 0);
}

TEST_F(ExcessSample, ABatchHasTheVerdict) {
  write_text(sample_.path + "/jobs.json", R"({"jobs": [{"path": "excess_corner.apt", "part": "part.stl",
             "tools": "tools.json", "stock": "box", "excess": "0.1"}]})");
  const Outcome ran = run_gougecheck(sample_.path, {"batch", "jobs.json", "-o", "out"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("1 material-left"), std::string::npos) << ran.out;
}

TEST_F(ExcessSample, CompareJudgesTheMaterialThatIsLeft) {
  (void)run({"--stock", "box", "--json", "none.json", "-q"});
  (void)run({"--stock", "box", "--excess", "0.1", "--json", "left.json", "-q"});
  (void)run({"--stock", "box", "--excess", "1.6", "--json", "coarse.json", "-q"});
  const auto compared = [&](const char* before, const char* after) {
    return run_gougecheck(sample_.path, {"compare", before, after, "--json", "c.json"});
  };
  for (const auto& [before, after, change, status] : {std::tuple("coarse.json", "left.json", "new", 1),
                                                      {"none.json", "left.json", "new", 1},
                                                      {"left.json", "left.json", "same", 0},
                                                      {"left.json", "coarse.json", "not-checked-any-more", 4},
                                                      {"left.json", "none.json", "not-checked-any-more", 4}}) {
    const Outcome ran = compared(before, after);
    EXPECT_EQ(ran.exit_status, status) << before << after << ran.out;
    EXPECT_EQ(json_of("c.json").at("material_left").at("change"), change) << before << after;
    EXPECT_NE(ran.out.find("material left on the part: "), std::string::npos) << ran.out;
  }
  EXPECT_NE(compared("left.json", "none.json").out.find("note: --excess is not given, 0.1 before\n"),
            std::string::npos);
  EXPECT_EQ(compared("none.json", "coarse.json").exit_status, 0);
  EXPECT_TRUE(json_of("c.json").at("material_left").is_null());
}

TEST_F(ExcessSample, TheSarifOfABatchHasThePlacesOfItsJobs) {
  (void)run({"--stock", "box", "--excess", "0.1", "--sarif", "single.sarif", "-q"});
  (void)run_gougecheck(sample_.path,
                       sample_.arguments("batch", sample_.toolpath(),
                                         {"--stock", "box", "--excess", "0.1", "-o", "night", "--no-reports", "-q"}));
  const auto notes = [&](const char* file) {
    return json_of(file).at("runs").at(0).at("invocations").at(0).at("toolExecutionNotifications");
  };
  EXPECT_EQ(notes("night/findings.sarif"), notes("single.sarif"));
  EXPECT_EQ(notes("single.sarif").at(0).at("descriptor").at("id"), "material-left");
}

}  // namespace
}  // namespace gouge::testing_samples::excess_test
