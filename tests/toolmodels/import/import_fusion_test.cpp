#include <gtest/gtest.h>

#include "tests/toolmodels/import/import_helpers.h"

namespace gouge::import_fusion_test {
namespace {

using test::all_notes;
using test::corpus;
using test::expect_segment;
using test::notes_of;

ImportedTools import_corpus() {
  const Result<ImportedTools> made = import_fusion("shop.json", corpus("fusion-mill.json"), {});
  EXPECT_TRUE(made.has_value());
  return made ? *made : ImportedTools{};
}

// One tool of mm, T9 "x", from its type and its geometry.
ImportedTools import_one(const std::string& type, const std::string& geometry, const std::string& more = "",
                         const ImportOptions& options = {}) {
  const Result<ImportedTools> made =
      import_fusion("one.json",
                    R"({"data":[{"type":")" + type + R"(","unit":"millimeters","description":"x",)" + more +
                        R"("post-process":{"number":9},"geometry":{)" + geometry + "}}]}",
                    options);
  EXPECT_TRUE(made.has_value()) << to_text(made.error());
  return made ? *made : ImportedTools{};
}

TEST(ImportFusion, AFlatMillHasItsShoulderShankAndHolder) {
  const ImportedTools made = import_corpus();
  const ToolAssembly* tool = made.library.with_number(1);
  ASSERT_NE(tool, nullptr);
  EXPECT_EQ(tool->name, "Flat D10");
  EXPECT_EQ(std::get<FlatCutter>(tool->cutter).diameter_mm, 10);
  EXPECT_EQ(length_mm(tool->cutter), 22);
  ASSERT_EQ(tool->shank.size(), 2u);
  expect_segment(tool->shank[0], 9.5, 9.5, 8);  // 22 to 30, shoulder-diameter
  expect_segment(tool->shank[1], 10, 10, 10);   // 30 to LB 40
  ASSERT_EQ(tool->holder.size(), 3u);
  expect_segment(tool->holder[0], 24, 28, 5);  // the first segment is the one at the tip side
  expect_segment(tool->holder[2], 40, 50, 20);
}

TEST(ImportFusion, EveryEntryAndEveryHolderHasItsOwnUnit) {
  const ImportedTools made = import_corpus();
  const ToolAssembly* tool = made.library.with_number(2);
  ASSERT_NE(tool, nullptr);
  EXPECT_EQ(std::get<BallCutter>(tool->cutter).diameter_mm, 6.35);
  EXPECT_NEAR(length_mm(tool->cutter), 19.05, 1e-12);
  expect_segment(tool->shank.at(0), 6.35, 6.35, 19.05);
  expect_segment(tool->holder.at(0), 32, 32, 50);
  const std::optional<NamedHolder> holder = made.library.holder_called("ER16 long");
  ASSERT_TRUE(holder.has_value());
  expect_segment(holder->segments.at(1), 38.1, 44.45, 38.1);
}

TEST(ImportFusion, IsoNamesAndShaftSegmentsAreUnderstood) {
  const ImportedTools made = import_corpus();
  const ToolAssembly* tool = made.library.with_number(3);
  ASSERT_NE(tool, nullptr);
  const auto& cutter = std::get<BullNoseCutter>(tool->cutter);
  EXPECT_EQ(cutter.corner_radius_mm, 0.75);
  EXPECT_EQ(cutter.length_mm, 10);
  ASSERT_EQ(tool->shank.size(), 3u);
  expect_segment(tool->shank[0], 6, 6, 2);   // 10 to the shoulder's end at 12, as wide as the cutter
  expect_segment(tool->shank[1], 6, 8, 5);   // the shaft
  expect_segment(tool->shank[2], 8, 8, 13);  // DMM up to LB 30
  EXPECT_EQ(notes_of(made, "import-contradiction").find("Bull"), std::string::npos) << "6 - 2 x 0.75 = 4.5 agrees";
}

TEST(ImportFusion, ATaperedMillIsBuiltFromDiameterRadiusAndHalfAngle) {
  const ImportedTools made = import_corpus();
  const ToolAssembly* tool = made.library.with_number(4);
  ASSERT_NE(tool, nullptr);
  const Profile profile = *make_cutter_profile(tool->cutter);
  // e = 6 + 2.5 tan 10 - 2.5 / cos 10, and the side at the top of the flutes is 6 + 24 tan 10 from the axis.
  EXPECT_NEAR(profile.elements.at(1).center.x(), 3.902251, 1e-6);
  EXPECT_NEAR(profile.elements.at(1).center.y(), 2.5, 1e-12);
  EXPECT_NEAR(2 * profile.elements.back().a.x(), 20.463695, 1e-6);
  EXPECT_NE(
      all_notes(made).find(
          "shop.json:24: warning: tool T4 \"Tapered D12 R2.5\": tip-diameter 7 mm does not follow from the other "
          "numbers, which give 7.8045 mm; built from diameter, corner radius and taper angle [import-contradiction]"),
      std::string::npos)
      << all_notes(made);
}

TEST(ImportFusion, AShoulderDiameterThatAnotherAngleWouldGiveIsReported) {
  const ImportedTools made =
      import_one("tapered mill", R"("DC":6,"LCF":20,"OAL":60,"LB":40,"SFDM":10,"TA":10,"shoulder-diameter":9.4995)");
  EXPECT_EQ(notes_of(made, "import-contradiction"),
            "one.json:1: warning: tool T9 \"x\": shoulder-diameter 9.4995 mm, but a side leaning TA 10 degrees from "
            "the axis is 13.0531 mm wide at the top of the flutes; built with that angle [import-contradiction]\n");
}

TEST(ImportFusion, AChamferMillIsLargestAtItsDiameter) {
  const ImportedTools made = import_corpus();
  const ToolAssembly* tool = made.library.with_number(5);
  ASSERT_NE(tool, nullptr);
  const auto& chamfer = std::get<ChamferCutter>(tool->cutter);
  EXPECT_EQ(chamfer.diameter_mm, 12);
  EXPECT_EQ(chamfer.tip_diameter_mm, 2);
  EXPECT_EQ(chamfer.taper_angle_deg, 45);
  EXPECT_EQ(chamfer.length_mm, 8) << "the straight part above the cone of (12 - 2) / 2 = 5 is cutter too";
  EXPECT_EQ(make_cutter_profile(chamfer)->elements.at(1).b, Vec2(6, 5));
  ASSERT_EQ(tool->shank.size(), 1u);
  expect_segment(tool->shank[0], 12, 12, 27);
}

TEST(ImportFusion, APointedChamferMillIsAConeWithOrWithoutAStraightPart) {
  const ImportedTools with = import_one("chamfer mill", R"("DC":10,"LCF":9,"OAL":50,"LB":30,"SFDM":10,"TA":45)");
  const auto& chamfer = std::get<ChamferCutter>(with.library.tools.at(0).cutter);
  EXPECT_EQ(chamfer.diameter_mm, 10);
  EXPECT_EQ(chamfer.tip_diameter_mm, 0);
  EXPECT_EQ(chamfer.length_mm, 9);
  const ImportedTools without = import_one("chamfer mill", R"("DC":10,"LCF":3,"OAL":50,"LB":30,"SFDM":10,"TA":45)");
  const Profile profile = *make_cutter_profile(without.library.tools.at(0).cutter);
  EXPECT_NEAR(profile.elements.back().a.x(), 5, 1e-9);
  EXPECT_NEAR(profile.elements.back().a.y(), 5, 1e-12);
  EXPECT_NE(notes_of(without, "import-contradiction").find("LCF 3 mm ends below the top of the cone"),
            std::string::npos);
}

TEST(ImportFusion, ADrillHasItsPoint) {
  const ImportedTools made = import_corpus();
  const auto& drill = std::get<DrillCutter>(made.library.with_number(6)->cutter);
  EXPECT_EQ(drill.diameter_mm, 8.5);
  EXPECT_EQ(drill.point_angle_deg, 140);
  EXPECT_EQ(drill.length_mm, 47);
  const Profile profile = *make_cutter_profile(drill);
  EXPECT_NEAR(profile.elements.at(0).b.y(), 1.546873, 1e-6);  // 4.25 tan 20
}

TEST(ImportFusion, WhatCannotBeImportedIsReported) {
  const ImportedTools made = import_corpus();
  EXPECT_EQ(notes_of(made, "import-shape"), "");
  EXPECT_EQ(notes_of(made, "import-field"),
            "shop.json:39: error: tool T8 \"Flutes longer than the tool\": LCF 60 mm is greater than OAL 50 mm; the "
            "flutes cannot be longer than the tool [import-field]\n");
  EXPECT_EQ(notes_of(made, "import-number"),
            "shop.json:42: warning: tool T1 \"Second tool 1\": number 1 is already taken; this tool is imported "
            "without number, as \"Second tool 1\" [import-number]\n");
  EXPECT_EQ(made.library.tools.size(), 8u);
  EXPECT_TRUE(made.library.is_shared_number(1));
  EXPECT_FALSE(made.library.is_shared_number(8));
  EXPECT_EQ(notes_of(import_one("form mill", R"("DC":10,"LCF":9,"OAL":50,"LB":30,"SFDM":10)"), "import-shape"),
            "one.json:1: warning: tool T9 \"x\": not imported: shape form mill [import-shape]\n");
}

Cutter cutter_of(const ImportedTools& made) {
  EXPECT_EQ(made.library.tools.size(), 1u) << test::all_notes(made);
  return made.library.tools.empty() ? Cutter() : made.library.tools[0].cutter;
}

// The numbers of these are those of the templates Fusion makes new tools from.
TEST(ImportFusion, ADovetailIsWidestAtItsBottom) {
  const ImportedTools made = import_one(
      "dovetail mill", R"("DC":20,"LCF":10,"OAL":80,"LB":40,"SFDM":10,"TA":30,"RE":0,"shoulder-diameter":8.45,)"
                       R"("shoulder-length":20,"tip-diameter":20)");
  const Cutter cutter = cutter_of(made);
  EXPECT_EQ(std::get<DovetailCutter>(cutter).taper_angle_deg, 30);
  const Profile profile = *make_cutter_profile(cutter);
  EXPECT_EQ(profile.elements.at(0).b, Vec2(10, 0));
  EXPECT_NEAR(2 * profile.elements.back().a.x(), 8.452995, 1e-6);  // 20 - 2 10 tan 30
  test::expect_segment(made.library.tools[0].shank.at(0), 8.45, 8.45, 10);
  EXPECT_EQ(notes_of(made, "import-contradiction"), "");
  const ImportedTools whole =
      import_one("dovetail mill", R"("DC":20,"LCF":10,"OAL":80,"LB":40,"SFDM":10,"TA":40,"shoulder-diameter":8.45)");
  EXPECT_EQ(notes_of(whole, "import-contradiction"),
            "one.json:1: warning: tool T9 \"x\": shoulder-diameter 8.45 mm, but DC 20 mm, LCF 10 mm and a side leaning "
            "inward by 40 degrees give 3.218 mm at the top of the flutes; built from these [import-contradiction]\n");
}

TEST(ImportFusion, ALollipopEndsWhereItsFlutesDo) {
  const ImportedTools made =
      import_one("lollipop mill",
                 R"("DC":12,"LCF":10.8,"OAL":72,"LB":36,"SFDM":6,"RE":6,"shoulder-diameter":6,"shoulder-length":10.8)");
  const Profile profile = *make_cutter_profile(cutter_of(made));
  EXPECT_NEAR(profile.elements.back().a.x(), 3.6, 1e-12);  // sqrt(36 - 4.8^2)
  EXPECT_NEAR(profile.elements.back().a.y(), 10.8, 1e-12);
  test::expect_segment(made.library.tools[0].shank.at(0), 6, 6, 25.2);
}

TEST(ImportFusion, AProbeRemovesNoStock) {
  const std::string geometry =
      R"("DC":6,"LCF":5.4,"OAL":72,"LB":36,"SFDM":3,"RE":3,"shoulder-diameter":3,"shoulder-length":36)";
  const ImportedTools made = import_one("probe", geometry);
  ASSERT_EQ(made.library.tools.size(), 1u);
  EXPECT_FALSE(made.library.tools[0].cuts);
  EXPECT_NE(notes_of(made, "import-guess").find("it removes no stock"), std::string::npos) << all_notes(made);
  EXPECT_TRUE(import_one("lollipop mill", geometry).library.tools[0].cuts);
}

TEST(ImportFusion, ASlotMillIsADiscOnANeck) {
  const ImportedTools made = import_one(
      "slot mill",
      R"("DC":20,"LCF":4,"OAL":120,"LB":60,"SFDM":6.67,"RE":0.5,"shoulder-diameter":6.67,"shoulder-length":20)");
  const auto slot = std::get<TSlotCutter>(cutter_of(made));
  EXPECT_EQ(slot.diameter_mm, 20);
  EXPECT_EQ(slot.length_mm, 4);
  EXPECT_EQ(slot.corner_radius_mm, 0.5);
  test::expect_segment(made.library.tools[0].shank.at(0), 6.67, 6.67, 16);
}

TEST(ImportFusion, ARadiusMillIsSmallestAtItsDiameter) {
  const ImportedTools made =
      import_one("radius mill",
                 R"("DC":12,"LCF":12,"OAL":72,"LB":36,"SFDM":24,"RE":6,"shoulder-diameter":24,"shoulder-length":12)");
  const Profile profile = *make_cutter_profile(cutter_of(made));
  ASSERT_GE(profile.elements.size(), 3u);
  EXPECT_EQ(profile.elements[0].b, Vec2(6, 0));
  EXPECT_TRUE(profile.elements[1].is_concave);
  EXPECT_EQ(profile.elements[1].center, Vec2(12, 0));
  EXPECT_EQ(profile.elements[1].b, Vec2(12, 6));
  EXPECT_EQ(notes_of(made, "import-contradiction"), "");
}

TEST(ImportFusion, AFaceMillMayHaveAnEdgeThatLeans) {
  const ImportedTools made =
      import_one("face mill", R"("DC":50,"DCX":62,"LCF":12,"OAL":96,"LB":48,"SFDM":50,"TA":45,"RE":0)");
  const Profile profile = *make_cutter_profile(cutter_of(made));
  EXPECT_TRUE(profile.elements.at(1).b.isApprox(Vec2(31, 6), 1e-12));
  EXPECT_EQ(
      notes_of(import_one("face mill", R"("DC":50,"DCX":62,"LCF":12,"OAL":96,"LB":48,"SFDM":50)"), "import-field"),
      "one.json:1: error: tool T9 \"x\": DCX 62 mm is greater than DC 50 mm, but the file gives no angle of the edge "
      "between them [import-field]\n");
}

TEST(ImportFusion, ABarrelIsWidestAtItsAxialDistance) {
  const ImportedTools made = import_one(
      "circle segment barrel", R"("DC":12,"LCF":24,"OAL":72,"LB":72,"SFDM":6,"profile-radius":48,"axial-distance":12,)"
                               R"("lower-radius":0,"upper-radius":0)");
  const Profile profile = *make_cutter_profile(cutter_of(made));
  EXPECT_NEAR(profile.elements.at(0).b.x(), 4.475800, 1e-6);  // 6 - (48 - sqrt(48^2 - 12^2))
  EXPECT_EQ(profile.elements.at(1).center, Vec2(-42, 12));
  EXPECT_EQ(profile.elements.at(1).radius_mm, 48);
}

TEST(ImportFusion, AnOvalsTipFollowsFromWhereItsFlankEnds) {
  const ImportedTools made =
      import_one("circle segment oval",
                 R"("DC":6,"LCF":19.76,"OAL":60,"LB":60,"SFDM":6,"RE":0,"lower-radius":0,"profile-radius":90)");
  EXPECT_NEAR(std::get<OvalCutter>(cutter_of(made)).corner_radius_mm, 1, 1e-3);
  EXPECT_EQ(notes_of(made, "import-guess"),
            "one.json:1: note: tool T9 \"x\": no radius of the tip is given; taken as 1.0004 mm, with which the flank "
            "ends at LCF 19.76 mm [import-guess]\n");
}

TEST(ImportFusion, ALensWithAnImpossibleCornerIsBuiltFromItsTipDiameter) {
  const ImportedTools made = import_one(
      "circle segment lens",
      R"("DC":10,"LCF":20,"OAL":40,"LB":40,"SFDM":10,"lower-radius":10,"profile-radius":100,"tip-diameter":8)");
  EXPECT_EQ(std::get<LensCutter>(cutter_of(made)).corner_radius_mm, 1);
  EXPECT_EQ(notes_of(made, "import-contradiction"),
            "one.json:1: warning: tool T9 \"x\": corner radius 10 mm is larger than half of DC 10 mm; built with 1 mm, "
            "which follows from tip-diameter 8 mm [import-contradiction]\n");
}

TEST(ImportFusion, ATaperedCircleSegmentTouchesTipAndUpperEnd) {
  const ImportedTools made =
      import_one("circle segment taper",
                 R"("DC":16,"LCF":15.69,"OAL":64,"LB":64,"SFDM":16,"TA":20,"lower-radius":4,"upper-radius":8,)"
                 R"("profile-radius":500)");
  const Profile profile = *make_cutter_profile(cutter_of(made));
  ASSERT_EQ(profile.elements.size(), 4u) << "tip, flank, upper arc, top";
  EXPECT_NEAR(profile.elements[2].b.y(), 15.695218, 1e-6);  // 4 + (8 - 4) / sin 20
  EXPECT_NEAR(profile.elements[2].b.x(), 8, 1e-12);
  for (std::size_t i = 0; i + 2 < profile.elements.size(); ++i)
    EXPECT_TRUE(end_direction(profile.elements[i]).isApprox(start_direction(profile.elements[i + 1]), 1e-6)) << i;
}

TEST(ImportFusion, ThreadsAreTakenAsFullAndReported) {
  for (const char* shape : {"thread mill", "tap right hand", "tap left hand", "boring bar"})
    EXPECT_EQ(notes_of(import_one(shape, R"("DC":10,"LCF":9,"OAL":50,"LB":30,"SFDM":10)"), "import-guess"),
              "one.json:1: note: tool T9 \"x\": taken as a full cylinder of DC 10 mm along its flutes, which is the "
              "larger tool [import-guess]\n");
}

TEST(ImportFusion, ACentreDrillHasPilotAndCone) {
  const ImportedTools made = import_one(
      "center drill", R"("DC":6,"LCF":12,"OAL":36,"LB":18,"SFDM":6,"SIG":118,"TA":90,"tip-diameter":2,"tip-length":2)");
  const Profile profile = *make_cutter_profile(cutter_of(made));
  EXPECT_NEAR(profile.elements.at(0).b.y(), 0.600861, 1e-6);  // 1 / tan 59
  EXPECT_EQ(profile.elements.at(1).b, Vec2(1, 2));
  EXPECT_TRUE(profile.elements.at(2).b.isApprox(Vec2(3, 4), 1e-12));
}

TEST(ImportFusion, AnEnteringAngleIsTheTaperFromTheOtherSide) {
  const ImportedTools made =
      import_one("face mill", R"("DC":50,"DCX":62,"APMX":12,"OAL":96,"LPR":48,"DCONMS":50,"KAPR":45)");
  EXPECT_EQ(std::get<FaceMillCutter>(cutter_of(made)).taper_angle_deg, 45);
}

TEST(ImportFusion, AHolderThatWouldSwallowTheFlutesIsAnError) {
  EXPECT_EQ(notes_of(import_one("flat end mill", R"("DC":10,"LCF":30,"OAL":50,"LB":25,"SFDM":10)"), "import-field"),
            "one.json:1: error: tool T9 \"x\": LCF 30 mm is greater than LB 25 mm; the holder would swallow a part of "
            "the flutes [import-field]\n");
  EXPECT_EQ(notes_of(import_one("flat end mill", R"("DC":10,"LCF":20,"OAL":50,"LB":55,"SFDM":10)"), "import-field"),
            "one.json:1: error: tool T9 \"x\": LB 55 mm is greater than OAL 50 mm; the tool would not reach its holder "
            "[import-field]\n");
}

TEST(ImportFusion, FieldsThatAreMissingOrWrongAreNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("LCF":20,"OAL":50,"LB":30)", "the file gives no diameter; this shape needs one"},
      {R"("DC":6,"OAL":50,"LB":30)", "the file gives no flute length; this shape needs one"},
      {R"("DC":-6,"LCF":20,"OAL":50,"LB":30)", "DC -6 mm is not possible; it must not be negative"},
      {R"("DC":"6,5,1","LCF":20,"OAL":50,"LB":30)",
       "DC is \"6,5,1\"; expected a number and a unit, such as \"6.0 mm\""},
      {R"("DC":"6 deg","LCF":20,"OAL":50,"LB":30)", "DC has the unit of an angle; expected a length"},
      {R"("DC":[6],"LCF":20,"OAL":50,"LB":30)", "DC is neither a number nor a text; expected a number"},
      {R"("DC":6,"SFDM":8,"DMM":10,"LCF":20,"OAL":50,"LB":30)",
       "SFDM and DMM are two names of one dimension, but have different values"}};
  for (const auto& [geometry, message] : cases)
    EXPECT_EQ(notes_of(import_one("flat end mill", geometry), "import-field"),
              "one.json:1: error: tool T9 \"x\": " + std::string(message) + " [import-field]\n");
  EXPECT_NE(all_notes(import_one("bull nose end mill", R"("DC":6,"RE":4,"LCF":20,"OAL":50,"LB":30)"))
                .find("corner_radius 4 mm is larger than half the diameter"),
            std::string::npos);
  EXPECT_NE(all_notes(import_one("drill", R"("DC":6,"LCF":20,"OAL":50,"LB":30)")).find("no point angle"),
            std::string::npos);
}

TEST(ImportFusion, AnEntryWithoutUnitIsLeftOut) {
  const Result<ImportedTools> made = import_fusion(
      "one.json", R"({"data":[{"type":"flat end mill","description":"x","geometry":{"DC":6,"LCF":9,"OAL":40}}]})", {});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(all_notes(*made),
            "one.json:1: error: tool \"x\": has no \"unit\"; each entry needs its own [import-field]\n"
            "one.json: error: no tool of this file could be imported [import-empty]\n");
}

TEST(ImportFusion, GaugeLengthsThatDisagreeAreReported) {
  const std::string holder = R"("holder":{"gaugeLength":40,"segments":[{"height":60,"lower-diameter":30,)"
                             R"("upper-diameter":40}]},)";
  const ImportedTools made =
      import_one("flat end mill", R"("DC":6,"LCF":20,"OAL":50,"LB":30,"SFDM":6,"assemblyGaugeLength":80)", holder);
  EXPECT_EQ(notes_of(made, "import-contradiction"),
            "one.json:1: warning: tool T9 \"x\": assemblyGaugeLength 80 mm is not LB 30 mm and gaugeLength 40 mm "
            "together; built from these two [import-contradiction]\n");
  EXPECT_NE(notes_of(made, "import-guess").find("reach 20 mm above the gauge line; they are kept"), std::string::npos);
  expect_segment(made.library.tools.at(0).holder.at(0), 30, 40, 60);
}

TEST(ImportFusion, AHolderWithoutStickOutIsAnError) {
  ImportOptions options;
  options.holder = {{30, 30, 50}};
  const std::string geometry = R"("DC":6,"LCF":20,"OAL":50,"SFDM":6)";
  EXPECT_NE(notes_of(import_one("flat end mill", geometry, "", options), "import-stickout").find("give --stickout"),
            std::string::npos);
  options.stickout_mm = 35;
  const ImportedTools made = import_one("flat end mill", geometry, "", options);
  expect_segment(made.library.tools.at(0).shank.at(0), 6, 6, 15);
  EXPECT_EQ(made.library.tools.at(0).holder.size(), 1u);
}

TEST(ImportFusion, AHolderThatIsNamedAloneIsMissing) {
  const std::string geometry = R"("DC":6,"LCF":20,"OAL":50,"LB":30,"SFDM":6)";
  const auto missing = [&](const std::string& holder, const ImportOptions& options = {}) {
    const ImportedTools made = import_one("flat end mill", geometry, holder, options);
    EXPECT_EQ(notes_of(made, "import-left-out").empty(),
              made.library.tools.at(0).missing_holder.empty() && options.holder.empty());
    return made.library.tools.at(0).missing_holder;
  };
  EXPECT_EQ(missing(R"("holder":"H100",)"), "its holder \"H100\" is not described in its entry, and is left out");
  EXPECT_EQ(missing(R"("holder":[1],)"), "its holder is not described in its entry, and is left out");
  EXPECT_EQ(missing(R"("holder":{"segments":[]},)"), "its holder has no segments");
  for (const char* none : {"", R"("holder":null,)", R"("holder":"",)"}) EXPECT_EQ(missing(none), "") << none;
  ImportOptions options;
  options.holder = {{30, 30, 50}};
  EXPECT_EQ(missing(R"("holder":"H100",)", options), "");
  options.holder_uncertainty = "holder \"E\": it has a key";
  EXPECT_EQ(import_one("flat end mill", geometry, "", options).library.tools.at(0).uncertainty,
            options.holder_uncertainty);
}

TEST(ImportFusion, AShaftLongerThanTheStickOutIsCutThere) {
  const ImportedTools made = import_one("flat end mill", R"("DC":6,"LCF":20,"OAL":50,"LB":30,"SFDM":12)",
                                        R"("shaft":{"segments":[{"height":20,"lower-diameter":6,"upper-diameter":12},)"
                                        R"({"height":5,"lower-diameter":12,"upper-diameter":12}]},)");
  ASSERT_EQ(made.library.tools.at(0).shank.size(), 1u);
  expect_segment(made.library.tools.at(0).shank[0], 6, 9, 10);
}

TEST(ImportFusion, TheZipIsTheSameLibrary) {
  const Result<ImportedTools> zipped = import_tools("shop.json", corpus("fusion-mill.tools"), std::nullopt, {});
  ASSERT_TRUE(zipped.has_value()) << to_text(zipped.error());
  const ImportedTools plain = import_corpus();
  EXPECT_EQ(write_tool_library(zipped->library), write_tool_library(plain.library));
  EXPECT_EQ(all_notes(*zipped), all_notes(plain));
}

TEST(ImportFusion, ADamagedZipIsAnError) {
  const std::string bytes = corpus("fusion-mill.tools");
  const Result<ImportedTools> cut = import_fusion("a.tools", bytes.substr(0, bytes.size() / 2), {});
  ASSERT_FALSE(cut.has_value());
  EXPECT_EQ(to_text(cut.error()),
            "a.tools: error: this zip archive is damaged; expected a tool library in it [import-zip]");
}

TEST(ImportFusion, ARoundTripLosesNothing) {
  const ImportedTools made = import_corpus();
  test::expect_round_trip(made.library);
  EXPECT_EQ(made.library.unit, LengthUnit::mm) << "mixed units are written in mm";
}

TEST(ImportFusion, FilesThatAreNoLibraryAreRefused) {
  const auto error = [](const std::string& bytes) {
    const Result<ImportedTools> made = import_fusion("a.json", bytes, {});
    return made ? "none" : to_text(made.error());
  };
  EXPECT_EQ(error("{\n\"data\": [}"),
            "a.json:2: error: this is not JSON: there is a mistake at or before column 10: found '\"data\": [}'; "
            "expected a Fusion tool library [import-syntax]");
  EXPECT_EQ(error("{\"data\": 3}"),
            "a.json: error: this JSON has no list \"data\"; expected a Fusion tool library [import-format]");
  EXPECT_EQ(error("{\"data\": [], \"data\": []}"),
            "a.json:1: error: the key /data is there twice; remove one [import-duplicate-key]");
  EXPECT_NE(error("{\"data\": [1e999]}").find("too large"), std::string::npos);
}

}  // namespace
}  // namespace gouge::import_fusion_test
