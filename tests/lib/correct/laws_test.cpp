#include "lib/correct/laws.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace gouge::laws_test {
namespace {

constexpr double kResolution_mm = 0.001;

MoveVerdict verdict(MoveState state, double depth = 0) {
  MoveVerdict v;
  v.state = state;
  v.depth_mm = depth;
  v.depth_upper_mm = depth + kResolution_mm;
  return v;
}

bool is_allowed(const MoveVerdict& before, const MoveVerdict& after) {
  return is_no_worse_than(before, after, kResolution_mm);
}

TEST(Laws, CleanStaysClean) {
  const MoveVerdict clean = verdict(MoveState::clean);
  EXPECT_TRUE(is_allowed(clean, clean));
  for (const MoveState state :
       {MoveState::near_miss, MoveState::gouge, MoveState::buried, MoveState::not_checked, MoveState::not_certified})
    EXPECT_FALSE(is_allowed(clean, verdict(state, 0.02))) << state_name(state);
}

TEST(Laws, AGougeBecomesNoDeeperAndNothingWorse) {
  const MoveVerdict gouge = verdict(MoveState::gouge, 0.5);
  EXPECT_TRUE(is_allowed(gouge, verdict(MoveState::clean)));
  EXPECT_TRUE(is_allowed(gouge, verdict(MoveState::near_miss)));
  EXPECT_TRUE(is_allowed(gouge, verdict(MoveState::gouge, 0.5)));
  EXPECT_FALSE(is_allowed(gouge, verdict(MoveState::gouge, 0.51)));
  for (const MoveState state : {MoveState::buried, MoveState::not_checked, MoveState::not_certified})
    EXPECT_FALSE(is_allowed(gouge, verdict(state))) << state_name(state);
}

TEST(Laws, WhatWasBuriedOrUncertainAndChangesMustBecomeClean) {
  for (const MoveState state : {MoveState::buried, MoveState::not_checked, MoveState::not_certified}) {
    EXPECT_TRUE(is_allowed(verdict(state), verdict(MoveState::clean)));
    EXPECT_FALSE(is_allowed(verdict(state), verdict(state))) << state_name(state);
    EXPECT_FALSE(is_allowed(verdict(state), verdict(MoveState::gouge, 0.02)));
  }
}

struct Two {
  Toolpath before = paths::through({paths::upright(0, 0, 0), paths::upright(10, 0, 0), paths::upright(20, 0, 0)});
  Toolpath after = before;
  CheckResult was, is;
  std::vector<PathChange> changes;

