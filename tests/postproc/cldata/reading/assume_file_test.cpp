#include "postproc/cldata/reading/assume_file.h"

#include <gtest/gtest.h>

#include "postproc/formats/read_toolpath.h"

// Facts that a file establishes about itself.

namespace gouge::assume_file_test {
namespace {

Assumption fact_in(const std::string& text, Subject subject, const ReadOptions& options = {}) {
  const ReadOutcome read = read_toolpath("t.apt", text, options);
  EXPECT_TRUE(read.toolpath.has_value()) << text;
  if (!read.toolpath) return {};
  for (const Assumption& fact : read.toolpath->assumptions) {
    if (fact.subject == subject) return fact;
  }
  ADD_FAILURE() << "no fact called " << subject_name(subject);
  return {};
}

TEST(AssumeFile, TheUnitIsStatedDerivedOrUnknownAndNeverADefault) {
  const Assumption stated = fact_in("UNITS/MM\nGOTO/1,2,3\nFINI\n", Subject::path_unit);
  EXPECT_EQ(stated.basis, Basis::stated);
  EXPECT_EQ(stated.evidence, "UNITS/MM");
  EXPECT_EQ(stated.line, 1u);
  const Assumption derived = fact_in("GOTO/1,2,3\nFEDRAT/10,IPM\nGOTO/1,2,4\nFINI\n", Subject::path_unit);
  EXPECT_EQ(derived.basis, Basis::derived);
  EXPECT_EQ(derived.value, "inch");
  EXPECT_EQ(derived.line, 2u);
  for (const char* silent :
       {"GOTO/1,2,3\nFINI\n", "SPINDL/300,SFM\nGOTO/1,2,3\nFINI\n", "FEDRAT/10,PERMIN\nGOTO/1,2,3\nFINI\n",
        "$$ all lengths are inches\nGOTO/1,2,3\nFINI\n", "PPRINT/INCHES\nGOTO/1,2,3\nFINI\n",
        "$$ CATIA APT VERSION 1.0\nGOTO/1,2,3\nEND\n", "GOTO/1,2,3\nUNITS/INCHES\nGOTO/1,2,4\nFINI\n"}) {
    const Assumption unknown = fact_in(silent, Subject::path_unit);
    EXPECT_EQ(unknown.basis, Basis::unknown) << silent;
    EXPECT_EQ(unknown.remedy, "give --path-units mm or --path-units inch");
  }
  ReadOptions inch;
  inch.unit = LengthUnit::inch;
  EXPECT_EQ(fact_in("GOTO/1,2,3\nFINI\n", Subject::path_unit, inch).basis, Basis::stated);
}

TEST(AssumeFile, FeedsThatAreAllInTheOtherUnitContradictTheUnitOfTheUser) {
  ReadOptions inch, mm;
  inch.unit = LengthUnit::inch;
  mm.unit = LengthUnit::mm;
  const std::string in_mm = "GOTO/1,2,3\nFEDRAT/100,MMPM\nGOTO/1,2,4\nFINI\n";
  const std::string in_both = "FEDRAT/10,IPM\nGOTO/1,2,3\nFEDRAT/100,MMPM\nGOTO/1,2,4\nFINI\n";
  const Assumption fact = fact_in(in_mm, Subject::path_unit, inch);
  EXPECT_EQ(fact.basis, Basis::contradicted);
  EXPECT_EQ(fact.evidence, "--path-units states inches, and all feeds are in mm, the first in line 2");
  EXPECT_EQ(fact_in(in_mm, Subject::path_unit, mm).basis, Basis::stated);
  EXPECT_EQ(fact_in(in_both, Subject::path_unit, inch).basis, Basis::stated) << "the option resolves it";
}

TEST(AssumeFile, AFileIsWholeWithItsEndMarkAndUnknownWithoutOneItShouldHave) {
  const auto basis = [](const std::string& text) { return fact_in(text, Subject::completeness).basis; };
  EXPECT_EQ(basis("PARTNO A\nUNITS/MM\nGOTO/1,2,3\nFINI\n"), Basis::derived);
  EXPECT_EQ(basis("PARTNO A\nUNITS/MM\nGOTO/1,2,3\n"), Basis::unknown);
  EXPECT_EQ(basis("$$ CATIA APT VERSION 1.0\nGOTO/1,2,3\n"), Basis::unknown);
  EXPECT_EQ(basis("OPFEATSTART/A\nGOTO/1,2,3\n"), Basis::unknown) << "CLT";
  EXPECT_EQ(basis("MODE/MILL\nGOTO/1,2,3\n"), Basis::unknown) << "Autodesk";
  EXPECT_EQ(basis("MCSYS/ NUM,1,POINT,0,0,0,VECTOR,1,0,0,VECTOR,0,1,0\nGOTO/1,2,3\n"), Basis::unknown) << "Mori";
  EXPECT_EQ(basis("TRNTYP/WORLD,0,0,0\nGOTO/1,2,3\n"), Basis::unknown) << "SolidWorks";
  EXPECT_EQ(basis("TOOL PATH/A,TOOL,B\nGOTO/1,2,3\nEND-OF-PATH\n"), Basis::derived);
  EXPECT_EQ(basis("TOOL PATH/A,TOOL,B\nGOTO/1,2,3\nEND-OF-PATH\nTOOL PATH/C,TOOL,B\nGOTO/1,2,4\n"), Basis::unknown);
  EXPECT_EQ(basis("TOOL PATH/A,TOOL,B\nGOTO/1,2,3\nTOOL PATH/C,TOOL,B\nGOTO/1,2,4\nEND-OF-PATH\n"), Basis::unknown);
  EXPECT_EQ(basis("GOTO/1,2,3\nRAPID\n"), Basis::unknown);
  EXPECT_EQ(basis("GOTO/1,2,3\nGOTO/1,2,4\n"), Basis::by_default) << "a list of positions has no end mark";
}

TEST(AssumeFile, MarksOfTwoDialectsContradictEachOther) {
  const std::string two = "$$* Pro/CLfile\nCSI_TOOL_PATH/A\nUNITS/MM\nGOTO/1,2,3\nFINI\n";
  const Assumption fact = fact_in(two, Subject::dialect);
  EXPECT_EQ(fact.basis, Basis::contradicted);
  EXPECT_EQ(fact.evidence, "the file has marks of apt-creo, and a mark of apt-camplete in line 2");
  EXPECT_EQ(fact.line, 2u);
  ReadOptions stated;
  stated.dialect = dialect_called("apt-camplete");
  EXPECT_EQ(fact_in(two, Subject::dialect, stated).basis, Basis::stated);
  EXPECT_EQ(
      fact_in("MCSYS/ NUM,1,POINT,0,0,0,VECTOR,1,0,0,VECTOR,0,1,0\nOPNAME/A\nGOTO/1,2,3\n", Subject::dialect).basis,
      Basis::derived)
      << "two marks of one dialect";
}

TEST(AssumeFile, TheModeIsAMarkOfBothPostsOfAutodesk) {
  const std::string head = "MODE/MILL\nPARTNO/'A'\nUNITS/MM\nMULTAX/OFF\n";
  const std::string frame = "MCS/1,0,0,$\n0,1,0,$\n0,0,1,$\n0,0,0\n", end = "GOTO/1,2,3\nFINI\n";
  EXPECT_EQ(fact_in(head + end, Subject::dialect).value, "apt-autodesk");
  EXPECT_EQ(fact_in(head + frame + end, Subject::dialect).value, "apt-camplete");
  EXPECT_EQ(fact_in(head + frame + end, Subject::dialect).basis, Basis::derived);
  EXPECT_EQ(fact_in(head + frame + "MOVARC/0,0,0,0,0,1,5,ANGLE,90\n" + end, Subject::dialect).basis,
            Basis::contradicted);
}

TEST(AssumeFile, AnArcOfMoriIsNoMarkOfAutodesk) {
  const std::string head = "MCSYS/ NUM,1,POINT,0,0,0,VECTOR,1,0,0,VECTOR,0,1,0\nGOTO/1,2,3\n";
  EXPECT_EQ(fact_in(head + "MOVARC/ CENTER, 0,2,3,AXIS,0,0,1,RADIUS,1\nGOTO/0,1,3\n", Subject::dialect).basis,
            Basis::derived);
  EXPECT_EQ(fact_in(head + "MOVARC/0,2,3,0,0,1,1,ANGLE,90\nGOTO/0,1,3\n", Subject::dialect).basis, Basis::contradicted);
}

TEST(AssumeFile, WordsThatAreNotUnderstoodAreNamed) {
  EXPECT_EQ(fact_in("UNITS/MM\nCOOLNT/ON\nGOTO/1,2,3\nFINI\n", Subject::statements).basis, Basis::derived);
  const Assumption unknown = fact_in("UNITS/MM\nGOTO/1,2,3\nFROBNI\nFROBNI\nFINI\n", Subject::statements);
  EXPECT_EQ(unknown.basis, Basis::unknown);
  EXPECT_EQ(unknown.evidence, "2 statements with words or arguments that are not understood: FROBNI");
}

TEST(AssumeFile, WordsOneLetterOffAreNamedWithTheWordThatWasMeant) {
  const auto named = [](const std::string& word) {
    const std::string evidence = fact_in("UNITS/MM\n" + word + "/1\nGOTO/1,2,3\nFINI\n", Subject::statements).evidence;
    return evidence.substr(evidence.find(": ") + 2);
  };
  EXPECT_EQ(named("FEDRATE"), "FEDRATE (did you mean FEDRAT?)");
  EXPECT_EQ(named("SPINDLE"), "SPINDLE (did you mean SPINDL?)");
  EXPECT_EQ(named("COLONT"), "COLONT (did you mean COOLNT?)");
  EXPECT_EQ(named("HEADS"), "HEADS");
}

TEST(AssumeFile, TheFrameAndTheDialectNameWhereTheyComeFrom) {
  const std::string nx = "TOOL PATH/A,TOOL,B\nMSYS/0,0,5,1,0,0,0,0,1\nGOTO/1,2,3\nEND-OF-PATH\n";
  EXPECT_EQ(fact_in(nx, Subject::frame).basis, Basis::derived);
  EXPECT_EQ(fact_in(nx, Subject::frame).line, 2u);
  EXPECT_TRUE(read_toolpath("a", nx).toolpath->has_turned_frame);
  EXPECT_EQ(fact_in("GOTO/1,2,3\n", Subject::frame).basis, Basis::by_default);
  EXPECT_EQ(fact_in(nx, Subject::dialect).basis, Basis::derived);
  EXPECT_EQ(fact_in("PARTNO A\nGOTO/1,2,3\nFINI\n", Subject::dialect).basis, Basis::by_default);
  ReadOptions given;
  given.dialect = dialect_called("apt");
  EXPECT_EQ(fact_in("PARTNO A\nGOTO/1,2,3\nFINI\n", Subject::dialect, given).basis, Basis::stated);
}

}  // namespace
}  // namespace gouge::assume_file_test
