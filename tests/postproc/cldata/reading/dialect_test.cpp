#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/toolpath_format.h"
#include "postproc/gcode/running/program_setup.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::dialect_test {
namespace {

Toolpath sample(const std::string& name) { return path_of(bytes_of(corpus() / name)); }

TEST(Dialect, EverySampleIsRecognisedByItsContent) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"nx-clsf.cls", "nx-clsf"},       {"catia.aptsource", "apt-catia"},
      {"creo.ncl.1", "apt-creo"},       {"solidworks_cam.apt", "apt-solidworks-cam"},
      {"camworks.clt", "camworks-clt"}, {"autodesk.apt", "apt-autodesk"},
      {"camplete.apt", "apt-camplete"}, {"mori.apt", "apt-mori"},
      {"nccs.as", "apt-nccs"},          {"nccs_binary.cl", "nccs-binary"},
      {"generic.apt", "apt"},           {"goto_list.txt", "goto-list"},
      {"sample.nci", "mastercam-nci"},  {"five_axis.nci", "mastercam-nci"}};
  for (const auto& [file, dialect] : expected) EXPECT_EQ(sample(file).dialect, dialect) << file;
}

TEST(Dialect, IsTheOneTheUserNames) {
  ReadOptions options;
  options.dialect = dialect_called("CREO");
  ASSERT_TRUE(options.dialect);
  const ReadOutcome outcome = read_toolpath("a.apt", "GOTO/1,2,3\nGOTO/4,5,6\n", options);
  ASSERT_TRUE(outcome.toolpath);
  EXPECT_EQ(outcome.toolpath->dialect, "apt-creo");
  EXPECT_FALSE(dialect_called("fanuc"));
}

TEST(Dialect, WordsInFreeTextShowNothing) {
  EXPECT_EQ(path_of("PPRINT made from a CATIA APT VERSION 1.0 file\nGOTO/1,2,3\n").dialect, "apt");
}

// ust_a2.cls: the frame of a block is a left turn of the part's; a position of it in part coordinates.
TEST(Frames, MsysOfNxIsAppliedToPointsAndAxes) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\n"
      "MSYS/-120.2591,-1196.5000,142.5000,0.0000000,1.0000000,0.0000000,1.0000000,0.0000000,0.0000000\n"
      "GOTO/0.0000,222.6719,-177.5000,0.0000000,0.0000000,-1.0000000\nEND-OF-PATH\n");
  ASSERT_EQ(path.moves.size(), 1u);
  expect_vector(path.moves[0].end.tip, -120.2591 + 222.6719, -1196.5, 142.5 + 177.5, 1e-9);
  expect_vector(path.moves[0].end.axis, 0, 0, 1);
}

TEST(Frames, MatrixOfCatiaIsAppliedAndItsTurnBreaksTheMotion) {
  const Toolpath path = path_of(
      "$$ CATIA APT VERSION 1.0\n$$*CATIA0\n$$ A\n$$ 1.0 0.0 0.0 -220.0\n$$ 0.0 1.0 0.0 -170.0\n$$ 0.0 0.0 1.0 20.0\n"
      "GOTO/98,100,120\nGOTO/99,100,120\n"
      "$$*CATIA0\n$$ B\n$$ 1.0 0.0 0.0 0.0\n$$ 0.0 -1.0 0.0 0.0\n$$ 0.0 0.0 -1.0 0.0\nGOTO/1,2,3\nEND\n");
  ASSERT_EQ(path.moves.size(), 3u);
  expect_vector(path.moves[0].end.tip, -122, -70, 140);
  EXPECT_TRUE(path.moves[1].has_start);
  expect_vector(path.moves[2].end.tip, 1, -2, -3);
  expect_vector(path.moves[2].end.axis, 0, 0, -1);
  EXPECT_FALSE(path.moves[2].has_start) << "the machine turns in between";
}

TEST(Frames, McsOfCampleteIsApplied) {
  const Toolpath path = sample("camplete.apt");
  ASSERT_GE(path.moves.size(), 1u);
  expect_vector(path.moves[0].end.tip, 10 + 3, 20 + 1, 30 + 2, 1e-9);
  expect_vector(path.moves[0].end.axis, 1, 0, 0);
  EXPECT_TRUE(path.moves[0].not_checked_reason.empty());
}

