#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Corrections out of remaining stock, as users see them.

namespace gouge::testing_samples::correct_stock_test {
namespace {

using Json = nlohmann::json;

class CorrectStockSample : public testing::Test {
 protected:
  void open(const std::string& name) { sample_ = open_sample(name); }
  [[nodiscard]] Outcome correct(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"-o", "out.apt"};
    all.insert(all.end(), more.begin(), more.end());
    return run_gougecheck(sample_.path, sample_.arguments("correct", sample_.toolpath(), all));
  }
  [[nodiscard]] Outcome check(const std::string& toolpath, const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments("check", toolpath, more));
  }
  [[nodiscard]] std::string bytes(const std::string& file) const { return text_of(sample_.path + "/" + file); }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(bytes(file)); }

  SampleFolder sample_;
};

TEST_F(CorrectStockSample, ARapidGoesOverTheStock) {
  open("rapid_stock");
  const std::vector<std::string> stock{"--stock", "part+5"};
  const Outcome ran = correct({"--stock", "part+5", "--json", "correct.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("before gouges: 1 finding"), std::string::npos) << ran.out;
  const Outcome again = check("out.apt", stock);
  EXPECT_EQ(again.exit_status, 0) << again.out;
  EXPECT_EQ(check(sample_.toolpath(), stock).exit_status, 1);

  const Json correction = json_of("correct.json").at("correction");
  EXPECT_TRUE(correction.at("uncorrected").empty());
  ASSERT_EQ(correction.at("changes").size(), 2U);
  for (const Json& change : correction.at("changes")) {
    EXPECT_TRUE(change.at("is_inserted").get<bool>());
    EXPECT_EQ(change.at("cause").at("against"), "stock");
    EXPECT_EQ(change.at("cause").at("mesh"), nullptr);
    EXPECT_GT(change.at("cause").at("depth").get<double>(), 4);
  }
  // The stock reaches up to z = 0, and the rapid keeps the clearance of 1 mm from it.
  EXPECT_GE(correction.at("changes").at(0).at("shift").at(2).get<double>(), 6);
  EXPECT_LE(correction.at("changes").at(0).at("shift").at(2).get<double>(), 6.5);
}

TEST_F(CorrectStockSample, OnlyTheRapidThatMeetsStockDiffers) {
  open("rapid_stock");
  ASSERT_EQ(correct({"--stock", "part+5"}).exit_status, 0);
  const std::string before = bytes(sample_.toolpath()), after = bytes("out.apt");
  const std::size_t last = before.rfind("GOTO");
  ASSERT_NE(last, std::string::npos);
  EXPECT_EQ(after.substr(0, last), before.substr(0, last));
  EXPECT_EQ(after.substr(after.rfind("GOTO")), before.substr(last));
}

TEST_F(CorrectStockSample, WithoutStockTheFileStaysAsItIs) {
  open("rapid_stock");
  EXPECT_EQ(correct({}).exit_status, 0);
  EXPECT_EQ(bytes("out.apt"), bytes(sample_.toolpath()));
  EXPECT_EQ(correct({"--stock", "part.stl"}).exit_status, 0);
  EXPECT_EQ(bytes("out.apt"), bytes(sample_.toolpath()));
}

TEST_F(CorrectStockSample, ALargerClearanceLiftsTheRapidHigher) {
  open("rapid_stock");
  EXPECT_EQ(correct({"--stock", "part+5", "--rapid-clearance", "30", "--json", "correct.json"}).exit_status, 0);
  const Json changes = json_of("correct.json").at("correction").at("changes");
  ASSERT_FALSE(changes.empty());
  EXPECT_GE(changes.at(0).at("shift").at(2).get<double>(), 35);
  EXPECT_EQ(check("out.apt", {"--stock", "part+5"}).exit_status, 0);
  EXPECT_EQ(correct({"--stock", "part+5", "--rapid-clearance", "0"}).exit_status, 0);
  EXPECT_EQ(check("out.apt", {"--stock", "part+5"}).exit_status, 0);
}

TEST_F(CorrectStockSample, AHolderIsLiftedAndTheUncutStretchIsListed) {
  open("holder_stock");
  const Outcome ran = correct({"--stock", "box", "--json", "correct.json"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out;
  EXPECT_EQ(check("out.apt", {"--stock", "box"}).exit_status, 0);
  const Json correction = json_of("correct.json").at("correction");
  ASSERT_EQ(correction.at("uncut").at("stretches").size(), 1U);
  EXPECT_EQ(correction.at("uncut").at("stretches").at(0).at("kind"), "lifted");
  // The holder is 8 mm deep, so 8 mm stay on the floor. The lift may use the tolerance.
  EXPECT_NEAR(correction.at("stock").at(0).at("thickness").get<double>(), 8, 0.5);

  const Outcome less = correct({"--stock", "box", "--max-shift", "5", "--json", "correct.json"});
  EXPECT_EQ(less.exit_status, 1) << less.out;
  EXPECT_NE(less.out.find("not corrected: "), std::string::npos) << less.out;
  EXPECT_EQ(bytes("out.apt"), bytes(sample_.toolpath()));
}

TEST_F(CorrectStockSample, APlungeAtRapidIsListedWithItsReason) {
  open("rapid_stock");
  const std::string program = bytes(sample_.toolpath());
  const std::string rapid_back = "GOTO/ -40.00000, 30.00000, -5.00000, 0.0000000, 0.0000000, 1.0000000\n";
  const std::size_t at = program.find(rapid_back);
  ASSERT_NE(at, std::string::npos);
  write_text(sample_.path + "/" + sample_.toolpath(),
             program.substr(0, at) + "GOTO/ 40, 40, -4, 0, 0, 1\nGOTO/ 50, 40, -4, 0, 0, 1\nFINI\n");
  const Outcome ran = correct({"--stock", "part+5"});
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("only a feed may lead into material"), std::string::npos) << ran.out;
  EXPECT_EQ(bytes("out.apt"), bytes(sample_.toolpath()));
}

TEST_F(CorrectStockSample, TheResultIsTheSameAtAnyNumberOfThreads) {
  open("holder_stock");
  ASSERT_EQ(correct({"--stock", "box", "--threads", "1", "--csv", "one.csv"}).exit_status, 0);
  const std::string one = bytes("out.apt");
  ASSERT_EQ(correct({"--stock", "box", "--threads", "3", "--csv", "three.csv"}).exit_status, 0);
  EXPECT_EQ(bytes("out.apt"), one);
  EXPECT_EQ(bytes("one.csv"), bytes("three.csv"));
}

TEST_F(CorrectStockSample, TheReportShowsTheCauseAndTheStock) {
  open("rapid_stock");
  ASSERT_EQ(correct({"--stock", "part+5", "--report", "report"}).exit_status, 0);
  const std::string page = bytes("report/report.html");
  EXPECT_NE(page.find("cutter against stock<"), std::string::npos);
  EXPECT_NE(page.find("clear of remaining stock"), std::string::npos);
}

TEST_F(CorrectStockSample, AProjectFileNamesTheStock) {
  open("rapid_stock");
  write_text(sample_.path + "/gougecheck.json", R"({"part": "part.stl", "tools": "tools.json", "stock": "part+5"})");
  EXPECT_EQ(run_gougecheck(sample_.path, {"correct", sample_.toolpath(), "-o", "out.apt"}).exit_status, 0);
  EXPECT_NE(bytes("out.apt"), bytes(sample_.toolpath()));
}

TEST_F(CorrectStockSample, WhatItDoesNotCoverIsRefused) {
  open("rapid_stock");
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--stock", "box=x"}, std::vector<std::string>{"--stock-tolerance", "1"},
        std::vector<std::string>{"--stock", "box", "--stock-resolution", "0"}}) {
    const Outcome ran = correct(more);
    EXPECT_EQ(ran.exit_status, 2) << ran.err;
    EXPECT_NE(ran.err.find("--stock"), std::string::npos) << ran.err;
  }
  EXPECT_EQ(correct({"--stock", "missing.stl"}).exit_status, 3);
  EXPECT_EQ(run_gougecheck(sample_.path,
                           sample_.arguments("correct", sample_.toolpath(), {"-o", "part.stl", "--stock", "part.stl"}))
                .exit_status,
            2);
}

}  // namespace
}  // namespace gouge::testing_samples::correct_stock_test
