#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// The laws of all joints, limits and flips, on samples with the verdicts of their formulas.

namespace gouge::testing_samples::machine_laws_test {
namespace {

using Json = nlohmann::json;

class MachineSample : public testing::Test {
 protected:
  [[nodiscard]] Outcome run(const std::string& command, const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments(command, sample_.toolpath(), more));
  }
  [[nodiscard]] Outcome run_by_machine(const std::string& command, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"--machine", "machine.json"});
    more.insert(more.end(), machine_options_.begin(), machine_options_.end());
    return run(command, more);
  }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text_of(sample_.path + "/" + file)); }

  /// Checks by the machine and compares each finding with its formula; others are clean.
  void expect_formula() const {
    EXPECT_EQ(run("check", {}).exit_status, 0) << "clean as CL data";
    const Outcome ran = run_by_machine("check", {"--json", "check.json"});
    EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
    const Json report = json_of("check.json");
    std::size_t found = 0;
    for (const Json& move : report.at("moves")) {
      for (const Json& expected : sample_.expected.at("by_machine")) {
        if (move.at("line") != expected.at("line")) continue;
        ++found;
        EXPECT_EQ(move.at("state"), expected.at("state"));
        EXPECT_GE(move.at("depth_upper"), expected.at("depth_min"));
        EXPECT_GE(move.at("depth"), expected.at("depth_min"));
        EXPECT_LE(move.at("depth"), expected.at("depth_max"));
      }
    }
    EXPECT_EQ(found, sample_.expected.at("by_machine").size());
  }

  void expect_verified() const {
    const Outcome verified = run_gougecheck(sample_.path, {"verify", "check.json"});
    EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  }
  void expect_refuted(const std::string& from, const std::string& to) const {
    std::string changed = text_of(sample_.path + "/check.json");
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_text(sample_.path + "/changed.json", changed.replace(at, from.size(), to));
    const Outcome ran = run_gougecheck(sample_.path, {"verify", "changed.json"});
    EXPECT_EQ(ran.exit_status, 1) << from << " " << ran.out << ran.err;
  }
  /// Both moves are proved by the law of the machine, and the proof is none of another law.
  void expect_certified(const std::string& other_law) const {
    EXPECT_EQ(run_by_machine("check", {"--json", "check.json", "--certificate", "proofs.gcp"}).exit_status, 1);
    const Outcome verified = run_gougecheck(sample_.path, {"verify", "check.json", "--certificate", "proofs.gcp"});
    EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
    EXPECT_NE(verified.out.find("1 move proved clean"), std::string::npos) << verified.out;
    EXPECT_NE(verified.out.find("1 gouging move proved to be no deeper than said"), std::string::npos) << verified.out;
    EXPECT_EQ(run_by_machine("check", {"--json", "other.json", "--rapid-law", other_law}).exit_status, 0);
    const Outcome other = run_gougecheck(sample_.path, {"verify", "other.json", "--certificate", "proofs.gcp"});
    EXPECT_EQ(other.exit_status, 3);
    EXPECT_NE(other.err.find("expected the law of this result"), std::string::npos) << other.err;
  }
  void expect_corrected() const {
    const Outcome ran = run_by_machine("correct", {"-o", "out.apt", "--allow-stock", "100"});
    EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
    std::vector<std::string> words = {"--machine", "machine.json"};
    words.insert(words.end(), machine_options_.begin(), machine_options_.end());
    EXPECT_EQ(run_gougecheck(sample_.path, sample_.arguments("check", "out.apt", words)).exit_status, 0);
  }
  [[nodiscard]] Json fact(const std::string& name) const {
    const Json report = json_of("check.json");
    for (const Json& one : report.at("assumptions"))
      if (one.at("fact") == name) return one;
    return {};
  }

  SampleFolder sample_;
  std::vector<std::string> machine_options_;
};

class RapidJoints : public MachineSample {
 protected:
  RapidJoints() {
    sample_ = open_sample("rapid_joints");
    machine_options_ = {"--tool-length", "100"};
  }
};

TEST_F(RapidJoints, DipsAsDeepAsItsHeadSwings) {
  expect_formula();
  EXPECT_EQ(fact("motion-law").at("value"), "great-circle, rapids joint of swing head");
  EXPECT_NE(fact("motion-law").at("evidence").get<std::string>().find("--tool-length 100 mm"), std::string::npos);
  EXPECT_NEAR(json_of("check.json").at("moves").at(0).at("witness").at("t"), 0.5, 0.01);
}

TEST_F(RapidJoints, IsVerifiedByItsOwnLawAndRefutedByAnother) {
  EXPECT_EQ(run_by_machine("check", {"--json", "check.json"}).exit_status, 1);
  expect_verified();
  expect_refuted("\"tool-length\": \"100\"", "\"tool-length\": \"90\"");
  expect_refuted("\"machine\": \"machine.json\"", "\"machine\": \"machine.json\", \"rapid-law\": \"axis\"");
}

