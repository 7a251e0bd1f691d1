#include <gtest/gtest.h>

#include "tests/toolmodels/import/import_helpers.h"

namespace gouge::import_freecad_test {
namespace {

using test::all_notes;
using test::corpus;
using test::expect_segment;
using test::notes_of;

ImportOptions beside() {
  ImportOptions options;
  options.read_beside = [](const std::string& name) -> Result<std::string> {
    if (name == "missing.fctb") return make_error("file-not-found", "there is no such file", name);
    return corpus("freecad/" + name);
  };
  return options;
}

ImportedTools import_library(const ImportOptions& options) {
  const Result<ImportedTools> made = import_freecad("shop.fctl", corpus("freecad/shop.fctl"), options);
  EXPECT_TRUE(made.has_value());
  return made ? *made : ImportedTools{};
}

ImportedTools import_bit(const std::string& type, const std::string& parameters, const ImportOptions& options = {}) {
  const Result<ImportedTools> made = import_freecad(
      "b.fctb", R"({"name":"x","shape-type":")" + type + R"(","shape":"s.fcstd","parameter":{)" + parameters + "}}",
      options);
  EXPECT_TRUE(made.has_value());
  return made ? *made : ImportedTools{};
}

TEST(ImportFreecad, ALibraryNamesItsBits) {
  const ImportedTools made = import_library(beside());
  ASSERT_EQ(made.library.tools.size(), 3u) << all_notes(made);
  EXPECT_EQ(made.library.with_number(1)->name, "Bull nose 6");
  EXPECT_NE(all_notes(made).find("missing.fctb: error: tool at position 4: there is no such file [file-not-found]"),
            std::string::npos)
      << all_notes(made);
  EXPECT_NE(all_notes(made).find("shop.fctl:2: error: tool at position 5: path is \"../../secret.fctb\"; expected the "
                                 "name of a file beside the library [import-field]"),
            std::string::npos)
      << all_notes(made);
}

TEST(ImportFreecad, LengthsAreTextsWithUnits) {
  const ImportedTools made = import_library(beside());
  const ToolAssembly* bull = made.library.with_number(1);
  const auto& cutter = std::get<BullNoseCutter>(bull->cutter);
  EXPECT_EQ(cutter.diameter_mm, 6);
  EXPECT_EQ(cutter.corner_radius_mm, 1.5);
  EXPECT_EQ(cutter.length_mm, 20);
  expect_segment(bull->shank.at(0), 8, 8, 30);
  EXPECT_TRUE(bull->holder.empty());
}

TEST(ImportFreecad, TheTaperAngleIsTheIncludedAngleAndCommasAreDecimal) {
  const ImportedTools made = import_library(beside());
  const ToolAssembly* ball = made.library.with_number(2);
  const auto& cutter = std::get<TaperedCutter>(ball->cutter);
  EXPECT_EQ(cutter.taper_angle_deg, 3);
  EXPECT_EQ(cutter.corner_radius_mm, 1);
  // 2 (1/cos 3 + 24 tan 3) at z = 25
  EXPECT_NEAR(2 * make_cutter_profile(cutter)->elements.back().a.x(), 4.518318, 1e-6);
  EXPECT_NE(notes_of(made, "import-guess").find("TaperAngle has a comma; read as a decimal comma, 6 degrees"),
            std::string::npos);
  EXPECT_NE(notes_of(made, "import-guess").find("Diameter has a comma; read as a decimal comma, 2 mm"),
            std::string::npos);
}

TEST(ImportFreecad, AVBitIsPointedAndInInches) {
  const ImportedTools made = import_library(beside());
  const auto& chamfer = std::get<ChamferCutter>(made.library.with_number(3)->cutter);
  EXPECT_NEAR(chamfer.diameter_mm, 12.7, 1e-12);
  EXPECT_EQ(chamfer.taper_angle_deg, 30);
  EXPECT_NEAR(chamfer.length_mm, 15.24, 1e-12);  // above the cone of 6.35 / tan 30 = 10.998
}

TEST(ImportFreecad, HolderAndStickOutComeFromTheUser) {
  ImportOptions options = beside();
  options.holder = {{28, 28, 40}};
  EXPECT_EQ(import_library(options).library.tools.size(), 0u) << "a holder without stick-out is a guess";
  options.stickout_mm = 30;
  const ImportedTools made = import_library(options);
  ASSERT_EQ(made.library.tools.size(), 3u) << all_notes(made);
  expect_segment(made.library.with_number(1)->shank.at(0), 8, 8, 10);
  EXPECT_EQ(made.library.with_number(1)->holder.size(), 1u);
  options.stickout_mm = 10;
  EXPECT_NE(all_notes(import_library(options))
                .find("CuttingEdgeHeight 20 mm is greater than --stickout 10 mm; the holder would swallow a part of "
                      "the flutes"),
            std::string::npos);
}

TEST(ImportFreecad, OldFilesGiveTheRadiusOfTheFlat) {
  const ImportedTools made =
      import_bit("Bullnose", R"("Diameter":"10 mm","FlatRadius":"3 mm","CuttingEdgeHeight":"20 mm","Length":"60 mm")");
  EXPECT_EQ(std::get<BullNoseCutter>(made.library.tools.at(0).cutter).corner_radius_mm, 2);
}

TEST(ImportFreecad, TheTypeMayStandInTheNameOfTheShapeFile) {
  const Result<ImportedTools> made = import_freecad(
      "b.fctb",
      R"({"name":"x","shape":"Shape/v-bit.fcstd","parameter":{"Diameter":"10 mm","CuttingEdgeAngle":"90 deg",)"
      R"("CuttingEdgeHeight":"6 mm","Length":"40 mm"}})",
      {});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->library.tools.size(), 1u);
}

TEST(ImportFreecad, FlutesLongerThanTheToolAreAnError) {
  EXPECT_EQ(notes_of(import_bit("Endmill", R"("Diameter":"6 mm","CuttingEdgeHeight":"60 mm","Length":"50 mm")"),
                     "import-field"),
            "b.fctb: error: tool \"x\": CuttingEdgeHeight 60 mm is greater than Length 50 mm; the flutes cannot be "
            "longer than the tool [import-field]\n");
}

TEST(ImportFreecad, ShapesThatCannotBeImportedAreReported) {
  for (const char* type : {"ThreadMill", "Radius", "Fillet", "Custom"})
    EXPECT_EQ(notes_of(import_bit(type, R"("Diameter":"6 mm")"), "import-shape"),
              "b.fctb: warning: tool \"x\": not imported: shape " + std::string(type) + " [import-shape]\n");
}

TEST(ImportFreecad, ADovetailHasANeckAndAnAngleThatIsReported) {
  const ImportedTools made = import_bit(
      "Dovetail",
      R"("Diameter":"20 mm","CuttingEdgeAngle":"60 deg","CuttingEdgeHeight":"8 mm",)"
      R"("NeckDiameter":"9 mm","NeckHeight":"12 mm","ShankDiameter":"10 mm","Length":"60 mm","TipDiameter":"1 mm")");
  ASSERT_EQ(made.library.tools.size(), 1u) << test::all_notes(made);
  EXPECT_EQ(std::get<DovetailCutter>(made.library.tools[0].cutter).taper_angle_deg, 30);
  test::expect_segment(made.library.tools[0].shank.at(0), 9, 9, 12);
  test::expect_segment(made.library.tools[0].shank.at(1), 10, 10, 40);
  EXPECT_NE(notes_of(made, "import-guess")
                .find("warning: tool \"x\": half of CuttingEdgeAngle 30 degrees is taken between side and axis"),
            std::string::npos);
}

TEST(ImportFreecad, ASlittingSawHasItsCapBelow) {
  const ImportedTools made = import_bit(
      "SlittingSaw", R"("Diameter":"76.2 mm","BladeThickness":"3 mm","CapDiameter":"8 mm","CapHeight":"3 mm",)"
                     R"("ShankDiameter":"19 mm","Length":"50 mm")");
  ASSERT_EQ(made.library.tools.size(), 1u) << test::all_notes(made);
  const Profile profile = *make_cutter_profile(made.library.tools[0].cutter);
  EXPECT_EQ(profile.elements.at(0).b, Vec2(4, 0));
  EXPECT_EQ(profile.elements.at(2).b, Vec2(38.1, 3));
  EXPECT_EQ(profile.elements.at(3).b, Vec2(38.1, 6));
  EXPECT_NE(notes_of(made, "import-guess").find("the cap of CapDiameter 8 mm is taken to be below the blade"),
            std::string::npos);
}

TEST(ImportFreecad, AProbeIsABallOnItsShaft) {
  const ImportedTools made = import_bit("Probe", R"("Diameter":"6 mm","ShaftDiameter":"4 mm","Length":"50 mm")");
  ASSERT_EQ(made.library.tools.size(), 1u) << test::all_notes(made);
  const Profile profile = *make_cutter_profile(made.library.tools[0].cutter);
  EXPECT_NEAR(profile.elements.back().a.y(), 5.236068, 1e-6);  // 3 + sqrt(9 - 4)
}

TEST(ImportFreecad, AVBitOfNoDiameterIsLeftOutWithTheReason) {
  const ImportedTools made =
      import_bit("VBit", R"("Diameter":"0 in","CuttingEdgeAngle":"20 \u00b0","CuttingEdgeHeight":"0.6 in")");
  EXPECT_TRUE(made.library.tools.empty());
  EXPECT_NE(test::notes_of(made, "import-field").find("Diameter 0 mm is not possible"), std::string::npos)
      << test::all_notes(made);
}

TEST(ImportFreecad, ADrillWithoutFluteLengthHasFlutesUpToItsEnd) {
  const ImportedTools made = import_bit("Drill", R"("Diameter":"6.8 mm","Length":"74 mm","TipAngle":"118 deg")");
  ASSERT_EQ(made.library.tools.size(), 1u) << all_notes(made);
  const auto& drill = std::get<DrillCutter>(made.library.tools[0].cutter);
  EXPECT_EQ(drill.diameter_mm, 6.8);
  EXPECT_EQ(drill.point_angle_deg, 118);
  EXPECT_EQ(drill.length_mm, 74);
  EXPECT_TRUE(made.library.tools[0].shank.empty());
  EXPECT_NE(all_notes(made).find("b.fctb: warning: tool \"x\": no flute length is given; the flutes are taken to reach "
                                 "up to Length 74 mm, the whole length of the drill [import-guess]"),
            std::string::npos)
      << all_notes(made);
}

TEST(ImportFreecad, FlutesThatAreTakenToReachUpEndAtTheHolder) {
  ImportOptions options;
  options.holder = {{28, 28, 40}};
  options.stickout_mm = 50;
  const ImportedTools made = import_bit(
      "Drill", R"("Diameter":"6.8 mm","Length":"74 mm","TipAngle":"118 deg","ShankDiameter":"6 mm")", options);
  ASSERT_EQ(made.library.tools.size(), 1u) << all_notes(made);
  EXPECT_EQ(std::get<DrillCutter>(made.library.tools[0].cutter).length_mm, 50);
}

TEST(ImportFreecad, NoFlutesAreGuessedWhereSomethingWiderStandsOnThem) {
  for (const char* more : {R"(,"ShankDiameter":"10 mm")", R"(,"NeckDiameter":"7 mm")"}) {
    const ImportedTools made =
        import_bit("Drill", std::string(R"("Diameter":"6.8 mm","Length":"74 mm","TipAngle":"118 deg")") + more);
    EXPECT_TRUE(made.library.tools.empty()) << more;
    EXPECT_NE(notes_of(made, "import-field").find("the file gives no flute length"), std::string::npos)
        << all_notes(made);
  }
  EXPECT_TRUE(import_bit("Endmill", R"("Diameter":"6 mm","Length":"50 mm")").library.tools.empty());
  EXPECT_TRUE(import_bit("Drill", R"("Diameter":"6 mm","TipAngle":"118 deg")").library.tools.empty()) << "no length";
}

// A bit whose two words for the shape are these.
ImportedTools import_two_shapes(const std::string& shape, const std::string& type) {
  const Result<ImportedTools> made = import_freecad(
      "b.fctb",
      R"({"name":"x","shape":")" + shape + R"(","shape-type":")" + type +
          R"(","parameter":{"Diameter":"6 mm","CornerRadius":"1 mm","CuttingEdgeHeight":"20 mm","Length":"50 mm",)" +
          R"("TipAngle":"118 deg","CuttingEdgeAngle":"60 deg","TipDiameter":"0 mm","NeckDiameter":"4 mm","NeckHeight":"5 mm"}})",
      {});
  EXPECT_TRUE(made.has_value());
  return made ? *made : ImportedTools{};
}

