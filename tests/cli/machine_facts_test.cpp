#include "cli/machine/machine_facts.h"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "tests/lib/machine/machines.h"

namespace gouge::machine_facts_test {
namespace {

/// Returns two rapids with the tool upright.
Toolpath path_of_rapids() {
  Toolpath path;
  path.moves.resize(2);
  for (Move& move : path.moves) move.kind = MoveKind::rapid;
  path.moves[0].line = 3;
  path.moves[1].line = 4;
  path.moves[1].has_start = true;
  path.moves[1].end.tip = Vec3(30, 0, 20);
  return path;
}

std::shared_ptr<const JointPath> joints_at(const RotaryAngles& angles) {
  return std::make_shared<const JointPath>(JointPath{{angles, angles}, {angles, angles}});
}

Basis basis_of(const Toolpath& path, const Machine* machine) {
  return rapid_fact(path, MotionLaw(RapidMode::dogleg), machine).value().basis;
}

TEST(MachineFacts, ATurnedFrameContradictsAMachineWithoutAPartZero) {
  const Machine machine = test::machines()[0];
  Toolpath path;
  EXPECT_EQ(machine_facts(&machine, {}, path)[0].basis, Basis::stated);
  path.has_turned_frame = true;
  EXPECT_EQ(machine_facts(&machine, {}, path)[0].basis, Basis::contradicted);
  const Machine placed = place_part(machine, {});
  EXPECT_EQ(machine_facts(&placed, {}, path)[0].basis, Basis::stated);
}

TEST(MachineFacts, ASmoothingOfThePathNeedsATolerance) {
  Toolpath path;
  EXPECT_TRUE(machine_facts(nullptr, {}, path).empty());
  path.smoothing_line = 7;
  const Assumption open = machine_facts(nullptr, {}, path).at(0);
  EXPECT_EQ(open.basis, Basis::unknown);
  EXPECT_EQ(open.line, 7U);
  EXPECT_EQ(machine_facts(nullptr, {"", {}, true}, path).at(0).basis, Basis::stated) << "--tip-tolerance 0";
  Machine machine = test::machines()[0];
  EXPECT_EQ(machine_facts(&machine, {}, path).at(1).basis, Basis::unknown);
  machine.control.tip_tolerance_mm = 0.01;
  EXPECT_EQ(machine_facts(&machine, {}, path).at(1).basis, Basis::stated);
}

TEST(RapidFact, StraightRapidsOfSeveralAxesAreADefaultWithoutAMachine) {
  Toolpath path = path_of_rapids();
  EXPECT_EQ(rapid_fact(path, RapidMode::straight, nullptr).value().basis, Basis::by_default);
  EXPECT_FALSE(rapid_fact(path, RapidMode::skip, nullptr));
  const Machine machine = test::machines()[0];
  EXPECT_FALSE(rapid_fact(path, RapidMode::straight, &machine)) << "the law of its control keeps the tip on its line";
  path.moves[1].end.tip = Vec3(30, 0, 0);
  EXPECT_FALSE(rapid_fact(path, RapidMode::straight, nullptr)) << "one axis alone";
}

TEST(DoglegFact, IsListedWhereARapidRunsSo) {
  Toolpath path = path_of_rapids();
  EXPECT_TRUE(rapid_fact(path, RapidMode::dogleg, nullptr));
  path.moves[1].kind = MoveKind::feed;
  EXPECT_FALSE(rapid_fact(path, RapidMode::dogleg, nullptr));
}

TEST(DoglegFact, WithoutAMachineTheToolMustBeUpright) {
  Toolpath path = path_of_rapids();
  EXPECT_EQ(basis_of(path, nullptr), Basis::derived);
  path.moves[0].end.axis = Vec3(0.6, 0, 0.8);
  EXPECT_EQ(basis_of(path, nullptr), Basis::by_default);
  path.has_turned_frame = true;
  EXPECT_EQ(basis_of(path, nullptr), Basis::contradicted);
}

TEST(DoglegFact, ATableThatTurnsTheLinearAxesContradictsIt) {
  constexpr double kQuarter_rad = std::numbers::pi / 2;
  const Machine table = test::machines()[0], head = test::machines()[3];
  Toolpath path = path_of_rapids();
  EXPECT_EQ(basis_of(path, &table), Basis::contradicted) << "the angles are not known";
  EXPECT_EQ(basis_of(path, &head), Basis::derived);
  path.joints = joints_at({0, 0});
  EXPECT_EQ(basis_of(path, &table), Basis::derived);
  path.joints = joints_at({kQuarter_rad, 0});
  EXPECT_EQ(basis_of(path, &table), Basis::derived) << "X runs along Y of the part";
  path.joints = joints_at({0.3, 0});
  EXPECT_EQ(basis_of(path, &table), Basis::contradicted);
  EXPECT_EQ(rapid_fact(path, RapidMode::dogleg, &table)->line, 4U);
  RigidTransform turned;
  turned.rotation = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  const Machine placed = place_part(head, turned);
  EXPECT_EQ(basis_of(path, &placed), Basis::contradicted) << "the part is turned on the machine";
}

}  // namespace
}  // namespace gouge::machine_facts_test