TEST_F(RapidJoints, IsProvedByACertificate) { expect_certified("axis"); }

TEST_F(RapidJoints, IsCorrectedByItsOwnLaw) { expect_corrected(); }

TEST_F(RapidJoints, IsCleanByALawThatKeepsTheTipOnItsLine) {
  for (const char* law : {"vector", "axis"})
    EXPECT_EQ(run_by_machine("check", {"--rapid-law", law}).exit_status, 0) << law;
}

TEST_F(RapidJoints, NeedsTheToolLengthAndThePlaceOfEachJoint) {
  machine_options_.clear();
  const Outcome ran = run_by_machine("check");
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("needs the length from the gauge point to the tip; expected --tool-length"), std::string::npos)
      << ran.err;
  const Outcome preset = run(
      "check", {"--machine", "preset:head-ca", "--feed-law", "joint", "--rapid-law", "joint", "--tool-length", "9"});
  EXPECT_EQ(preset.exit_status, 3);
  EXPECT_NE(preset.err.find("needs the place of joint C; expected \"point\" of this joint in a machine file"),
            std::string::npos)
      << preset.err;
}

TEST_F(RapidJoints, WrongWordsAreRefused) {
  const auto expect_usage = [&](const std::vector<std::string>& more, const std::string& text) {
    const Outcome ran = run_by_machine("check", more);
    EXPECT_EQ(ran.exit_status, 2) << text;
    EXPECT_NE(ran.err.find(text), std::string::npos) << ran.err;
  };
  expect_usage({"--feed-law", "independent"}, "--feed-law");
  expect_usage({"--rapid", "dogleg"}, "--rapid 'dogleg': expected straight or skip");
  const Outcome alone = run("check", {"--feed-law", "joint"});
  EXPECT_EQ(alone.exit_status, 2);
  EXPECT_NE(alone.err.find("expected --machine beside it"), std::string::npos) << alone.err;
}

class RapidIndependent : public MachineSample {
 protected:
  RapidIndependent() { sample_ = open_sample("rapid_independent"); }

  void change_machine(const std::string& from, const std::string& to) const {
    std::string machine = text_of(sample_.path + "/machine.json");
    const std::size_t at = machine.find(from);
    ASSERT_NE(at, std::string::npos);
    write_text(sample_.path + "/machine.json", machine.replace(at, from.size(), to));
  }
};

TEST_F(RapidIndependent, DipsWhereItsJointsArriveApart) {
  expect_formula();
  EXPECT_EQ(fact("motion-law").at("value"), "great-circle, rapids independent of own rates")
      << "although the axis turns nowhere";
  EXPECT_EQ(run("check", {"--rapid", "dogleg"}).exit_status, 0) << "at one speed for all axes";
}

TEST_F(RapidIndependent, IsVerifiedByItsOwnRatesAndRefutedByOthers) {
  EXPECT_EQ(run_by_machine("check", {"--json", "check.json"}).exit_status, 1);
  expect_verified();
  expect_refuted("\"machine\": \"machine.json\"", "\"machine\": \"machine.json\", \"rapid-law\": \"joint\"");
}

TEST_F(RapidIndependent, IsProvedByACertificate) { expect_certified("vector"); }

TEST_F(RapidIndependent, IsCorrectedByItsOwnLaw) { expect_corrected(); }

TEST_F(RapidIndependent, AJointWithoutARateLeavesItsRapidsUnchecked) {
  change_machine("\"direction\": [0, 0, 1], \"rate\": 6000", "\"direction\": [0, 0, 1]");
  const Outcome ran = run_by_machine("check", {"--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
  EXPECT_NE(text_of(sample_.path + "/check.json").find("the rate of joint Z is not in the machine file"),
            std::string::npos);
}

TEST_F(RapidIndependent, AFeedLawIsNeverIndependent) {
  change_machine("\"feed_law\": \"vector\"", "\"feed_law\": \"independent\"");
  const Outcome ran = run_by_machine("check");
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("feed_law"), std::string::npos) << ran.err;
}

class AxisLimit : public MachineSample {
 protected:
  AxisLimit() { sample_ = open_sample("axis_limit"); }
};

TEST_F(AxisLimit, IsNotChecked) {
  EXPECT_EQ(run("check", {}).exit_status, 0);
  const Outcome ran = run_by_machine("check");
  EXPECT_EQ(ran.exit_status, 4);
  EXPECT_NE(ran.err.find("joint B would be at 40 degrees; its limit is 35 degrees"), std::string::npos) << ran.err;
}

class AxisFlip : public MachineSample {
 protected:
  AxisFlip() { sample_ = open_sample("axis_flip"); }
};

TEST_F(AxisFlip, IsAWarningWithBothAngles) {
  EXPECT_EQ(run("check", {}).exit_status, 0);
  const Outcome ran = run_by_machine("check");
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("joint C turns by 90 degrees while the tool axis turns by 0.707 degrees"), std::string::npos)
      << ran.err;
}

}  // namespace
}  // namespace gouge::testing_samples::machine_laws_test