TEST(ImportFreecad, OfTwoShapesThatContradictEachOtherTheLargerIsBuilt) {
  const struct {
    const char *shape, *type, *built;
  } cases[] = {{"drill.fcstd", "Endmill", "flat"},         {"endmill.fcstd", "Drill", "flat"},
               {"Shape/ballend.fcstd", "Endmill", "flat"}, {"bullnose.fcstd", "Ballend", "bull_nose"},
               {"v-bit.fcstd", "Endmill", "flat"},         {"tap.fcstd", "Bullnose", "flat"}};
  for (const auto& [shape, type, built] : cases) {
    const ImportedTools made = import_two_shapes(shape, type);
    ASSERT_EQ(made.library.tools.size(), 1u) << shape << "\n" << all_notes(made);
    EXPECT_STREQ(shape_name(made.library.tools[0].cutter), built) << shape;
    EXPECT_NE(notes_of(made, "import-contradiction").find("which is the larger tool"), std::string::npos)
        << all_notes(made);
  }
  EXPECT_NE(
      notes_of(import_two_shapes("drill.fcstd", "Endmill"), "import-contradiction")
          .find("b.fctb: warning: tool \"x\": \"shape\" is drill but \"shape-type\" is Endmill; built as Endmill, "
                "which is the larger tool"),
      std::string::npos);
}

