#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/sealed_result.h"
#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"

// Heads beside remaining stock, as users see it.

namespace gouge::testing_samples::head_stock_test {
namespace {

using Json = nlohmann::json;

constexpr double kResolution_mm = 0.05;

/// The stock of `rapid_stock` reaches up to z = 0, and its slot is 5 mm deep.
class HeadStockSample : public testing::Test {
 protected:
  /// Opens the sample with a head beside the cutter, whose lower face is at this height above the tip.
  void open(double above_tip) {
    sample_ = open_sample("rapid_stock");
    write_text(sample_.path + "/head.stl",
               shapes::ascii_stl(shapes::box(Vec3(-3, -20, above_tip), Vec3(3, -7, above_tip + 30))));
  }
  [[nodiscard]] Outcome run(const std::string& command, const std::string& toolpath,
                            std::vector<std::string> more) const {
    more.insert(more.end(), {"--stock", "part+5", "--head", "head.stl"});
    return run_gougecheck(sample_.path, sample_.arguments(command, toolpath, more));
  }
  [[nodiscard]] Outcome check(const std::vector<std::string>& more) const {
    return run("check", sample_.toolpath(), more);
  }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text_of(sample_.path + "/" + file)); }

  SampleFolder sample_;
};

TEST_F(HeadStockSample, AHeadInUncutMaterialIsFound) {
  open(3);
  const Outcome ran = check({"--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_NE(ran.out.find("head in stock: "), std::string::npos) << ran.out;
  const Json report = json_of("check.json");
  const Json& feed = report.at("moves").at(0);
  EXPECT_EQ(feed.at("kind"), "feed");
  EXPECT_EQ(feed.at("witness").at("body"), "head");
  EXPECT_EQ(feed.at("witness").at("against"), "stock");
  EXPECT_LE(feed.at("depth").get<double>(), 2 + 1e-9);
  EXPECT_GE(feed.at("depth_upper").get<double>(), 2 - kResolution_mm);
  EXPECT_LE(feed.at("depth_upper").get<double>(), 2 + 4 * kResolution_mm);
}

TEST_F(HeadStockSample, AHeadAboveTheMaterialIsClear) {
  for (const double above_tip : {4.92, 12.0}) {
    open(above_tip);
    const Outcome ran = check({});
    EXPECT_EQ(ran.out.find("head in stock"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("stock: 6 of 7 moves"), std::string::npos) << ran.out;
  }
}

TEST_F(HeadStockSample, AllOutputsNameTheHead) {
  open(3);
  ASSERT_EQ(check({"--sarif", "r.sarif", "--junit", "r.xml", "--csv", "r.csv", "--report", "report"}).exit_status, 1);
  for (const char* file : {"r.sarif", "r.xml", "report/report.html"})
    EXPECT_NE(text_of(sample_.path + "/" + file).find("head in stock"), std::string::npos) << file;
  EXPECT_NE(text_of(sample_.path + "/r.csv").find(",head,stock,"), std::string::npos);
}

TEST_F(HeadStockSample, VerifyTestsItsWitness) {
  open(3);
  ASSERT_EQ(check({"--json", "check.json"}).exit_status, 1);
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "check.json"}).exit_status, 0);
  const auto verified = [&](const char* key, double more) {
    Json report = json_of("check.json");
    Json& move = report.at("moves").at(0);
    Json& value = std::string(key) == "depth" ? move.at("depth") : move.at("witness").at("point").at(2);
    value = value.get<double>() + more;
    write_text(sample_.path + "/claim.json", sealed(report));
    const Outcome ran = run_gougecheck(sample_.path, {"verify", "claim.json"});
    EXPECT_EQ(ran.exit_status, 1) << ran.out;
    return ran.out;
  };
  EXPECT_NE(verified("depth", -0.01).find("deep, and said to be"), std::string::npos);
  EXPECT_NE(verified("point", -0.3).find("deep, and said to be"), std::string::npos);
  EXPECT_NE(verified("point", 10).find("outside of the stock"), std::string::npos);
}

TEST_F(HeadStockSample, VerifyFindsMaterialInAHeadThatIsSaidToBeClear) {
  open(12);
  ASSERT_EQ(check({"--json", "check.json"}).exit_status, 1);
  Json report = json_of("check.json");
  // A head that reaches lower takes the place of the one that was checked.
  open(3);
  ASSERT_EQ(check({"--json", "lower.json"}).exit_status, 1);
  report.at("inputs") = json_of("lower.json").at("inputs");
  write_text(sample_.path + "/claim.json", sealed(report));
  const Outcome ran = run_gougecheck(sample_.path, {"verify", "claim.json"});
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find("deep in a head"), std::string::npos) << ran.out;
}

TEST_F(HeadStockSample, ACorrectionFreesTheHead) {
  open(3);
  const Outcome ran = run("correct", sample_.toolpath(), {"-o", "out.apt"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_EQ(run("check", "out.apt", {}).exit_status, 0);
}

TEST_F(HeadStockSample, TheResultIsTheSameAtAnyNumberOfThreads) {
  open(3);
  ASSERT_EQ(check({"--threads", "1", "--csv", "one.csv"}).exit_status, 1);
  ASSERT_EQ(check({"--threads", "3", "--csv", "three.csv"}).exit_status, 1);
  EXPECT_EQ(text_of(sample_.path + "/one.csv"), text_of(sample_.path + "/three.csv"));
}

}  // namespace
}  // namespace gouge::testing_samples::head_stock_test
