#include "lib/verify/claimed_findings.h"

#include <gtest/gtest.h>

#include <array>

#include "lib/check/check_result.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"

namespace gouge::claimed_findings_test {
namespace {

Toolpath path_of(std::size_t moves) {
  std::vector<Pose> poses;
  for (std::size_t k = 0; k < moves; ++k) poses.push_back(paths::upright(static_cast<double>(k), 0, 0));
  return paths::through(poses);
}

ListedMove gouge(std::size_t move, double depth_mm, Body body = Body::cutter) {
  return {.move = move, .state = ClaimedState::gouge, .depth_mm = depth_mm, .has_witness = true, .body = body};
}

ListedMove near(std::size_t move, double clearance_mm) {
  ListedMove one{.move = move, .state = ClaimedState::near, .has_witness = true, .body = Body::shank};
  one.clearance_mm = clearance_mm;
  return one;
}

TEST(GatherFindings, JoinsNeighboursAndNumbersTheWorstFirst) {
  const Toolpath path = path_of(10);
  const std::vector<ListedMove> moves = {gouge(1, 0.2), gouge(2, 0.5), gouge(4, 0.9), near(5, 0.4), near(6, 0.1)};
  const std::vector<GatheredFinding> found = gather_findings(path, moves, {}, false);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].first_move, 1U);
  EXPECT_EQ(found[0].last_move, 2U);
  EXPECT_EQ(found[0].worst_move, 2U);
  EXPECT_EQ(found[0].moves, 2U);
  EXPECT_EQ(found[0].number, 2U);
  EXPECT_EQ(found[1].number, 1U);
  EXPECT_EQ(found[2].worst_move, 6U);
  EXPECT_EQ(found[2].number, 3U);
}

TEST(GatherFindings, AnotherBodyToolOrOperationBeginsAnother) {
  Toolpath path = path_of(6);
  path.tools.resize(2);
  path.moves[3].tool = 1;
  path.moves[5].operation = 1;
  const std::vector<ListedMove> moves = {gouge(0, 1), gouge(1, 1, Body::holder), gouge(2, 1, Body::holder),
                                         gouge(3, 1, Body::holder), gouge(5, 1, Body::holder)};
  const std::vector<GatheredFinding> found = gather_findings(path, moves, {}, false);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[1].body, Body::holder);
  EXPECT_EQ(found[1].moves, 2U);
  EXPECT_EQ(found[2].tool, 1U);
}

TEST(GatherFindings, TakesAStatedChoiceOnlyAmongEqualsOfARoundedFile) {
  const Toolpath path = path_of(6);
  const std::vector<ListedMove> moves = {gouge(0, 0.5), gouge(1, 0.5), gouge(2, 0.4), gouge(4, 0.5)};
  const std::vector<StatedChoice> last_first = {{1, 2}, {4, 1}};
  EXPECT_EQ(gather_findings(path, moves, last_first, false)[0].worst_move, 0U);
  EXPECT_EQ(gather_findings(path, moves, last_first, false)[0].number, 1U);
  EXPECT_EQ(gather_findings(path, moves, last_first, true)[0].worst_move, 1U);
  EXPECT_EQ(gather_findings(path, moves, last_first, true)[0].number, 2U);
  const std::vector<StatedChoice> less_deep = {{2, 1}, {4, 2}};
  EXPECT_EQ(gather_findings(path, moves, less_deep, true)[0].worst_move, 0U);
}

TEST(GatherFindings, ABuriedFindingHasOneReason) {
  const Toolpath path = path_of(4);
  std::vector<ListedMove> moves;
  for (std::size_t k = 0; k < 4; ++k)
    moves.push_back({.move = k, .state = ClaimedState::buried, .body = Body::shank, .reason = k < 2 ? "a" : "b"});
  const std::vector<GatheredFinding> found = gather_findings(path, moves, {}, false);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].worst_move, 0U);
  EXPECT_EQ(found[1].first_move, 2U);
  EXPECT_EQ(found[1].number, 2U);
}

/// A random verdict, and the same as a result lists it.
std::pair<MoveVerdict, ListedMove> random_verdict(std::size_t move, test::Scatter& draw) {
  static constexpr std::array kStates = {MoveState::clean,  MoveState::near_miss,   MoveState::gouge,
                                         MoveState::buried, MoveState::not_checked, MoveState::not_certified};
  static constexpr std::array kReasons = {"a", "b"};
  const std::size_t state = draw.below(4) > 0 ? 2 : draw.below(6);
  MoveVerdict verdict;
  ListedMove listed{.move = move, .state = static_cast<ClaimedState>(state)};
  verdict.state = kStates.at(state);
  verdict.reason = {Reason::Kind::of_path, static_cast<Body>(draw.below(2)), 0,
                    std::string(kReasons.at(draw.below(2)))};
  listed.reason = verdict.reason.detail() == "a" ? kReasons[0] : kReasons[1];
  if (verdict.state == MoveState::buried) {  // its reason names the body, so equal reasons have equal bodies
    verdict.reason.body = listed.reason == "a" ? Body::cutter : Body::shank;
    listed.body = verdict.reason.body;
  } else if (verdict.state == MoveState::gouge || verdict.state == MoveState::near_miss || draw.below(2) == 0) {
    verdict.witness = Witness{.body = static_cast<Body>(draw.below(2)), .against = static_cast<Against>(draw.below(3))};
    listed.has_witness = true;
    listed.body = verdict.witness->body;
    listed.obstacle = static_cast<ClaimedObstacle>(verdict.witness->against);
    verdict.depth_mm = listed.depth_mm = static_cast<double>(draw.below(3));
  }
  if (verdict.state == MoveState::near_miss)
    verdict.clearance_mm = listed.clearance_mm = static_cast<double>(draw.below(3));
  return {verdict, listed};
}

// The check and the verifier gather by code of their own, and agree on any verdicts.
TEST(GatherFindings, AgreesWithTheCheck) {
  test::Scatter draw(5);
  for (int round = 0; round < 300; ++round) {
    Toolpath path = path_of(60);
    path.tools.resize(2);
    CheckResult result;
    std::vector<ListedMove> moves;
    for (std::size_t k = 0; k < path.moves.size(); ++k) {
      path.moves[k].tool = draw.below(12) == 0 ? 1 : 0;
      auto [verdict, listed] = random_verdict(k, draw);
      result.verdicts.push_back(std::move(verdict));
      if (listed.state != ClaimedState::clean) moves.push_back(listed);
    }
    summarise(path, result);
    const std::vector<GatheredFinding> found = gather_findings(path, moves, {}, false);
    ASSERT_EQ(found.size(), result.events.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Event& event = result.events[k];
      EXPECT_EQ(static_cast<int>(found[k].state), static_cast<int>(event.state));
      EXPECT_EQ(found[k].first_move, event.first_move);
      EXPECT_EQ(found[k].last_move, event.last_move);
      EXPECT_EQ(found[k].worst_move, event.worst_move);
      EXPECT_EQ(found[k].moves, event.moves);
      EXPECT_EQ(found[k].tool, event.tool);
      EXPECT_EQ(found[k].body, event.body);
      EXPECT_EQ(static_cast<int>(found[k].obstacle), static_cast<int>(event.against));
    }
  }
}

}  // namespace
}  // namespace gouge::claimed_findings_test