TEST(ImportFreecad, OfTwoShapesWithoutALargerOneNoneIsBuilt) {
  for (const auto& [shape, type] : {std::pair("dovetail.fcstd", "Endmill"), {"drill.fcstd", "Ballend"}}) {
    const ImportedTools made = import_two_shapes(shape, type);
    EXPECT_TRUE(made.library.tools.empty());
    EXPECT_NE(notes_of(made, "import-field").find("; correct the one that is wrong"), std::string::npos)
        << all_notes(made);
  }
}

TEST(ImportFreecad, TwoWordsOfOneShapeDoNotContradictEachOther) {
  for (const auto& [shape, type] :
       {std::pair("reamer.fcstd", "Endmill"), {"my_own_shape.fcstd", "Endmill"}, {"torus.fcstd", "Bullnose"}}) {
    const ImportedTools made = import_two_shapes(shape, type);
    EXPECT_EQ(made.library.tools.size(), 1u) << shape;
    EXPECT_EQ(notes_of(made, "import-contradiction").find("shape-type"), std::string::npos) << all_notes(made);
  }
}

TEST(ImportFreecad, ARoundTripLosesNothing) {
  test::expect_round_trip(import_library(beside()).library);
  const ImportedTools inches = import_bit(
      "Endmill", R"("Diameter":"0.25 in","CuttingEdgeHeight":"0.7 in","Length":"2.3 in","ShankDiameter":"0.3 in")");
  EXPECT_EQ(inches.library.unit, LengthUnit::inch);
  test::expect_round_trip(inches.library);
}