TEST(Frames, McsysOfMoriIsApplied) {
  const std::string head = "BEGIN\nUNITS/ MM\nOPNAME/ 'A'\n";
  const Toolpath path =
      path_of(head +
              "MCSYS/ NUM, 2, POINT, 10, 20, 30, VECTOR, 0, 1, 0, VECTOR, 0, 0, 1\nGOTO/ 1, 2, 3\n"
              "MCSYS/ NUM, 1, POINT, 0, 0, 0, VECTOR, 1, 0, 0, VECTOR, 0, 1, 0\nGOTO/ 1, 2, 3\nEND/\n");
  ASSERT_EQ(path.moves.size(), 2u);
  expect_vector(path.moves[0].end.tip, 10 + 3, 20 + 1, 30 + 2);
  expect_vector(path.moves[0].end.axis, 1, 0, 0);
  expect_vector(path.moves[1].end.tip, 1, 2, 3);
  EXPECT_FALSE(path.moves[1].has_start) << "the machine turns in between";
  for (const Move& move : path.moves) EXPECT_TRUE(move.not_checked_reason.empty());
  const Toolpath other = path_of(head + "MCSYS/ NUM, 2, POINT, 10, 20, 30\nGOTO/ 1, 2, 3\nEND/\n");
  EXPECT_FALSE(other.moves.at(0).not_checked_reason.empty());
}

TEST(Frames, CsysOfCreoIsReportedAndNotApplied) {
  const Toolpath path = sample("creo.ncl.1");
  expect_vector(path.moves[0].end.tip, -7.2290790757, -23, 2);
  EXPECT_TRUE(path.moves[0].not_checked_reason.empty());
  const bool is_reported =
      std::any_of(path.notes.begin(), path.notes.end(), [](const Diagnostic& d) { return d.code == "path-csys"; });
  EXPECT_TRUE(is_reported);
}

TEST(Frames, CsysOfSolidWorksIsNotApplied) {
  expect_vector(sample("solidworks_cam.apt").moves[0].end.tip, -38.637201, -8.8, 247.043872);
}

TEST(Frames, AMatrixThatMirrorsIsRefused) {
  const ReadOutcome outcome = read_toolpath(
      "a", "$$ CATIA APT VERSION 1.0\n$$*CATIA0\n$$ A\n$$ 1 0 0 0\n$$ 0 1 0 0\n$$ 0 0 -1 0\nGOTO/1,2,3\nEND\n");
  ASSERT_FALSE(outcome.toolpath);
  EXPECT_EQ(outcome.errors.front().code, "path-frame");
}

TEST(Frames, TransAndOriginMakeTheirMovesNotChecked) {
  for (const std::string word : {"TRANS/0,0,5", "ORIGIN/1,2,3", "ROTABL/90,AAXIS", "TRACUT/1,0,0,0,0,1,0,0,0,0,1,0"}) {
    const Toolpath path = path_of("UNITS/MM\n" + word + "\nGOTO/1,2,3\n");
    ASSERT_EQ(path.moves.size(), 1u);
    EXPECT_FALSE(path.moves[0].not_checked_reason.empty()) << word;
  }
  EXPECT_TRUE(path_of("TRANS/0,0,0\nGOTO/1,2,3\n").moves[0].not_checked_reason.empty());
}

TEST(Unknown, AWordIsAMoveThatIsNotCheckedAndSoIsAllThatFollows) {
  for (const std::string word : {"MOVETO/4,5,6", "FLIP", "WHEEL/2"}) {
    const Toolpath path = path_of("UNITS/MM\nGOTO/1,2,3\n" + word + "\nGOTO/7,8,9\nGOTO/8,8,9\n");
    ASSERT_EQ(path.moves.size(), 4u) << word;
    EXPECT_TRUE(path.moves[0].not_checked_reason.empty());
    EXPECT_FALSE(path.moves[2].has_start);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(path.moves[i].not_checked_reason.empty()) << word << i;
    EXPECT_EQ(path.words_not_understood.size(), 1u);
  }
}

TEST(Unknown, AWordIsNamedAsItStands) {
  const Toolpath path = path_of("UNITS/MM\nGOTO/1,2,3\n\xe5\x88\x87\xe5\x89\x8a\nGOTO/7,8,9\n");
  EXPECT_EQ(path.words_not_understood.at("\xe5\x88\x87\xe5\x89\x8a"), 1u);
  EXPECT_NE(path.moves[1].not_checked_reason.find("\xe5\x88\x87\xe5\x89\x8a"), std::string_view::npos);
}

Toolpath path_with(const std::string& text, std::vector<std::string> harmless_words) {
  ReadOptions options;
  options.harmless_words = std::move(harmless_words);
  ReadOutcome outcome = read_toolpath("a", text, options);
  return outcome.toolpath ? std::move(*outcome.toolpath) : Toolpath{};
}

