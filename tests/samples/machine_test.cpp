#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/samples/sealed_result.h"

// Machines: laws of motion, joints and limits, as users see them.

namespace gouge::testing_samples::machine_test {
namespace {

using Json = nlohmann::json;

const std::string kTrunnion = "preset:linuxcnc-xyzac-trt";

class PoleCrossing : public testing::Test {
 protected:
  [[nodiscard]] Outcome run(const std::string& command, const std::vector<std::string>& more) const {
    return run_gougecheck(sample_.path, sample_.arguments(command, sample_.toolpath(), more));
  }
  [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text_of(sample_.path + "/" + file)); }

  SampleFolder sample_ = open_sample("pole_crossing");
};

TEST_F(PoleCrossing, IsCleanOnTheGreatCircleAndAGougeOfTheFormulaByItsRotaryJoints) {
  EXPECT_EQ(run("check", {}).exit_status, 0);
  const Outcome ran = run("check", {"--machine", kTrunnion, "--json", "check.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  const Json report = json_of("check.json");
  const Json& move = report.at("moves").at(0);
  EXPECT_NEAR(move.at("depth"), 1, 1e-3);
  EXPECT_LE(move.at("depth").get<double>(), 1 + 1e-9);
  EXPECT_GE(move.at("depth_upper").get<double>(), 1 - 1e-9);
  EXPECT_NEAR(move.at("witness").at("t"), 0.5, 0.02);
  EXPECT_EQ(report.at("options").at("more").at("machine"), kTrunnion);
  for (const Json& fact : report.at("assumptions")) {
    if (fact.at("fact") != "motion-law") continue;
    EXPECT_EQ(fact.at("state"), "stated");
    EXPECT_EQ(fact.at("value"), "axis of linuxcnc-xyzac-trt");
    EXPECT_NE(fact.at("evidence").get<std::string>().find("LinuxCNC"), std::string::npos);
  }
}

TEST_F(PoleCrossing, TheLawOfTheCommandLineGoesBeforeThatOfTheControl) {
  EXPECT_EQ(run("check", {"--machine", kTrunnion, "--feed-law", "vector"}).exit_status, 0);
  EXPECT_EQ(run("check", {"--machine", "preset:haas-umc750", "--feed-law", "axis", "--rapid-law", "axis"}).exit_status,
            1);
}

TEST_F(PoleCrossing, AControlThatPromisesNoLawNeedsOneForRapids) {
  const Outcome ran = run("check", {"--machine", "preset:haas-umc750"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("promises no law for rapids; expected --rapid-law vector, axis"), std::string::npos)
      << ran.err;
}

TEST_F(PoleCrossing, IsCorrectedByItsOwnLaw) {
  const Outcome ran = run("correct", {"--machine", kTrunnion, "-o", "out.apt", "--allow-stock", "100"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  EXPECT_EQ(run_gougecheck(sample_.path, sample_.arguments("check", "out.apt", {"--machine", kTrunnion})).exit_status,
            0);
}

TEST_F(PoleCrossing, AResultIsVerifiedByItsOwnLawAndRefutedByAnother) {
  EXPECT_EQ(run("check", {"--machine", kTrunnion, "--json", "check.json"}).exit_status, 1);
  const Outcome verified = run_gougecheck(sample_.path, {"verify", "check.json"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  const std::string text = text_of(sample_.path + "/check.json");
  const auto refuted = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_text(sample_.path + "/changed.json", changed.replace(at, from.size(), to));
    const Outcome ran = run_gougecheck(sample_.path, {"verify", "changed.json"});
    EXPECT_EQ(ran.exit_status, 1) << from << " " << ran.out << ran.err;
  };
  refuted("\"machine\": \"" + kTrunnion + "\"", "\"feed-law\": \"vector\"");
  refuted("\"t\": 0.5", "\"t\": 0.4");
  refuted("\"depth\": 0.99", "\"depth\": 1.00");
}

TEST_F(PoleCrossing, ItsCertificateProvesTheMotionOfItsJoints) {
  EXPECT_EQ(run("check", {"--machine", kTrunnion, "--json", "check.json", "--certificate", "proofs.gcp"}).exit_status,
            1);
  const Outcome verified = run_gougecheck(sample_.path, {"verify", "check.json", "--certificate", "proofs.gcp"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  EXPECT_NE(verified.out.find("1 gouging move proved to be no deeper than said"), std::string::npos) << verified.out;
}

TEST_F(PoleCrossing, ACleanResultByTheWrongLawIsRefutedByItsMachine) {
  EXPECT_EQ(run("check", {"--json", "clean.json"}).exit_status, 0);
  std::string text = text_of(sample_.path + "/clean.json");
  const std::string more = "\"more\": {}";
  const std::size_t at = text.find(more);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, more.size(), "\"more\": {\"machine\": \"" + kTrunnion + "\"}");
  write_text(sample_.path + "/claimed.json", sealed(nlohmann::json::parse(text)));
  EXPECT_EQ(run_gougecheck(sample_.path, {"verify", "claimed.json"}).exit_status, 1);
}

TEST_F(PoleCrossing, AnAcceptanceByOneLawIsVoidByAnotherAndNothingIsGone) {
  EXPECT_EQ(run("check", {"--machine", kTrunnion, "--json", "axis.json"}).exit_status, 1);
  const std::string& folder = sample_.path;
  EXPECT_EQ(run_gougecheck(folder, {"accept", "axis.json", "--finding", "1", "--reason", "meant", "--by", "us", "-o",
                                    "accepted.json"})
                .exit_status,
            0);
  EXPECT_EQ(run("check", {"--machine", kTrunnion, "--baseline", "accepted.json"}).exit_status, 0);
  const Outcome other = run("check", {"--machine", "preset:haas-umc750", "--feed-law", "axis", "--rapid-law", "axis",
                                      "--baseline", "accepted.json"});
  EXPECT_EQ(other.exit_status, 1);
  EXPECT_NE(other.out.find("the machine, or its law of motion, is another one"), std::string::npos) << other.out;
  EXPECT_EQ(run("check", {"--json", "vector.json"}).exit_status, 0);
  const Outcome compared = run_gougecheck(folder, {"compare", "axis.json", "vector.json"});
  EXPECT_EQ(compared.exit_status, 4) << compared.out;
  EXPECT_NE(compared.out.find("the machine, or its law of motion, is another one"), std::string::npos) << compared.out;
}

TEST_F(PoleCrossing, TheGapOfTheLawsIsTheFormula) {
  const Outcome ran = run_gougecheck(sample_.path, {"path", "laws", sample_.toolpath(), "--machine", kTrunnion});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  // 10 degrees against atan(tan 10 cos 45) = 7.1071.
  EXPECT_NE(ran.out.find("2.8929 deg, 5.0486 mm at 100 mm, line 7"), std::string::npos) << ran.out;
}

TEST_F(PoleCrossing, ALimitLeavesItsMovesUnchecked) {
  std::string machine = run_gougecheck(sample_.path, {"machine", "show", kTrunnion}).out;
  EXPECT_NE(machine.find("from -100 to 50 deg"), std::string::npos) << machine;
  write_text(sample_.path + "/stiff.json", R"({"name": "stiff", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true},
    {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0], "min": -5, "max": 5},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
    "control": {"name": "any", "feed_law": "axis", "rapid_law": "axis"}})");
  const Outcome ran = run("check", {"--machine", "stiff.json"});
  EXPECT_EQ(ran.exit_status, 4) << ran.out;
  EXPECT_NE(ran.err.find("joint A would be at"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("its limit is"), std::string::npos) << ran.err;
}

// The control turns both joints against ISO 841.
TEST_F(PoleCrossing, ItsJointsAreThoseOfTheFormula) {
  const Outcome ran =
      run_gougecheck(sample_.path, {"path", "joints", sample_.toolpath(), "--machine", kTrunnion, "--csv", "-"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(ran.out.rfind("move,line,kind,C,A,X,Y,Z\n", 0), 0U) << ran.out;
  EXPECT_NE(ran.out.find(",-45.000000,-9.99999"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(",-135.000000,-9.99999"), std::string::npos) << ran.out;
}

TEST(MachineCommand, ListsPresetsAndNamesThemWhereOneIsMissing) {
  const std::string folder = fresh_folder();
  const Outcome listed = run_gougecheck(folder, {"machine", "list"});
  EXPECT_EQ(listed.exit_status, 0);
  for (const char* name :
       {"linuxcnc-xyzac-trt", "linuxcnc-xyzbc-trt", "haas-umc750", "table-b-head", "head-ca", "nutating-45"}) {
    EXPECT_NE(listed.out.find(name), std::string::npos) << listed.out;
    EXPECT_EQ(run_gougecheck(folder, {"machine", "show", "preset:" + std::string(name)}).exit_status, 0) << name;
  }
  const Outcome wrong = run_gougecheck(folder, {"machine", "show", "preset:dmu"});
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_NE(wrong.err.find("haas-umc750"), std::string::npos) << wrong.err;
}

TEST_F(PoleCrossing, AnUndecidedTurnIsNotChecked) {
  // From the pole the tool leans sideways: A may turn either way, with C by 90 degrees the one or the other way.
  write_text(sample_.path + "/tie.apt",
             "UNITS/MM\nLOADTL/1\nMULTAX/ON\nGOTO/0,0,100,0,0,1\nGOTO/0,0,100,0.6,0,0.8\nFINI\n");
  std::vector<std::string> words = sample_.arguments("check", "tie.apt", {"--machine", kTrunnion});
  const Outcome ran = run_gougecheck(sample_.path, words);
  EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("another way that is equally near"), std::string::npos) << ran.err;
}

TEST(MachineCommand, ATypedToolLengthIsAlwaysOne) {
  const std::string folder = fresh_folder();
  write_text(folder + "/up.apt", "UNITS/MM\nGOTO/0,0,10\nFINI\n");
  write_text(folder + "/head.json", R"({"name": "head", "joints": [
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]},
    {"name": "C", "type": "rotary", "side": "head", "direction": [0, 0, 1], "continuous": true},
    {"name": "A", "type": "rotary", "side": "head", "direction": [1, 0, 0]}],
    "control": {"name": "any"}})");
  const std::vector<std::string> words = {"path", "joints", "up.apt", "--machine", "head.json", "--csv", "-"};
  EXPECT_EQ(run_gougecheck(folder, words).exit_status, 2);
  std::vector<std::string> typed = words;
  typed.insert(typed.end(), {"--tool-length", "100"});
  const Outcome ran = run_gougecheck(folder, typed);
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
}

TEST(MachineCommand, AJointIsContinuousOrHasLimits) {
  const std::string folder = fresh_folder();
  write_text(folder + "/both.json", R"({"name": "both", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true, "min": -10, "max": 10},
    {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0]},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
    "control": {"name": "any"}})");
  const Outcome ran = run_gougecheck(folder, {"machine", "show", "both.json"});
  EXPECT_EQ(ran.exit_status, 3);
  EXPECT_NE(ran.err.find("joint C is continuous and has limits"), std::string::npos) << ran.err;
}

TEST(MachineCommand, ReadsAConfigurationOfLinuxCnc) {
  const std::string folder = fresh_folder();
  const std::string axes =
      "[AXIS_B]\nMIN_LIMIT = -30\n MAX_LIMIT=110\nMAX_VELOCITY = 20\n[AXIS_C]\n[AXIS_X]\nMAX_LIMIT = 10\n";
  const auto ini = [&](const std::string& directions) {
    return "# a comment\n[KINS]\nKINEMATICS = xyzbc-trt-kins sparm=identityfirst\n[TRAJ]\nLINEAR_UNITS = inch\n" +
           axes + directions;
  };
  const std::string pin = "[HAL]\nHALCMD = setp xyzbc-trt-kins.conventional-directions ";
  write_text(folder + "/trt.ini", ini(pin + "1\n"));
  const Outcome shown = run_gougecheck(folder, {"machine", "show", "trt.ini"});
  EXPECT_EQ(shown.exit_status, 0) << shown.err;
  EXPECT_NE(shown.out.find("table, about (0, 1, 0), from -30 to 110 deg, 1200 deg/min"), std::string::npos)
      << shown.out;
  EXPECT_NE(shown.out.find("along (1, 0, 0), from ? to 254 mm"), std::string::npos) << shown.out;
  EXPECT_NE(shown.err.find("trt.ini: warning: there is no section [AXIS_Y], [AXIS_Z], so"), std::string::npos)
      << shown.err;
  write_text(folder + "/opposite.ini", ini(pin + "0\n"));
  const Outcome opposite = run_gougecheck(folder, {"machine", "show", "opposite.ini"});
  EXPECT_NE(opposite.out.find("about (0, -1, 0), from -30 to 110 deg"), std::string::npos) << opposite.out;
  write_text(folder + "/unstated.ini", ini(""));
  const Outcome unstated = run_gougecheck(folder, {"machine", "show", "unstated.ini"});
  EXPECT_EQ(unstated.exit_status, 3);
  EXPECT_NE(unstated.err.find("no HALCMD states the rotary directions"), std::string::npos) << unstated.err;
  write_text(folder + "/other.ini", "[KINS]\nKINEMATICS = 5axiskins\n");
  const Outcome other = run_gougecheck(folder, {"machine", "show", "other.ini"});
  EXPECT_EQ(other.exit_status, 3);
  EXPECT_NE(other.err.find("other.ini:2: error: KINEMATICS is '5axiskins'"), std::string::npos) << other.err;
  write_text(folder + "/bad.ini",
             "[KINS]\nKINEMATICS = xyzac-trt-kins\n[TRAJ]\nLINEAR_UNITS = mm\n[AXIS_A]\nMIN_LIMIT = low\n"
             "[HAL]\nHALCMD = setp xyzac-trt-kins.conventional-directions 0\n");
  const Outcome bad = run_gougecheck(folder, {"machine", "show", "bad.ini"});
  EXPECT_NE(bad.err.find("bad.ini:6: error: MIN_LIMIT is 'low'"), std::string::npos) << bad.err;
}

TEST(MachineCommand, AWrongFileIsRefusedWithItsLineAndField) {
  const std::string folder = fresh_folder();
  const struct {
    const char *text, *expected;
  } cases[] = {{"{\"name\": \"m\",\n \"joints\": 3}", "m.json:2: error: "},
               {"{\"name\": \"m\",\n \"joints\": [],\n \"speed\": 1}", "m.json:3: error: "},
               {"{\"name\": \"m\",\n \"joints\": []}", "expected three linear and two rotary ones"},
               {"{", "m.json:1: error: "},
               {"[]", "this is not an object"}};
  for (const auto& one : cases) {
    write_text(folder + "/m.json", one.text);
    const Outcome ran = run_gougecheck(folder, {"machine", "show", "m.json"});
    EXPECT_EQ(ran.exit_status, 3) << one.text;
    EXPECT_NE(ran.err.find(one.expected), std::string::npos) << one.text << "\n" << ran.err;
  }
}

}  // namespace
}  // namespace gouge::testing_samples::machine_test