TEST(ImportFreecad, AFileOfAnotherKindIsRefused) {
  for (const char* other : {R"({"x":1})", R"({"tools":[{"name":"flat","diameter":6}]})", R"({"tools":{"path":"a"}})"}) {
    const Result<ImportedTools> made = import_freecad("b.json", other, {});
    ASSERT_FALSE(made.has_value()) << other;
    EXPECT_EQ(made.error().code, "import-format");
  }
}

TEST(ImportTools, JsonOfOtherProgramsIsNoLibraryOfAnyOfThese) {
  for (const char* other : {R"({"name":"Mine","version":1,"tools":[{"key":"e6","type":"endmill","diameter":6}]})",
                            R"({"tools":["em6"]})", R"({"data":{"tools":[]}})", R"({"data":[{"id":1,"diameter":6}]})",
                            R"({"parameter":{"Diameter":"6 mm"}})", R"({"1":{"shape":"Cylindrical","diameter":4}})"}) {
    EXPECT_FALSE(recognise_format(other).has_value()) << other;
    const Result<ImportedTools> made = import_tools("t.json", other, std::nullopt, {});
    ASSERT_FALSE(made.has_value()) << other;
    EXPECT_EQ(
        to_text(made.error()),
        "t.json: error: the JSON in this file is no tool library; expected a tool library of gougecheck (JSON), Fusion "
        "(.json or .tools), FreeCAD (.fctl or .fctb), NX (tool_database.dat), CAMotics (.json) or LinuxCNC (.tbl); if it "
        "is one of these, say which with --format [import-format]");
  }
  EXPECT_EQ(recognise_format(R"({"tools":[{"nr":1,"path":"a.fctb"}]})"), ImportFormat::freecad);
  EXPECT_EQ(recognise_format(R"({"data":[{"type":"holder","segments":[]}]})"), ImportFormat::fusion);
}

}  // namespace
}  // namespace gouge::import_freecad_test