TEST(Unknown, AWordThatWasDeclaredHarmlessIsPassedOverAndCounted) {
  const std::string text = "UNITS/MM\nGOTO/1,2,3\nwheel/2,-5,7\n\xe5\x88\x87\nGOTO/7,8,9\n";
  const Toolpath path = path_with(text, {"WHEEL", "\xe5\x88\x87"});
  ASSERT_EQ(path.moves.size(), 2u);
  EXPECT_TRUE(path.moves[1].not_checked_reason.empty());
  EXPECT_TRUE(path.words_not_understood.empty());
  const auto is_note = [](const Diagnostic& note) { return note.code == "path-harmless-words" && note.line == 3; };
  EXPECT_TRUE(std::ranges::any_of(path.notes, is_note));
  EXPECT_EQ(format_of(path).records(path)->of_move.size(), 2u) << "writers read it in the same way";
  EXPECT_EQ(path_with(text, {"WHEEL"}).moves.size(), 3u) << "the other word is none";
}

TEST(Unknown, AWordThatWasDeclaredHarmlessHidesNoStatement) {
  const Toolpath path = path_with("UNITS/MM\nGOTO/1,2,3\nWHEEL/2 INSERT G92 Z0\nGOTO/7,8,9\n", {"WHEEL"});
  EXPECT_FALSE(path.moves.back().not_checked_reason.empty());
}

TEST(Unknown, AWordWithAMatrixMakesAllThatFollowsNotChecked) {
  const Toolpath path = path_of("UNITS/MM\nGOTO/1,2,3\nWCS/1,0,0,0,0,1,0,0,0,0,1,5\nGOTO/7,8,9\nGOTO/8,8,9\n");
  EXPECT_TRUE(path.moves[0].not_checked_reason.empty());
  EXPECT_FALSE(path.moves[2].not_checked_reason.empty());
}

TEST(Units, TheOptionCountsWhereTheFileIsSilentAndMayNotContradictIt) {
  ReadOptions inch;
  inch.unit = LengthUnit::inch;
  const ReadOutcome silent = read_toolpath("a", "GOTO/1,2,3\n", inch);
  ASSERT_TRUE(silent.toolpath);
  EXPECT_EQ(silent.toolpath->unit, LengthUnit::inch);
  expect_vector(silent.toolpath->moves[0].end.tip, 25.4, 50.8, 76.2, 1e-9);
  const ReadOutcome stated = read_toolpath("a", "UNITS/MM\nGOTO/1,2,3\n", inch);
  ASSERT_FALSE(stated.toolpath);
  EXPECT_EQ(stated.errors.front().code, "path-unit");
}

TEST(Foreign, FilesThatAreNoClDataAreNamed) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"1.0 2.0 3.0\n4.0 5.0 6.0\n", "holds columns of numbers"},
      {"ISO-10303-21;\nHEADER;\n", "is a STEP file"},
      {"solid part\nfacet normal 0 0 1\n", "is an STL mesh"},
      {"{\"tools\":[]}", "is JSON"}};
  for (const auto& [text, begins] : files) {
    const ReadOutcome outcome = read_toolpath("a", text);
    ASSERT_FALSE(outcome.toolpath);
    EXPECT_EQ(outcome.errors.front().code, "path-not-cl-data") << text;
    EXPECT_TRUE(outcome.errors.front().message.starts_with(begins)) << outcome.errors.front().message;
  }
}

TEST(Foreign, AProgramNeedsItsControl) {
  for (const std::string text : {"%\nO1000\nG21 G90\nT1 M6\nG0 X1. Y2. Z3.\nG1 Z-1. F100\nM30\n%\n",
                                 "G0  X  16.3  Y -25.4\nG1  X   6.3  F 318\nG1  X   6.4  Y 2\n",
                                 "%_N_X_MPF\nN10 G17 G71 G90\nN20 TRANS Z0\nN30 AROT X0\nN40 R1=5\nN50 G1 X1 F100\n",
                                 ";$PATH=/_N_WKS_DIR/_N_X_WPD\nN10 MSG(\"A\")\nN20 R1=5\nN30 STOPRE\n"}) {
    const ReadOutcome outcome = read_toolpath("a", text);
    ASSERT_FALSE(outcome.toolpath) << text;
    EXPECT_EQ(outcome.errors.front().code, "gcode-control") << text;
  }
}

TEST(Foreign, AProgramInKlartextShowsItsControl) {
  const ReadOutcome outcome =
      read_toolpath("a", std::string("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S100\n2 L X+1 Y+2 Z+9 R0 F100\n3 L X+5\n4 M30\n"
                                     "5 END PGM A MM\n"));
  ASSERT_TRUE(outcome.toolpath) << to_text(outcome.errors.at(0));
  const Assumptions& facts = outcome.toolpath->assumptions;
  const auto dialect = std::ranges::find(facts, Subject::dialect, &Assumption::subject);
  ASSERT_NE(dialect, facts.end());
  EXPECT_EQ(dialect->basis, Basis::derived);
  EXPECT_EQ(dialect->value, "program of Heidenhain Klartext");
}