  Two() {
    was.verdicts.assign(3, verdict(MoveState::clean));
    is = was;
  }
  [[nodiscard]] std::vector<std::size_t> worse() const {
    CheckOptions options;
    options.resolution_mm = kResolution_mm;
    return find_worse({&before, &was}, changes, {&after, &is}, options);
  }
};

TEST(Laws, AMoveThatNoChangeNamesIsTheSame) {
  Two two;
  EXPECT_TRUE(two.worse().empty());
  two.after.moves[1].end.tip.y() = 1e-9;
  EXPECT_EQ(two.worse(), (std::vector<std::size_t>{1}));
}

TEST(Laws, TheMoveBehindAChangedPositionIsHeldToItsVerdict) {
  Two two;
  two.changes = {{1, paths::upright(10, 0, 1), {}}};
  two.after.moves[1].end.tip.z() = 1;
  EXPECT_TRUE(two.worse().empty());
  two.is.verdicts[2] = verdict(MoveState::gouge, 0.1);
  EXPECT_EQ(two.worse(), (std::vector<std::size_t>{2}));
}

TEST(Laws, AnInsertedMoveIsHeldToTheVerdictOfTheMoveItIsPartOf) {
  Two two;
  two.changes = {{2, std::nullopt, {paths::upright(15, 0, 1)}}};
  Move inserted = two.after.moves[2];
  inserted.end.tip = Vec3(15, 0, 1);
  two.after.moves.insert(two.after.moves.begin() + 2, inserted);
  two.is.verdicts.push_back(verdict(MoveState::clean));
  EXPECT_TRUE(two.worse().empty());
  two.is.verdicts[2] = verdict(MoveState::buried);
  EXPECT_EQ(two.worse(), (std::vector<std::size_t>{2}));
}

// A feed has a corrected end, or a rapid a corrected start. The motion back to the programmed position still gouges.
TEST(Laws, AFeedMayGoBackWhereARapidStaysAndARapidMayNot) {
  for (const bool is_rapid_back : {false, true}) {
    Two two;
    two.before.moves[2].kind = two.after.moves[2].kind = MoveKind::rapid;
    for (const std::size_t i : {1U, 2U}) two.was.verdicts[i] = verdict(MoveState::gouge, 0.1);
    const Pose high = paths::upright(10, 0, 1);
    two.is.verdicts.assign(4, verdict(MoveState::gouge, 0.1));
    two.is.verdicts[0] = two.is.verdicts[1] = verdict(MoveState::clean);
    two.after.moves.insert(two.after.moves.begin() + 2, two.after.moves[is_rapid_back ? 2 : 1]);
    two.after.moves[1].end = high;
    two.after.moves[2].end = two.before.moves[1].end;
    two.changes = {{1, std::nullopt, {high}}};
    if (is_rapid_back) two.changes = {{1, high, {}}, {2, std::nullopt, {two.before.moves[1].end}}};
    EXPECT_EQ(two.worse(), is_rapid_back ? std::vector<std::size_t>{2} : std::vector<std::size_t>{});
    // Before another feed the motion back to the end serves no purpose.
    two.before.moves[2].kind = two.after.moves[3].kind = MoveKind::feed;
    if (is_rapid_back) two.after.moves[2].kind = MoveKind::feed;
    EXPECT_EQ(two.worse(), is_rapid_back ? std::vector<std::size_t>{} : std::vector<std::size_t>{1});
  }
}

TEST(Laws, AnArcThatReadsAsAnotherIsWorseHoweverCleanItIs) {
  Two two;
  const PathArc arc{Vec3(15, 0, 0), Vec3::UnitZ(), 3};
  PathChange change{2, std::nullopt, {paths::upright(15, 0, 1)}};
  change.new_arc = arc;
  change.inserted_arcs = {arc};
  two.changes = {change};
  for (Toolpath* path : {&two.before, &two.after}) {
    path->arcs = {arc};
    path->moves[2].kind = MoveKind::arc;
    path->moves[2].curve_kind = CurveKind::arc;
    path->moves[2].curve = 0;
  }
  Move inserted = two.after.moves[2];
  inserted.end.tip = Vec3(15, 0, 1);
  two.after.moves.insert(two.after.moves.begin() + 2, inserted);
  two.is.verdicts.push_back(verdict(MoveState::clean));
  EXPECT_TRUE(two.worse().empty());
  two.after.arcs[0].axis = -arc.axis;
  EXPECT_EQ(two.worse(), (std::vector<std::size_t>{2})) << "the other way round";
  two.after.arcs[0] = arc;
  two.after.moves[2].curve_kind = CurveKind::none;
  EXPECT_EQ(two.worse(), (std::vector<std::size_t>{2})) << "straight";
}

// A half circle about (15, 0, 0) that becomes two moves over (15, -5, 0); both verdicts are gouges of the same depth.
TEST(Laws, APieceOfACurveMayGougeOnItsOwnCircleAlone) {
  Two two;
  const PathArc whole{Vec3(15, 0, 0), Vec3::UnitZ(), 3.14}, half{Vec3(15, 0, 0), Vec3::UnitZ(), 1.57};
  PathChange change{2, std::nullopt, {paths::upright(15, -5, 0)}};
  change.new_arc = half;
  change.inserted_arcs = {half};
  two.changes = {change};
  two.before.arcs = {whole};
  two.after.arcs = {half};
  for (Toolpath* path : {&two.before, &two.after}) {
    path->moves[2].kind = MoveKind::arc;
    path->moves[2].curve_kind = CurveKind::arc;
    path->moves[2].curve = 0;
  }
  Move inserted = two.after.moves[2];
  inserted.end.tip = Vec3(15, -5, 0);
  two.after.moves.insert(two.after.moves.begin() + 2, inserted);
  two.was.verdicts[2] = verdict(MoveState::gouge, 0.1);
  two.is.verdicts[2] = verdict(MoveState::gouge, 0.1);
  two.is.verdicts.push_back(verdict(MoveState::clean));
  EXPECT_TRUE(two.worse().empty()) << "a part of the programmed arc";
  two.after.arcs[0].center.y() = 0.1;
  EXPECT_EQ(two.worse(), (std::vector<std::size_t>{2})) << "another circle";
  two.is.verdicts[2] = verdict(MoveState::clean);
  EXPECT_TRUE(two.worse().empty()) << "which is clean";

  two.after.arcs[0] = half;
  two.changes[0].new_arc.reset();
  two.changes[0].inserted_arcs.clear();
  two.changes[0].is_straightened = true;
  for (const std::size_t k : {2U, 3U}) {
    two.after.moves[k].kind = MoveKind::feed;
    two.after.moves[k].curve_kind = CurveKind::none;
  }
  EXPECT_TRUE(two.worse().empty()) << "clean straight moves";
  two.is.verdicts[3] = verdict(MoveState::gouge, 0.05);
  EXPECT_EQ(two.worse(), (std::vector<std::size_t>{2})) << "a straight move that still gouges, if less deep";
}

TEST(Laws, AnotherNumberOfMovesIsWorseEverywhere) {
  Two two;
  two.after.moves.pop_back();
  two.is.verdicts.pop_back();
  EXPECT_EQ(two.worse().size(), 3U);
}

}  // namespace
}  // namespace gouge::laws_test
