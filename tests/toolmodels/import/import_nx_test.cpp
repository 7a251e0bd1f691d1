#include <gtest/gtest.h>

#include "tests/toolmodels/import/import_helpers.h"

namespace gouge::import_nx_test {
namespace {

using test::all_notes;
using test::corpus;
using test::expect_segment;
using test::notes_of;

ImportedTools import_corpus(const ImportOptions& options = {}) {
  const Result<ImportedTools> made =
      import_nx("nx/metric/tool_database.dat", corpus("nx/metric/tool_database.dat"), options);
  EXPECT_TRUE(made.has_value());
  return made ? *made : ImportedTools{};
}

std::string error_of(const std::string& rows) {
  ImportOptions options;
  options.unit = LengthUnit::mm;
  const Result<ImportedTools> made =
      import_nx("t.dat", "#CLASS END_MILL_NON_INDEXABLE\nFORMAT LIBRF DIA FLEN HEI TAPA COR1\n" + rows, options);
  return made ? all_notes(*made) : to_text(made.error());
}

TEST(ImportNx, AnEndMillIsReadByTheNamesOfItsFormat) {
  const ImportedTools made = import_corpus();
  const ToolAssembly* tool = made.library.with_number(11);
  ASSERT_NE(tool, nullptr) << all_notes(made);
  EXPECT_EQ(tool->name, "ugt_flat_20");
  EXPECT_EQ(std::get<FlatCutter>(tool->cutter).diameter_mm, 20);
  EXPECT_EQ(length_mm(tool->cutter), 38);
  ASSERT_EQ(tool->shank.size(), 1u);
  expect_segment(tool->shank[0], 20, 20, 37);  // FLEN 38 to HEI 75
}

TEST(ImportNx, ARowMayGoOnAndAShankStandsOnTheTool) {
  const ImportedTools made = import_corpus();
  const ToolAssembly* tool = made.library.with_number(12);
  ASSERT_NE(tool, nullptr) << all_notes(made);
  EXPECT_EQ(std::get<BullNoseCutter>(tool->cutter).corner_radius_mm, 2);
  ASSERT_EQ(tool->shank.size(), 3u);
  expect_segment(tool->shank[0], 10, 10, 28);  // FLEN 22 to HEI 50
  expect_segment(tool->shank[1], 10, 12, 5);   // TSTLEN
  expect_segment(tool->shank[2], 12, 12, 20);  // to HEI + TSLEN - HOFF = 75
  EXPECT_NE(notes_of(made, "import-left-out").find("its holder \"HLD001_00005\" stands in another file"),
            std::string::npos);
  EXPECT_NE(notes_of(made, "import-guess").find("taken to stand on HEI 50 mm"), std::string::npos);
}

TEST(ImportNx, ATaperIsMeasuredFromTheAxisAndDrillsHaveAnIncludedAngle) {
  const ImportedTools made = import_corpus();
  const auto& cone = std::get<AptCutter>(made.library.with_name("ugt_cone_8")->cutter);
  EXPECT_EQ(cone.d_mm, 8);
  EXPECT_EQ(cone.beta_deg, 5);
  EXPECT_EQ(cone.r_mm, 1);
  EXPECT_EQ(std::get<DrillCutter>(made.library.with_number(21)->cutter).point_angle_deg, 118);
}

constexpr const char* kHolders =
    "# HOLDER_DATABASE.DAT\n"
    "#CLASS MILLING_DRILLING\n"
    "FORMAT LIBRF RTYPE HTYPE SNUM DESCR\n"
    "DATA | HLD001_00005 | 1 | 1 | 2 | Collet\n"
    "DATA | HLD_LATHE    | 1 | 2 | 1 | Turning\n"
    "#END_DATA\n"
    "#CLASS MILLING_DRILLING\n"
    "FORMAT LIBRF RTYPE SEQ DIAM LENGTH TAPER CRAD\n"
    "DATA | HLD001_00005 | 2 | 2 | 40.0 | 30.0 | 0.0 | 1.0\n"
    "DATA | HLD001_00005 | 2 | 1 | 30.0 | 50.0 | 5.7105931 | 0.0\n"
    "#END_DATA\n";

TEST(ImportNx, HoldersAreReadFromTheToolsSideUp) {
  ImportOptions options;
  options.unit = LengthUnit::mm;
  EXPECT_EQ(recognise_format(kHolders), ImportFormat::nx);
  const Result<ImportedTools> made = import_nx("holder_database.dat", kHolders, options);
  ASSERT_TRUE(made.has_value()) << to_text(made.error());
  ASSERT_EQ(made->library.holders.size(), 1U) << all_notes(*made);
  const NamedHolder& holder = made->library.holders[0];
  EXPECT_EQ(holder.name, "HLD001_00005");
  ASSERT_EQ(holder.segments.size(), 2U);
  expect_segment(holder.segments[0], 30, 40, 50);  // 30 + 2 * 50 * tan 5.71 deg
  expect_segment(holder.segments[1], 40, 40, 30);
  EXPECT_NE(notes_of(*made, "import-guess").find("from the tool's side up"), std::string::npos);
  EXPECT_NE(notes_of(*made, "import-guess").find("CRAD"), std::string::npos);
  EXPECT_NE(notes_of(*made, "import-shape").find("HLD_LATHE"), std::string::npos);
  options.unit = LengthUnit::inch;
  expect_segment(import_nx("holder_database.dat", kHolders, options)->library.holders[0].segments[1], 1016, 1016, 762);
}

TEST(ImportNx, AHolderBesideTheToolsIsPutOnWhereHoffSaysHowFar) {
  ImportOptions options;
  options.read_beside = [](const std::string& name) -> Result<std::string> {
    EXPECT_EQ(name, "holder_database.dat");
    return std::string(kHolders);
  };
  const ImportedTools made = import_corpus(options);
  const ToolAssembly* tool = made.library.with_number(12);
  ASSERT_NE(tool, nullptr) << all_notes(made);
  ASSERT_EQ(tool->holder.size(), 2U) << all_notes(made);
  expect_segment(tool->holder[0], 30, 40, 50);
  EXPECT_EQ(notes_of(made, "import-left-out").find("HLD001_00005"), std::string::npos) << all_notes(made);
}

TEST(ImportNx, WrongSectionsLeaveTheirHolderOut) {
  ImportOptions options;
  options.unit = LengthUnit::mm;
  const auto said = [&](const std::string& rows) {
    const Result<ImportedTools> made =
        import_nx("h.dat", "#CLASS MILLING_DRILLING\nFORMAT LIBRF RTYPE SEQ DIAM LENGTH TAPER CRAD\n" + rows, options);
    if (!made) return to_text(made.error());
    EXPECT_TRUE(made->library.holders.empty()) << rows;
    return all_notes(*made);
  };
  const auto has = [&](const std::string& rows, const std::string& what) {
    const std::string text = said(rows);
    EXPECT_NE(text.find(what), std::string::npos) << rows << text;
  };
  has("DATA | H | 2 | 1 | wide | 10 | 0 | 0\n", "DIAM is \"wide\"; expected a number");
  has("DATA | H | 2 | 1 | 30 | | 0 | 0\n", "section 1 has no LENGTH");
  has("DATA | H | 2 | one | 30 | 10 | 0 | 0\n", "SEQ is \"one\"");
  has("DATA | H | 2 | 1 | 30 | 10 | 0 | 0\nDATA | H | 2 | 1 | 30 | 10 | 0 | 0\n", "two sections of SEQ 1");
  has("DATA | H | 2 | 1 | 30 | 10 | 95 | 0\n", "TAPER 95 is not possible");
  has("DATA | H | 2 | 1 | 10 | 50 | -45 | 0\n", "would end below its axis");
  has("DATA | H | 2 | 1 | -3 | 50 | 0 | 0\n", "holder \"H\"");
  has("DATA | | 2 | 1 | 30 | 10 | 0 | 0\n", "a holder has no LIBRF");
}

TEST(ImportNx, ShapesThatCannotBeImportedAreReported) {
  EXPECT_NE(
      notes_of(import_corpus(), "import-shape").find("tool T31 \"ugt_barrel_16\": not imported: shape BARREL_MILL"),
      std::string::npos);
}

ImportedTools import_row(const std::string& tool_class, const std::string& format, const std::string& data) {
  ImportOptions options;
  options.unit = LengthUnit::mm;
  return import_nx("t.dat",
                   "#CLASS " + tool_class + "\nFORMAT LIBRF " + format + "\nDATA | x | " + data + " |\n#END_DATA\n",
                   options)
      .value();
}

TEST(ImportNx, SlotSphericalAndCountersinkCuttersAreImported) {
  const ImportedTools slot =
      import_row("T_SLOT_MILL_NON_INDEXABLE", "DIA FLEN COR1 COR2 HEI TSDIA TSLEN", "32 | 6 | 0.5 | 1 | 40 | 16 | 30");
  ASSERT_EQ(slot.library.tools.size(), 1u) << test::all_notes(slot);
  const auto& disc = std::get<TSlotCutter>(slot.library.tools[0].cutter);
  EXPECT_EQ(disc.corner_radius_mm, 0.5);
  EXPECT_EQ(disc.upper_radius_mm, 1);
  const ImportedTools ball =
      import_row("SPHERICAL_MILL_NON_INDEXABLE", "DIA FLEN HEI TSDIA TSLEN", "10 | 8 | 30 | 5 | 40");
  ASSERT_EQ(ball.library.tools.size(), 1u) << test::all_notes(ball);
  EXPECT_EQ(std::get<LollipopCutter>(ball.library.tools[0].cutter).length_mm, 8);
  const ImportedTools sink = import_row("COUNTER_SINKING", "DIA FLEN TIPA HEI", "12 | 8 | 90 | 40");
  ASSERT_EQ(sink.library.tools.size(), 1u) << test::all_notes(sink);
  EXPECT_EQ(std::get<ChamferCutter>(sink.library.tools[0].cutter).taper_angle_deg, 45);
}

TEST(ImportNx, TheUnitIsNeverAssumedInSilence) {
  const std::string bytes = corpus("nx/metric/tool_database.dat");
  EXPECT_NE(notes_of(import_corpus(), "import-guess").find("lengths are taken in mm, after the folder"),
            std::string::npos);
  const Result<ImportedTools> none = import_nx("tool_database.dat", bytes, {});
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, "import-unit");
  ImportOptions options;
  options.unit = LengthUnit::inch;
  const Result<ImportedTools> inches = import_nx("tool_database.dat", bytes, options);
  ASSERT_TRUE(inches.has_value());
  EXPECT_EQ(std::get<FlatCutter>(inches->library.with_number(11)->cutter).diameter_mm, 508);
  EXPECT_EQ(inches->library.unit, LengthUnit::inch);
}

TEST(ImportNx, MistakesNameRowAndField) {
  EXPECT_EQ(error_of("DATA | a | 10 | 60 | 50 | 0 | 0 |\n"),
            "t.dat:3: error: tool \"a\": FLEN 60 mm is greater than HEI 50 mm; the flutes cannot be longer than the "
            "tool [import-field]\nt.dat: error: no tool of this file could be imported [import-empty]\n");
  EXPECT_NE(error_of("DATA | a | ten | 20 | 50 | 0 | 0 |\n").find("DIA is \"ten\"; expected a number"),
            std::string::npos);
  EXPECT_NE(error_of("DATA | a | 10 | 20 | 50 | 0 | 0 | 7 | 8 |\n").find("has 8 values, but its FORMAT names 6 fields"),
            std::string::npos);
  EXPECT_NE(error_of("#END_DATA\nDATA | a | 10 |\n").find("outside of a #CLASS"), std::string::npos);
  EXPECT_EQ(error_of("DATA | a | 10 | 20 | 50 | 0 | 0 |\n"),
            "t.dat:3: note: tool \"a\": no length below the holder is given; drawn up to HEI 50 mm, without a holder "
            "[import-guess]\n");
}

TEST(ImportNx, NamesInLatin1SurviveAndARoundTripLosesNothing) {
  ImportOptions options;
  options.unit = LengthUnit::mm;
  const Result<ImportedTools> made = import_nx(
      "t.dat", "#CLASS END_MILL_NON_INDEXABLE\nFORMAT LIBRF DIA FLEN HEI\nDATA | Fr\xE4ser | 10 | 20 | 50 |\n",
      options);
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->library.tools.at(0).name, "Fr\xC3\xA4ser");
  test::expect_round_trip(made->library);
  test::expect_round_trip(import_corpus().library);
}

TEST(ImportNx, FormatsAreRecognisedByWhatTheyHold) {
  EXPECT_EQ(recognise_format(corpus("nx/metric/tool_database.dat")), ImportFormat::nx);
  EXPECT_EQ(recognise_format(corpus("fusion-mill.json")), ImportFormat::fusion);
  EXPECT_EQ(recognise_format(corpus("fusion-mill.tools")), ImportFormat::fusion);
  EXPECT_EQ(recognise_format(corpus("freecad/shop.fctl")), ImportFormat::freecad);
  EXPECT_EQ(recognise_format(corpus("freecad/bull_6.fctb")), ImportFormat::freecad);
  EXPECT_EQ(recognise_format(R"({"units":"mm","tools":[]})"), std::nullopt) << "our own library";
  EXPECT_EQ(recognise_format("GOTO/1,2,3"), std::nullopt);
  EXPECT_EQ(recognise_format(""), std::nullopt);
}

}  // namespace
}  // namespace gouge::import_nx_test
