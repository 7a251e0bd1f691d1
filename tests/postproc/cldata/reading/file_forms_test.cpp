// Files in forms that other versions of a CAM system write: read as what they are, or refused with one clear error.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "postproc/formats/read_toolpath.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/postproc/cldata/same_moves.h"

namespace gouge::file_forms_test {
namespace {

bool is_reported(const Toolpath& path, const std::string& code) {
  return std::any_of(path.notes.begin(), path.notes.end(), [&](const Diagnostic& note) { return note.code == code; });
}

std::size_t not_checked(const Toolpath& path) {
  return static_cast<std::size_t>(std::count_if(path.moves.begin(), path.moves.end(),
                                                [](const Move& move) { return !move.not_checked_reason.empty(); }));
}

std::string error_of(const std::string& text) {
  const ReadOutcome outcome = read_toolpath("test", text);
  if (outcome.toolpath) return "read";
  return outcome.errors.size() == 1 ? outcome.errors.front().code : "more than one error";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// Creo 9 and the same file as older ones write it.
TEST(Creo9, MeansWhatTheCommentsOfOlderFilesMean) {
  const std::string nine = bytes_of(corpus() / "creo9.ncl.1");
  const Toolpath path = path_of(nine);
  EXPECT_EQ(path.dialect, "apt-creo");
  EXPECT_EQ(not_checked(path), 0u) << "OUTPUT_ON_CENTER holds in both sequences";
  EXPECT_TRUE(path.words_not_understood.empty());
  EXPECT_TRUE(is_reported(path, "path-csys"));
  ASSERT_EQ(path.operations.size(), 2u);
  EXPECT_EQ(path.operations[0].name, "FEATNO 41");
  EXPECT_EQ(path.tools.at(0).stated_diameter_mm, 8);
  std::string older = replaced(replaced(nine, "REMARK *", "$$*"), "REMARK ->", "$$->");
  older = replaced(older, "    CAMERA/", "$$-> CSYS /");
  expect_same_moves(path, path_of(older));
}

TEST(Creo9, FeatnoBreaksTheMotionAndTheContourIsNotTheCentre) {
  const std::string text = bytes_of(corpus() / "creo9.ncl.1");
  const Toolpath path = path_of(text);
  const auto alone = std::count_if(path.moves.begin(), path.moves.end(), [](const Move& m) { return !m.has_start; });
  EXPECT_EQ(alone, 2);
  const Toolpath contour = path_of(replaced(text, "OUTPUT_ON_CENTER", "OUTPUT_ON_PROFILE"));
  EXPECT_EQ(not_checked(contour), contour.moves.size());
  EXPECT_EQ(contour.moves[0].not_checked_reason,
            "positions are the contour, not the cutter centre (OUTPUT_ON_PROFILE)");
}

TEST(Creo9, AMatrixThatIsNoneOrOfAnotherDialectIsNotPassedOver) {
  const std::string matrix = "CAMERA/ 1,0,0,5, 0,1,0,6, 0,0,1,7\n";
  const std::string motion = "GOTO / 0, 0, 0\nGOTO / 1, 0, 0\nFINI\n";
  const std::string head = "REMARK -> FEATNO / 1\nUNITS / MM\n";
  EXPECT_EQ(not_checked(path_of(head + matrix + motion)), 0u);
  EXPECT_EQ(not_checked(path_of(head + "CAMERA/ 1,0,0,5, 0,1,0,6, 0,0,-1,7\n" + motion)), 2u) << "mirrors";
  EXPECT_EQ(not_checked(path_of(head + "CAMERA/ 2,0,0,5, 0,1,0,6, 0,0,1,7\n" + motion)), 2u) << "scales";
  EXPECT_EQ(not_checked(path_of(head + "CAMERA/ 1,0,0,5, 0,1,0,6, 0,0,1\n" + motion)), 2u) << "eleven numbers";
  const Toolpath other = path_of("PARTNO A\nUNITS/MM\n" + matrix + motion);
  EXPECT_EQ(not_checked(other), 2u);
  EXPECT_TRUE(other.moves[0].not_checked_reason.ends_with("CAMERA in line 3"));
}

TEST(Creo9, PpwordGivesNoWordThatIsReadAnotherMeaning) {
  const std::string motion = "UNITS/MM\nGOTO/0,0,0\nGOTO/1,0,0\nFINI\n";
  for (const char* word :
       {"PPWORD/RETURN,7", "PPWORD/TLAXIS,3171", "PPWORD/CYCLE,1054", "PPWORD/RAPID,5", "PPWORD/FOO,12"}) {
    const Toolpath path = path_of(std::string(word) + "\n" + motion);
    EXPECT_EQ(not_checked(path), 0u) << word;
    EXPECT_TRUE(path.words_not_understood.empty()) << word;
  }
  for (const char* word : {"PPWORD/GOTO,5", "PPWORD/RAPID,1009", "PPWORD/MULTAX,72"}) {
    EXPECT_EQ(error_of(std::string(word) + "\n" + motion), "path-statement") << word;
  }
}

TEST(ClSetup, OneTurnedSetupIsTheFrameOfItsPositions) {
  const std::string text = bytes_of(corpus() / "camworks_setup.clt");
  const Toolpath path = path_of(text);
  EXPECT_EQ(not_checked(path), 0u);
  EXPECT_TRUE(is_reported(path, "path-setup"));
  EXPECT_NEAR(path.moves.back().end.tip.z(), 25, 1e-9);
  const auto deepest = std::min_element(path.moves.begin(), path.moves.end(),
                                        [](const Move& a, const Move& b) { return a.end.tip.z() < b.end.tip.z(); });
  EXPECT_NEAR(deepest->end.tip.z(), -13.5, 1e-9) << "the holes";
  EXPECT_TRUE(path_of(replaced(text, "TLAXIS/ 0.000000,-1.000000,0.000000", "TLAXIS/ 0.000000,0.000000,1.000000"))
                  .moves[0]
                  .not_checked_reason.starts_with("ROTABL and TLAXIS contradict"));
}

TEST(ClSetup, AnotherSetupThanTheFirstIsNotChecked) {
  const std::string head = "UNITS/ MM\nCUTTER/ 6\nOPFEATSTART/A\n";
  const std::string up = "TLAXIS/ 0,0,1\n", turned = "TLAXIS/ 0,-1,0\nROTABL/ 1.570796,AAXIS,TABLE,CCLW\n";
  const std::string back = "ROTABL/ -1.570796,AAXIS,TABLE,CCLW\n", other_way = "ROTABL/ 1.570796,AAXIS,TABLE,CLW\n";
  const std::string here = "GOTO/ 0,0,0\nGOTO/ 1,0,0\n";
  EXPECT_EQ(not_checked(path_of(head + up + here + turned + here + "FINI\n")), 2u);
  EXPECT_EQ(not_checked(path_of(head + turned + here + back + up + here + "FINI\n")), 2u);
  EXPECT_EQ(not_checked(path_of(head + turned + here + back + turned + here + "FINI\n")), 0u);
  EXPECT_EQ(not_checked(path_of(head + turned + here + other_way + up + here + "FINI\n")), 2u) << "turned back";
  EXPECT_EQ(not_checked(path_of(head + "TLAXIS/ 0,1,0\n" + other_way + here + "FINI\n")), 0u);
  EXPECT_EQ(not_checked(path_of(head + "TLAXIS/ 0,-1,0\n" + other_way + here + "FINI\n")), 2u) << "the wrong way";
  EXPECT_EQ(not_checked(path_of(head + "TLAXIS/ 0,-1,0\n" + here + "FINI\n")), 2u) << "not turned";
  EXPECT_EQ(not_checked(path_of(head + "ROTABL/ 1.570796,AAXIS,TABLE,CCLW\n" + here + "FINI\n")), 2u) << "no TLAXIS";
  const std::string next = "OPFEATEND/A\nOPFEATSTART/B\n";
  EXPECT_EQ(not_checked(path_of(head + turned + here + next + turned + here + "FINI\n")), 0u) << "left turned";
  EXPECT_EQ(not_checked(path_of(head + turned + here + next + here + "FINI\n")), 2u) << "which setup?";
  EXPECT_EQ(not_checked(path_of(head + turned + here + turned + here + "FINI\n")), 2u) << "by half a turn";
  EXPECT_EQ(not_checked(path_of(head + here + turned + here + "FINI\n")), 2u) << "the first one states nothing";
  EXPECT_EQ(not_checked(path_of(head + here + next + "TLAXIS/ 0,-1,0\n" + here + "FINI\n")), 2u) << "axis alone";
  const Toolpath path = path_of(head + up + here + turned + here + "FINI\n");
  EXPECT_EQ(path.moves[2].not_checked_reason,
            "positions are in another setup than those before: how the two lie to each other the file does not say: "
            "ROTABL in line 8");
}

TEST(Frames, PositionsBeforeTheFirstFrameAreNotChecked) {
  const std::string here = "GOTO/0,0,9\nGOTO/9,0,9\n";
  const auto catia = [](const std::string& z) {
    return "$$*CATIA0\n$$ X\n$$ 1 0 0 0\n$$ 0 1 0 0\n$$ 0 0 1 " + z + "\n";
  };
  const std::string head = "$$ CATIA APT\nUNITS/MM\nLOADTL/1\n";
  EXPECT_EQ(not_checked(path_of(head + here + catia("-3") + here + "END\n")), 2u);
  EXPECT_EQ(not_checked(path_of(head + here + catia("0") + here + "END\n")), 0u) << "the frame of the part";
  EXPECT_EQ(not_checked(path_of(head + catia("0") + here + catia("-3") + here + "END\n")), 0u) << "stated before";
  const std::string mori = "OPNAME/ A\nUNITS/MM\nLOADTL/1\n";
  EXPECT_EQ(
      not_checked(path_of(mori + here + "MCSYS/ NUM,1,POINT,0,0,-3,VECTOR,1,0,0,VECTOR,0,1,0\n" + here + "FINI\n")),
      2u);
}

TEST(ClSetup, TwoTurnsAreOneAfterTheOther) {
  const std::string head = "UNITS/ MM\nCUTTER/ 6\nOPFEATSTART/A\n";
  const std::string turns = "ROTABL/ 1.570796,CAXIS,TABLE,CCLW\nROTABL/ 1.570796,AAXIS,TABLE,CCLW\n";
  const std::string here = "GOTO/ 0,0,0\nFINI\n";
  // About z first: x becomes y, so that the turn about it takes z to +x.
  EXPECT_EQ(not_checked(path_of(head + "TLAXIS/ 1,0,0\n" + turns + here)), 0u);
  EXPECT_EQ(not_checked(path_of(head + "TLAXIS/ 0,-1,0\n" + turns + here)), 1u);
}

std::string holes(const std::string& cycles) {
  return "TOOL PATH/A,TOOL,B\nTLDATA/MILL,8,0,90,0,0\nMSYS/0,0,0,1,0,0,0,1,0\nLOAD/TOOL,4\nRAPID\nGOTO/0,0,60\n" +
         cycles + "CYCLE/OFF\nEND-OF-PATH\n";
}

double bottom_of(const Toolpath& path, double x) {
  double bottom = 1e9;
  for (const Move& move : path.moves) {
    if (std::abs(move.end.tip.x() - x) < 1e-9) bottom = std::min(bottom, move.end.tip.z());
  }
  return bottom;
}

TEST(NxCycles, ClearStandsInThePlaceOfRapto) {
  const Toolpath clear = path_of(holes("CYCLE/DRILL,DEEP,STEP,5,CLEAR,3,FEDTO,-12,RTRCTO,40,MMPM,180\nGOTO/10,0,0\n"));
  const Toolpath rapto = path_of(holes("CYCLE/DRILL,DEEP,STEP,5,RAPTO,3,FEDTO,-12,RTRCTO,40,MMPM,180\nGOTO/10,0,0\n"));
  EXPECT_EQ(not_checked(clear), 0u);
  expect_same_moves(clear, rapto);
  EXPECT_GT(not_checked(path_of(holes("CYCLE/DRILL,CLEAR,3,RAPTO,2,FEDTO,-12\nGOTO/10,0,0\n"))), 0u) << "which one?";
}

TEST(NxCycles, OnWithValuesTakesTheLastCycleUpWithThem) {
  const std::string first = "CYCLE/DRILL,CLEAR,3,FEDTO,-12,RTRCTO,40,MMPM,180\nGOTO/10,0,0\n";
  const Toolpath path = path_of(holes(first + "CYCLE/ON,FEDTO,-20,RTRCTO,50,MMPM,90\nGOTO/30,0,0\nGOTO/40,0,0\n"));
  EXPECT_EQ(not_checked(path), 0u);
  EXPECT_EQ(bottom_of(path, 10), -12);
  EXPECT_EQ(bottom_of(path, 30), -20);
  EXPECT_EQ(bottom_of(path, 40), -20);
  EXPECT_EQ(path.moves.back().end.tip.z(), 50);
  EXPECT_EQ(path.moves.at(path.moves.size() - 2).feed_mm, 90);
  const Toolpath again = path_of(
      holes(first + "CYCLE/OFF\nGOTO/20,0,60\nCYCLE/ON,RAPTO,1\nGOTO/30,0,0\nCYCLE/ON,FEDTO,-5\nGOTO/40,0,0\n"));
  EXPECT_EQ(not_checked(again), 0u);
  EXPECT_EQ(bottom_of(again, 30), -12);
  EXPECT_EQ(bottom_of(again, 40), -5) << "the change before it stays";
  for (const char* on :
       {"CYCLE/ON,FEDTO", "CYCLE/ON,-20", "CYCLE/ON,FEDTO,-20,FEDTO,-2", "CYCLE/ON,FOO,1", "CYCLE/ON,DEPTH,20"}) {
    EXPECT_GT(not_checked(path_of(holes(first + on + "\nGOTO/30,0,0\n"))), 0u) << on;
  }
  EXPECT_GT(not_checked(path_of(holes("CYCLE/ON,FEDTO,-20\nGOTO/30,0,0\n"))), 0u) << "no cycle before it";
  const Toolpath other = path_of(
      "PARTNO A\nUNITS/MM\nCUTTER/6\nGOTO/0,0,60\nCYCLE/DRILL,RAPTO,3,FEDTO,12\nGOTO/10,0,0\n"
      "CYCLE/ON,FEDTO,20\nGOTO/30,0,0\nCYCLE/OFF\nFINI\n");
  EXPECT_GT(not_checked(other), 0u) << "of other systems no document says what it means";
}

TEST(NxCycles, AnAutomaticRetractLeavesThePlungesChecked) {
  const Toolpath path =
      path_of(holes("CYCLE/DRILL,CLEAR,3,FEDTO,-12,RTRCTO,AUTO,MMPM,180\nGOTO/10,0,0\n"
                    "CYCLE/ON,FEDTO,-20,RTRCTO,AUTO\nGOTO/30,0,0\n"));
  EXPECT_EQ(bottom_of(path, 30), -20);
  std::size_t plunges = 0;
  for (const Move& move : path.moves) {
    if (move.end.tip.z() < 0 && move.not_checked_reason.empty()) ++plunges;
  }
  EXPECT_EQ(plunges, 2u);
}

TEST(NxArcs, TurnsThatTimesStatesEndAtAnotherLevel) {
  const std::string head = "TOOL PATH/A,TOOL,B\nTLDATA/MILL,8,0,90,0,0\nMSYS/0,0,0,1,0,0,0,1,0\n";
  const std::string circle = "CIRCLE/0,0,-4,0,0,-1,10,.06,.5,8,0,TIMES,3\n";
  const Toolpath path = path_of(head + "FEDRAT/MMPM,100\nGOTO/10,0,2\n" + circle + "GOTO/10,0,-4\nEND-OF-PATH\n");
  ASSERT_EQ(path.arcs.size(), 1u);
  EXPECT_NEAR(path.arcs[0].sweep_rad, -6 * 3.14159265358979, 1e-9);
  // Four decimals of an inch leave start and end 0.0036 mm apart.
  const Toolpath inch = path_of(
      head +
      "FEDRAT/IPM,10\nGOTO/.4,0,0\nCIRCLE/0,0,-.2,0,0,-1,.4,.002,.5,.3,0,TIMES,2\nGOTO/.4000,.0001,-.2\nEND-OF-PATH\n");
  EXPECT_EQ(not_checked(inch), 0u);
  const Toolpath part = path_of(head + "FEDRAT/MMPM,100\nGOTO/10,0,2\n" + circle + "GOTO/-10,0,-4\nEND-OF-PATH\n");
  EXPECT_EQ(not_checked(part), 3u) << "two and a half turns, there and back, or three and a half";
}

TEST(NccsWithoutHeader, IsReadAsTheFileWithIt) {
  const std::string with = bytes_of(corpus() / "nccs_binary.cl"), without = bytes_of(corpus() / "nccs_no_header.cl");
  const Toolpath path = path_of(without);
  EXPECT_EQ(path.dialect, "nccs-binary");
  expect_same_moves(path, path_of(with));
  EXPECT_NE(error_of(without.substr(0, 8)), "read");
  EXPECT_NE(error_of(std::string(288, '\0')), "read");
}

TEST(Gohome, WithNamesOfAxesIsNoPosition) {
  const Toolpath path =
      path_of("PARTNO A\nUNITS/MM\nCUTTER/6\nGOTO/0,0,60\nRAPID\nGOHOME / X, YAXIS, Z\nGOTO/50,0,60\nFINI\n");
  ASSERT_EQ(path.moves.size(), 2u);
  EXPECT_FALSE(path.moves[1].has_start);
  EXPECT_EQ(path.moves[1].kind, MoveKind::feed);
  EXPECT_EQ(not_checked(path), 0u);
  EXPECT_EQ(error_of("UNITS/MM\nGOTO/0,0,60\nGOHOME/Z,5\nFINI\n"), "path-number");
}

TEST(Refused, IsAFileWithoutAPositionThatIsUnderstood) {
  EXPECT_EQ(error_of("Part,Machine,Operation\nA-100,M4,rough\n1,20.5,30.0,4.5\nA-101,M4\n2,20.6,30.0,4.5\n"),
            "path-no-motion");
  EXPECT_EQ(error_of("X,Y,Z\n1.0,2.0,3.0\n1.5,2.0,3.0\n2.0,2.0,3.0\n"), "path-not-cl-data");
  EXPECT_EQ(error_of("PARTNO A\nUNITS/MM\nFOO/1,2,3\nFOO/2,2,3\nFINI\n"), "path-no-motion");
  EXPECT_EQ(error_of("TOOL PATH/A,TOOL,B\nTLDATA/MILL,8,0,90,0,0\nMOVE/1,2,3\nEND-OF-PATH\n"), "path-no-motion");
  const ReadOutcome outcome = read_toolpath("a.txt", "PARTNO A\nUNITS/MM\nFOO/1,2,3\nFOO/2,2,3\nFINI\n");
  EXPECT_TRUE(outcome.errors.front().message.starts_with("holds no position")) << outcome.errors.front().message;
}

TEST(Refused, IsAnArchiveAlsoIfItHoldsWordsOfADialect) {
  const std::string stored = std::string("PK\x03\x04") + "....a.cls" + "TOOL PATH/A,TOOL,B\nUNITS/MM\nGOTO/1,2,3\n";
  const ReadOutcome outcome = read_toolpath("a.zip", stored);
  ASSERT_FALSE(outcome.errors.empty());
  EXPECT_EQ(outcome.errors.front().code, "path-not-cl-data");
  EXPECT_EQ(outcome.errors.front().message, "is a ZIP archive; unpack it and check the toolpath in it");
}

TEST(Refused, IsAMacroOfAControl) {
  const std::string macro =
      "O9125\n(TILT MACRO)\nIF[#4016EQ69.5] GOTO 5\nG69.5\nN5\nG122.1 (SET RADIUS MODE)\n#120=#24 (X)\n#121=#25\n"
      "WHILE[#1LT5]DO1\nEND1\nM99\n";
  const ReadOutcome outcome = read_toolpath("9125.eia", macro);
  ASSERT_FALSE(outcome.errors.empty());
  EXPECT_EQ(outcome.errors.front().code, "path-not-cl-data") << to_text(outcome.errors.front());
  EXPECT_TRUE(outcome.errors.front().message.starts_with("looks like a program for a machine's control"));
}

TEST(Refused, AsAPartProgramIsOnlyWhatIsWrittenInApt) {
  EXPECT_EQ(error_of("# log\nU = [0.1, 0.2, 0.3]\nV = [1, 2, 3]\ncase 3\n"), "path-no-motion");
  EXPECT_EQ(error_of("time = 12.5\nload = 3\n"), "path-no-motion");

  EXPECT_EQ(error_of("D=.5\nPL1=PLANE/0,0,1,2\nGOTO/P1\n"), "path-part-program");
  EXPECT_EQ(error_of("D=.5\nGOTO/1,2,3\nGOTO/4,5,6\nFINI\n"), "path-part-program");
  EXPECT_EQ(error_of("PARTNO A\nP1=POINT/1,2,3\nFROM/P1\n"), "path-part-program");
}

}  // namespace
}  // namespace gouge::file_forms_test
