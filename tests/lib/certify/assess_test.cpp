#include "lib/certify/assess.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// The assumptions that a whole check lists for its verdict.

namespace gouge::assess_test {
namespace {

// Twenty cuts along a floor at z = 0, `above` it.
Toolpath cuts(double above) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 20; ++i) poses.push_back(paths::upright(5.0 * i, 20, above));
  return paths::through(poses);
}

Scene floor_scene() { return {{shapes::box({-10, -10, -20}, {120, 60, 0})}, {}}; }

const Assumption& fact_of(const CheckResult& result, Subject subject) {
  for (const Assumption& fact : result.assumptions) {
    if (fact.subject == subject) return fact;
  }
  throw std::logic_error(std::string("no fact called ") + subject_name(subject));
}

CheckResult result_of(const Toolpath& path, const Scene& scene, const SetupBasis& basis = {}) {
  const ToolVariants tool = tools::flat();
  OwnSetup own(&tool, scene);
  own.setup.basis = basis;
  return check(path, own.setup);
}

TEST(Assess, AnOpenSurfaceWithoutAnEndIsUnknown) {
  MeshFindings findings;
  findings.may_be_cut_off = true;
  findings.signed_volume_mm3 = 1;
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::derived) << "what is closed is whole";
  findings.boundary_edges.count = findings.unbalanced_edges.count = 3;
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::unknown);
  findings.may_be_cut_off = false;
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::by_default);
}

TEST(Assess, AClosedSheetWithoutVolumeIsNoSolidThatIsDerived) {
  MeshFindings findings;
  findings.area_mm2 = 3200;
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::by_default);
  EXPECT_EQ(assume_solid("a.stl", findings).value, "without volume");
  findings.signed_volume_mm3 = 0.01 * findings.area_mm2;
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::derived) << "a foil of 0.02 mm";
}

/// Cuts 10 mm above the floor, with an approach at that height.
Toolpath approached(double height_mm = 10) {
  Toolpath path = cuts(height_mm);
  path.approaches = {{.line = 7, .axis = Vec3::UnitZ(), .height_mm = height_mm}};
  path.assumptions.push_back({.subject = Subject::completeness, .basis = Basis::derived});
  return path;
}

Assumption completeness_of(const OwnSetup& own, const Toolpath& path = approached()) {
  return fact_of(check(path, own.setup), Subject::completeness);
}

TEST(Assess, AnApproachIsClearAboveEverythingAlone) {
  const ToolVariants tool = tools::flat();
  const Scene scene = floor_scene();
  const OwnSetup own(&tool, scene);
  EXPECT_EQ(completeness_of(own).basis, Basis::derived);
  EXPECT_EQ(completeness_of(own, approached(0.001)).basis, Basis::derived);
  const Assumption at_top = completeness_of(own, approached(0));
  EXPECT_EQ(at_top.code, "gcode-approach");
  EXPECT_EQ(at_top.line, 7U);
  EXPECT_NE(at_top.evidence.find("the tool is at height 0 mm, not above the top of 0 mm, and"), std::string::npos)
      << at_top.evidence;
}

TEST(Assess, AnApproachIsAtTheLowestPointOfTheHeads) {
  const ToolVariants tool = tools::flat();
  const Scene scene = floor_scene();
  const auto with_head = [&](double low_mm) {
    const OwnSetup own(&tool, scene, {}, {*build_head_body(shapes::box({20, -5, low_mm}, {30, 5, 60}))});
    return completeness_of(own);
  };
  EXPECT_EQ(with_head(-9).basis, Basis::derived);
  const Assumption deep = with_head(-20);
  EXPECT_EQ(deep.basis, Basis::unknown);
  EXPECT_NE(deep.evidence.find("tool and heads, with offsets and tolerances, is at height -10 mm, not above"),
            std::string::npos)
      << deep.evidence;
}

TEST(Assess, AnApproachKeepsClearancesAndStockToLeave) {
  const ToolVariants tool = tools::flat(), leaving = tools::variants(tools::assembly(FlatCutter{10, 30}), 11);
  Scene scene = floor_scene();
  EXPECT_EQ(completeness_of(OwnSetup(&leaving, scene)).basis, Basis::unknown);
  scene.fixtures = {shapes::box({0, 200, 0}, {10, 210, 5})};
  EXPECT_EQ(completeness_of(OwnSetup(&tool, scene)).basis, Basis::derived);
  scene.limits = {{.against = Against::fixture, .mesh = 0, .clearance_mm = 4, .tolerance_mm = 0}};
  EXPECT_EQ(completeness_of(OwnSetup(&tool, scene)).basis, Basis::derived);
  scene.limits[0].clearance_mm = 6;
  const Assumption close = completeness_of(OwnSetup(&tool, scene));
  EXPECT_EQ(close.basis, Basis::unknown);
  EXPECT_NE(close.evidence.find("not above the top of 11 mm with its clearance"), std::string::npos) << close.evidence;
}

