#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/samples/small_shop.h"

// Feeds with a stopped spindle: they remove no stock, so the whole tool must be clear of it.

namespace gouge::testing_samples::stopped_spindle_test {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kFound = "stopped cutter in stock: ";
const Words kStock = {"--stock", "box=5"};
constexpr const char* kTools =
    R"({"units": "mm", "tools": [{"number": 1, "cutter": {"shape": "flat", "diameter": 10, "length": 60}}]})";

/// A feed through the 5 mm of stock above the plate, behind `before`.
std::string slot(const std::string& before) {
  return std::string(kHead) + "RAPID\nGOTO/-20,50,20\nRAPID\nGOTO/-20,50,1\nFEDRAT/500,MMPM\n" + before +
         "GOTO/120,50,1\nSPINDL/OFF\nRAPID\nGOTO/120,50,20\nFINI\n";
}

class StoppedSpindle : public testing::Test {
 protected:
  void SetUp() override { shop_.write("tools.json", kTools); }

  SmallShop shop_;
};

TEST_F(StoppedSpindle, MeetsTheStockThatATurningCutterRemoves) {
  EXPECT_EQ(shop_.check("a", slot(""), kStock).exit_status, 0);
  EXPECT_EQ(shop_.check("b", slot("SPINDL/RPM,900,CLW\n"), kStock).exit_status, 0);
  const Outcome ran = shop_.check("c", slot("SPINDL/OFF\n"), kStock);
  EXPECT_EQ(ran.exit_status, 1);
  EXPECT_NE(ran.out.find(kFound), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("spindle stopped"), std::string::npos) << ran.out;
}

TEST_F(StoppedSpindle, IsNoFindingWithoutStockOnTheWay) {
  EXPECT_EQ(shop_.check("a", slot("SPINDL/OFF\n")).exit_status, 0);
  EXPECT_EQ(shop_.check("b", slot("SPINDL/OFF\n"), {"--stock", "part+0.5"}).exit_status, 0);
}

TEST_F(StoppedSpindle, LeavesTheStockThatItPasses) {
  std::string again = slot("SPINDL/OFF\n");
  again.replace(again.find("FINI"), 4, "RAPID\nGOTO/-20,50,20\nRAPID\nGOTO/-20,50,1\nRAPID\nGOTO/120,50,1\nFINI");
  EXPECT_EQ(shop_.check("a", again, kStock).exit_status, 1);
  EXPECT_EQ(shop_.json("a.json").at("moves").back().at("line"), 20) << "a rapid where no cutter has cut";
}

TEST_F(StoppedSpindle, IsStoppedByTextForTheControlAndInEitherReadingOfASkip) {
  for (const char* const stop :
       {"INSERT M5\n", "INSERT M05 M09\n", "INSERT M19\n", "SPINDL/ORIENT,30\n",
        "SPINDL/OFF\nOPSKIP/ON\nSPINDL/RPM,900,CLW\nOPSKIP/OFF\n", "OPSKIP/ON\nSPINDL/OFF\nOPSKIP/OFF\n"})
    EXPECT_EQ(shop_.check("a", slot(stop), kStock).exit_status, 1) << stop;
  for (const char* const start : {"INSERT M5\nINSERT M3 S900\n", "SPINDL/OFF\nSPINDL/ON\n", "SPINDL/OFF\nINSERT M13\n"})
    EXPECT_EQ(shop_.check("a", slot(start), kStock).exit_status, 0) << start;
}

TEST_F(StoppedSpindle, IsReadInProgramsOfEveryControl) {
  struct Case {
    const char *control, *head, *tail;
  };
  const std::vector<Case> cases = {
      {"linuxcnc", "G21 G90 G17 G94 G61\nT1 M6 G43 H1\nS900 M3\nG0 X-20 Y50 Z20\nG0 Z1\n",
       "G1 X120 F500\nG0 Z20\nM2\n"},
      {"haas", "%\nO1\nG21 G90 G17 G94\nT1 M6\nS900 M3\nG0 X-20. Y50. G43 H1 Z20.\nG0 Z1.\n",
       "G1 X120. F500.\nG0 Z20.\nM30\n%\n"},
      {"fanuc", "%\nO1\nG21 G90 G17 G94\nT1 M6\nS900 M3\nG0 X-20. Y50. G43 H1 Z20.\nG0 Z1.\n",
       "G1 X120. F500.\nG0 Z20.\nM30\n%\n"},
      {"siemens", "G71 G90 G17 G94 G54 G60 COMPOF\nT1 M6\nD1\nS900 M3\nG0 X-20 Y50 Z20\nG0 Z1\n",
       "G1 X120 F500\nG0 Z20\nM30\n"},
      {"heidenhain", "BEGIN PGM A MM\nTOOL CALL 1 Z S900\nM3\nL X-20 Y+50 Z+20 R0 FMAX\nL Z+1 R0 FMAX\n",
       "L X+120 R0 F500\nL Z+20 R0 FMAX\nM30\nEND PGM A MM\n"},
  };
  for (const auto& [control, head, tail] : cases) {
    const auto check = [&, control = control, head = head, tail = tail](const std::string& between) {
      shop_.write("path.nc", head + between + tail);
      return shop_.run({"check", "path.nc", "--part", "part.stl", "--tools", "tools.json", "--control", control,
                        "--tool-length", "60", "--stock", "box=5", "--assume", "complete"});
    };
    const Outcome running = check(""), stopped = check("M5\n"), started = check("M5\nM4\n");
    EXPECT_EQ(running.out.find(kFound), std::string::npos) << control << running.out;
    EXPECT_NE(stopped.out.find(kFound), std::string::npos) << control << stopped.out << stopped.err;
    EXPECT_EQ(stopped.exit_status, 1) << control;
    EXPECT_NE(check(control == std::string("heidenhain") ? "TOOL CALL S0\n" : "S0\n").out.find(kFound),
              std::string::npos)
        << control << " at a speed of 0";
    EXPECT_EQ(started.exit_status, running.exit_status) << control << started.out << started.err;
    EXPECT_EQ(started.out.find(kFound), std::string::npos) << control << started.out;
  }
}

TEST_F(StoppedSpindle, IsProvedCorrectedAndConverted) {
  Words words = kStock;
  words.insert(words.end(), {"--certificate", "a.proof"});
  ASSERT_EQ(shop_.check("a", slot("SPINDL/OFF\n"), words).exit_status, 1);
  const Outcome verified = shop_.run({"verify", "a.json", "--certificate", "a.proof"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;

  const Outcome corrected = shop_.run({"correct", "path.apt", "--part", "part.stl", "--tools", "tools.json", "--stock",
                                       "box=5", "-o", "corrected.apt"});
  EXPECT_EQ(corrected.exit_status, 0) << corrected.out << corrected.err;

  for (const char* const dialect : {"nx-clsf", "apt-creo", "apt-catia", "apt-solidworks-cam", "camworks-clt",
                                    "apt-autodesk", "apt-camplete", "apt-mori", "apt-nccs", "nccs-binary", "apt"}) {
    const Outcome converted = shop_.run({"path", "convert", "path.apt", "-o", "other.cl", "--to", dialect});
    ASSERT_EQ(converted.exit_status, 0) << dialect << converted.err;
    EXPECT_EQ(converted.err.find("convert-verify"), std::string::npos) << converted.err;
    const Outcome ran =
        shop_.run({"check", "other.cl", "--part", "part.stl", "--tools", "tools.json", "--stock", "box=5"});
    EXPECT_NE(ran.out.find(kFound), std::string::npos) << dialect << ran.out << ran.err;
  }
}

}  // namespace
}  // namespace gouge::testing_samples::stopped_spindle_test