TEST(Foreign, AnErrorNamesTheControlThatTheWordsAreOf) {
  const auto message_of = [](const std::string& text) { return read_toolpath("a", text).errors.at(0).message; };
  EXPECT_NE(message_of("%_N_X_MPF\nN10 G0 X1\nN20 TRAORI\n").find("expected --control siemens, because"),
            std::string::npos);
  EXPECT_NE(message_of("%\nO1\nG21 G90\nG0 X1. Y2.\nG1 Z-1. F9\nM30\n").find("expected --control linuxcnc"),
            std::string::npos);
}

// A program of few blocks has no marks of one, but the machine states its control.
TEST(Foreign, AProgramOfAMachineWithAControlIsReadAsThat) {
  const std::string text = "N10 G17 G71 G90 G54\nN20 R1=5\nN30 TRANS Z0\nN40 MSG(\"A\")\nN50 G1 X=R1 F100\nN60 M30\n";
  ReadOptions options;
  EXPECT_EQ(dialect_of(text, options).format, "text");
  ProgramSetup setup;
  setup.control = "siemens";
  options.program = std::make_shared<ProgramSetup>(setup);
  EXPECT_EQ(dialect_of(text, options).format, "gcode");
  EXPECT_EQ(dialect_of("PARTNO/A\nGOTO/1,2,3\n", options).format, "text");
}

// pmill_test1_4: the four numbers of the binary record and the seven of its ASCII twin are one cutter.
TEST(NccsBinary, ACutterWithASideAngleIsThatOfItsAsciiTwin) {
  const Toolpath real = path_of(
      "REMARK NCLCAM\nCUTTER/  22.918,   0.100,   0.000,   0.100,   0.000, -89.000,   0.200\n"
      "GOTO  /   -3.4701,   -4.5099,   -2.0664\nFINI\n");
  const auto file = real_toolpaths() / "nccs_ncl/pmill_test1_4.cl";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the real toolpaths are not here";
  const Toolpath binary = path_of(bytes_of(file));
  ASSERT_TRUE(binary.tools[0].cutter && real.tools[0].cutter);
  EXPECT_NEAR(binary.tools[0].cutter->d_mm, real.tools[0].cutter->d_mm, 5e-4);
  EXPECT_NEAR(binary.tools[0].cutter->e_mm, real.tools[0].cutter->e_mm, 5e-4);
  EXPECT_NEAR(binary.tools[0].cutter->beta_deg, -89, 1e-12);
}

TEST(NccsBinary, EqualsItsAsciiTwinToTheDigitsOfTheText) {
  const auto folder = real_toolpaths() / "nccs_ncl";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the real toolpaths are not here";
  const Toolpath binary = path_of(bytes_of(folder / "pmill_test1_4.cl"));
  const Toolpath text = path_of(bytes_of(folder / "pmill_test1_4.as"));
  ASSERT_EQ(binary.moves.size(), 3716u);
  ASSERT_EQ(text.moves.size(), binary.moves.size());
  for (std::size_t i = 0; i < text.moves.size(); ++i) {
    EXPECT_LE((text.moves[i].end.tip - binary.moves[i].end.tip).cwiseAbs().maxCoeff(), 5.1e-5) << i;
    EXPECT_LE((text.moves[i].end.axis - binary.moves[i].end.axis).cwiseAbs().maxCoeff(), 1e-7) << i;
    EXPECT_EQ(text.moves[i].has_start, binary.moves[i].has_start) << i;
  }
}

TEST(NccsBinary, SaysWhatItsSampleSays) {
  const Toolpath path = sample("nccs_binary.cl");
  ASSERT_EQ(path.moves.size(), 5u);
  EXPECT_EQ(path.moves[0].kind, MoveKind::rapid);
  EXPECT_EQ(path.moves[1].kind, MoveKind::feed);
  expect_vector(path.moves[3].end.tip, 4, 2, 3.25);
  expect_vector(path.moves[3].end.axis, 0, 0.6, 0.8);
  expect_vector(path.moves[4].end.axis, 0, 0, 1);
  ASSERT_EQ(path.tools.size(), 1u);
  EXPECT_EQ(path.tools[0].number, 1);
}

TEST(NccsBinary, AFileCutShortIsRefused) {
  std::string bytes = bytes_of(corpus() / "nccs_binary.cl");
  bytes.resize(300);
  const ReadOutcome outcome = read_toolpath("a.cl", bytes);
  ASSERT_FALSE(outcome.toolpath);
  EXPECT_EQ(outcome.errors.front().code, "path-unterminated");
}

}  // namespace
}  // namespace gouge::dialect_test
