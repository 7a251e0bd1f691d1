// How the result of the check against stock enters the verdicts.
#include <gtest/gtest.h>

#include "lib/certify/check.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::settle_stock_test {
namespace {

using paths::upright;

/// A block with its face at z = -20, in stock that is 20 mm higher.
class SettledStock : public testing::Test {
 protected:
  CheckResult check(const Toolpath& path) {
    const PreparedScene prepared(scene_, 1);
    CheckOptions options;
    options.threads = 1;
    StockSetup stock{.solid = StockSolid::box(Vec3(-50, -50, -40), Vec3(50, 50, 0)), .tools = {{&tool_, true}}};
    stock.heads = stock_heads(heads_);
    CheckSetup setup{{&tool_}, heads_, prepared, options};
    setup.stock = &stock;
    return gouge::check(path, setup);
  }

  ToolVariants tool_ = tools::flat(10);
  std::vector<HeadBody> heads_;
  Scene scene_{{shapes::box(Vec3(-50, -50, -40), Vec3(50, 50, -20))}, {}};
};

TEST_F(SettledStock, AMoveThatMeetsItIsAGougeAgainstTheStock) {
  Toolpath path = paths::through({upright(-80, 0, -5), upright(80, 0, -5)}, MoveKind::rapid);
  const CheckResult result = check(path);
  EXPECT_EQ(result.verdicts[0].state, MoveState::clean);
  ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
  EXPECT_TRUE(result.verdicts[1].is_in_stock());
  EXPECT_TRUE(result.verdicts[1].reason.is(Reason::Kind::stock_met));
  EXPECT_EQ(result.counts.gouge, 1U);
  ASSERT_EQ(result.events.size(), 1U);
  EXPECT_EQ(result.events[0].against, Against::stock);
  ASSERT_TRUE(result.stock.has_value());
  EXPECT_EQ(result.stock->examined, 2U);
  EXPECT_EQ(result.stock->clear, 1U);
  EXPECT_EQ(result.stock->contacts.size(), 1U);
  // The gap of a depth in stock is no gap of a depth in the part.
  EXPECT_EQ(result.largest_gap_mm, 0);
}

TEST_F(SettledStock, AGougeOfThePartStays) {
  const CheckResult result = check(paths::through({upright(-80, 0, -25), upright(80, 0, -25)}, MoveKind::rapid));
  ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
  EXPECT_FALSE(result.verdicts[1].is_in_stock());
  EXPECT_EQ(result.stock->contacts.size(), 1U);
}

TEST_F(SettledStock, AWayThatTheFileDoesNotStateIsNoFinding) {
  Toolpath path = paths::through({upright(-80, 0, -5), upright(80, 0, -5)});
  path.moves[1].has_start = false;
  path.moves[1].is_linked = true;
  const CheckResult result = check(path);
  EXPECT_EQ(result.verdicts[1].state, MoveState::not_checked);
  EXPECT_EQ(result.counts.gouge, 0U);
}

TEST_F(SettledStock, MaterialNearAnUnknownMotionIsNotCertified) {
  Toolpath path = paths::through(
      {upright(-80, 0, 20), upright(0, 0, -5), upright(0, 0, 40), upright(0, 10, 40), upright(0, 10, -5)});
  path.moves[1].not_checked_reason = "the tool radius compensation is on";
  path.moves[4].kind = MoveKind::rapid;
  const CheckResult result = check(path);
  EXPECT_EQ(result.verdicts[1].state, MoveState::not_checked);
  EXPECT_EQ(result.verdicts[4].state, MoveState::not_certified);
  EXPECT_TRUE(result.verdicts[4].reason.is(Reason::Kind::stock_unknown));
}

/// A head 60 mm beside the tool: its lower face is 20 mm above the tip.
HeadBody side_head() { return *build_head_body(shapes::box(Vec3(60, -10, 20), Vec3(90, 10, 50))); }

TEST_F(SettledStock, AHeadThatMeetsItIsNamed) {
  heads_.push_back(side_head());
  const CheckResult result = check(paths::through({upright(-80, -90, -25), upright(-80, 90, -25)}));
  const MoveVerdict& met = result.verdicts[1];
  ASSERT_EQ(met.state, MoveState::gouge);
  EXPECT_TRUE(met.is_in_stock());
  EXPECT_EQ(met.witness->body, Body::head);
  EXPECT_EQ(met.reason.body, Body::head);
  EXPECT_NEAR(met.depth_upper_mm, 5, 0.3);
  // The head leaves the material upwards.
  EXPECT_NEAR(met.witness->normal.z(), 1, 1e-9);
  ASSERT_EQ(result.events.size(), 1U);
  EXPECT_EQ(result.events[0].body, Body::head);
}

TEST_F(SettledStock, AHeadNearAnUnknownMotionIsNotCertified) {
  heads_.push_back(side_head());
  Toolpath path =
      paths::through({upright(-80, -90, 20), upright(-80, 0, 20), upright(-80, -90, -25), upright(-80, 90, -25)});
  path.moves[1].not_checked_reason = "the tool radius compensation is on";
  path.moves[2].has_start = false;
  const CheckResult result = check(path);
  const MoveVerdict& open = result.verdicts[3];
  ASSERT_EQ(open.state, MoveState::not_certified);
  EXPECT_TRUE(open.reason.is(Reason::Kind::stock_unknown));
  EXPECT_NE(reason_text(open.reason).find("stock is still in the head is not known: the motion of line"),
            std::string::npos)
      << reason_text(open.reason);
}

TEST_F(SettledStock, MaterialThatAHeadTouchedIsOpenForTheTool) {
  heads_.push_back(side_head());
  Toolpath path = paths::through({upright(-80, 0, -22), upright(-80, 0, 90), upright(-5, 0, 90), upright(-5, 0, -1.5)},
                                 MoveKind::rapid);
  EXPECT_EQ(check(path).verdicts[3].state, MoveState::not_certified);
  heads_.clear();
  EXPECT_EQ(check(path).verdicts[3].state, MoveState::gouge);
}

}  // namespace
}  // namespace gouge::settle_stock_test