TEST(Assess, AnApproachIsAsLowAsTheTubeOfItsMotion) {
  const Scene scene = floor_scene();
  const auto within = [&](double tip_mm) {
    CheckOptions options;
    options.tube.tip_mm = tip_mm;
    const ToolVariants tool =
        make_tool_variants(tools::assembly(FlatCutter{10, 30}), 0, 0, 0, false, options.tube).value();
    return completeness_of(OwnSetup(&tool, scene, options)).basis;
  };
  EXPECT_EQ(within(9), Basis::derived);
  EXPECT_EQ(within(10.5), Basis::unknown);
}

TEST(Assess, APathThatTouchesThePartEstablishesItsPlacement) {
  const CheckResult result = result_of(cuts(0), floor_scene());
  EXPECT_EQ(fact_of(result, Subject::placement).basis, Basis::derived);
  EXPECT_FALSE(has_open(result.assumptions));
}

TEST(Assess, APathThatStaysAwayContradictsItsPlacement) {
  const CheckResult result = result_of(cuts(15), floor_scene());
  EXPECT_EQ(result.counts.clean, result.verdicts.size()) << "every move by itself is clean";
  const Assumption& placement = fact_of(result, Subject::placement);
  EXPECT_EQ(placement.basis, Basis::contradicted);
  EXPECT_TRUE(placement.is_open);
  EXPECT_EQ(placement.code, "scene-misplaced");
  const CheckResult vouched = result_of(cuts(15), floor_scene(), {.vouched = {{Subject::placement, {}}}});
  EXPECT_FALSE(has_open(vouched.assumptions));
  EXPECT_EQ(fact_of(vouched, Subject::placement).evidence, placement.evidence) << "the evidence stays";
}

TEST(Assess, AFarSmallerPartContradictsTheUnitOfItsFileUnlessItIsStated) {
  const Scene small{{shapes::box({-0.4, -0.4, -0.8}, {4.7, 2.4, 0})}, {}};
  EXPECT_EQ(fact_of(result_of(cuts(0), small), Subject::mesh_unit).basis, Basis::contradicted);
  const CheckResult stated = result_of(cuts(0), small, {.mesh_unit = LengthUnit::mm});
  EXPECT_EQ(fact_of(stated, Subject::mesh_unit).basis, Basis::stated);
}

TEST(Assess, AFarLargerPartThatThePathDoesNotReachNamesTheUnitThatWouldFit) {
  const auto evidence_at = [](double low, double top) {
    const Scene large{{shapes::box({low, low, top - 20}, {low + 25.4 * 100, 900, top})}, {}};
    const Assumption fact = fact_of(result_of(cuts(0), large, {.mesh_unit = LengthUnit::inch}), Subject::placement);
    EXPECT_EQ(fact.basis, Basis::contradicted);
    return fact.evidence;
  };
  const std::string fitting = evidence_at(150, 0), elsewhere = evidence_at(150, -2000);
  EXPECT_NE(fitting.find(" times larger than the path; with --stl-units mm it would be"), std::string::npos) << fitting;
  EXPECT_EQ(elsewhere.find("--stl-units"), std::string::npos) << "also in mm it is not there: " << elsewhere;
}

TEST(Assess, ThePartWithinWhichAPathWouldLieWithAnotherUnitIsNamed) {
  // The path is 100 mm long, at the corner of a part of 400 mm that was read in inches.
  const auto evidence_of = [](const std::string& place) {
    const Scene inches{{shapes::box({-254, -254, -2540}, {9906, 7620, -127})}, {}};
    SetupBasis basis{.mesh_unit = LengthUnit::inch};
    basis.place = place;
    return fact_of(result_of(cuts(0), inches, basis), Subject::placement).evidence;
  };
  EXPECT_NE(evidence_of("").find("; with --stl-units mm the path would lie in the part"), std::string::npos)
      << evidence_of("");
  EXPECT_EQ(evidence_of("0,0,5").find("--stl-units"), std::string::npos) << "the part was moved";
}

TEST(Assess, AnAxisThatTurnsRestsOnTheGreatCircle) {
  Toolpath path = cuts(0);
  EXPECT_EQ(fact_of(result_of(path, floor_scene()), Subject::motion_law).basis, Basis::derived);
  path.moves.back().end.axis = Vec3(0, 0.1, 1).normalized();
  EXPECT_EQ(fact_of(result_of(path, floor_scene()), Subject::motion_law).basis, Basis::by_default);
  EXPECT_TRUE(has_open(result_of(path, floor_scene(), {.is_strict = true}).assumptions));
}

TEST(Assess, FactsOfThePathAndOfTheInputsAreInTheResult) {
  Toolpath path = cuts(0);
  path.assumptions = {{.subject = Subject::completeness, .basis = Basis::unknown, .value = "whole file"}};
  SetupBasis basis;
  basis.inputs = {{.subject = Subject::tool, .object = "T1", .basis = Basis::contradicted, .value = "flat D 10"}};
  const CheckResult result = result_of(path, floor_scene(), basis);
  EXPECT_TRUE(fact_of(result, Subject::completeness).is_open);
  EXPECT_TRUE(fact_of(result, Subject::tool).is_open);
}

}  // namespace
}  // namespace gouge::assess_test
