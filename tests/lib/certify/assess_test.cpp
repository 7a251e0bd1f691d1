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
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::derived) << "what is closed is whole";
  findings.boundary_edges.count = findings.unbalanced_edges.count = 3;
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::unknown);
  findings.may_be_cut_off = false;
  EXPECT_EQ(assume_solid("a.stl", findings).basis, Basis::by_default);
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
