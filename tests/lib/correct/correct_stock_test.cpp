// Corrections out of remaining stock. Every corrected path is checked again against the stock, with its own cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/correct/correct_path.h"
#include "lib/correct/laws.h"
#include "tests/lib/stock/block.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::correct_stock_test {
namespace {

using block::kFeed;
using block::kRapid;
using block::path_of;
using block::Step;
using paths::upright;
constexpr double kClearance_mm = 1, kTolerance_mm = 0.1, kResolution_mm = 0.05;

/// A flat cutter of 10 mm with flutes of this length, a shank of 5 mm and a holder of 30 mm.
ToolAssembly flat(double flutes = 30) {
  ToolAssembly tool = tools::assembly(FlatCutter{10, flutes}, 10);
  tool.shank = {{10, 10, 5}};
  tool.holder = {{30, 30, 40}};
  return tool;
}

/// A path in a block of 100 x 100 x 40 mm whose top is z = 0. The part is its lowest layer.
struct Case {
  explicit Case(const std::vector<Step>& steps, const ToolAssembly& assembly = flat())
      : path(path_of(steps)), tool(tools::variants(assembly)) {
    constexpr double kRoom_mm = kClearance_mm + kTolerance_mm + 2 * kResolution_mm;
    roomy = tools::variants(assembly, kRoom_mm, kRoom_mm, kRoom_mm);
    scene.parts = {shapes::box(Vec3(-50, -50, -40), Vec3(50, 50, -35))};
    stock.tools = {{&tool, true}};
    stock.roomy = {&roomy.against_part};
    stock.roomy_mm = kRoom_mm;
  }

  /// Adds moves of a second tool with flutes of 60 mm. The first one is a position alone.
  void add_with_long_tool(const std::vector<Step>& steps) {
    long_tool = tools::variants(flat(60));
    stock.tools.push_back({&*long_tool, true});
    stock.roomy.push_back(nullptr);
    path.tools.resize(2);
    for (const Move& move : path_of(steps).moves) {
      path.moves.push_back(move);
      path.moves.back().tool = 1;
      path.moves.back().line = path.moves.size();
    }
  }

  /// As a writer does it: numbers of four decimals, inserted positions as moves of their own.
  [[nodiscard]] Toolpath applied(const std::vector<PathChange>& changes) const {
    Toolpath changed = path;
    changed.moves.clear();
    const auto round_tip = [](Pose pose) {
      for (int k = 0; k < 3; ++k) pose.tip[k] = std::round(pose.tip[k] * 1e4) / 1e4;
      return pose;
    };
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      Move move = path.moves[i];
      const auto change = std::ranges::find(changes, i, &PathChange::move);
      if (change != changes.end()) {
        for (const Pose& stop : change->inserted_before) {
          Move inserted = move;
          inserted.end = round_tip(stop);
          changed.moves.push_back(inserted);
        }
        if (change->new_end) move.end = round_tip(*change->new_end);
      }
      changed.moves.push_back(move);
    }
    return changed;
  }

  [[nodiscard]] LawfulCorrection correct() const {
    OwnSetup own(&tool, scene, options);
    if (long_tool) own.setup.tools.push_back(&*long_tool);
    const CheckResult result = check(path, own.setup);
    own.setup.stock = &stock;
    const RewritePath rewrite = [this](const std::vector<PathChange>& changes) -> Result<Toolpath> {
      return applied(changes);
    };
    return correct_lawfully(path, result, own.setup, correction, rewrite).value();
  }

  /// The check of a path with the stock.
  [[nodiscard]] CheckResult check_again(const Toolpath& of) const {
    OwnSetup own(&tool, scene, options);
    if (long_tool) own.setup.tools.push_back(&*long_tool);
    own.setup.stock = &stock;
    return check(of, own.setup);
  }

  Toolpath path;
  ToolVariants tool, roomy;
  std::optional<ToolVariants> long_tool;
  Scene scene;
  CheckOptions options;
  CorrectOptions correction;
  StockSetup stock{.solid = StockSolid::box(Vec3(-50, -50, -40), Vec3(50, 50, 0)),
                   .options = {.tolerance_mm = kTolerance_mm, .resolution_mm = kResolution_mm}};
};

void expect_clean_again(const Case& c, const LawfulCorrection& lawful) {
  for (const Uncorrected& left : lawful.correction.uncorrected) ADD_FAILURE() << "move " << left.move << left.reason;
  const CheckResult again = c.check_again(lawful.after.path);
  EXPECT_EQ(again.counts.clean, lawful.after.path.moves.size());
}

double highest_mm(const std::vector<Pose>& poses) {
  double highest = -1e9;
  for (const Pose& pose : poses) highest = std::max(highest, pose.tip.z());
  return highest;
}

/// Two holes 10 mm deep and the way between them at 8 mm below the top.
std::vector<Step> two_pockets() {
  return {{kRapid, upright(-20, 0, 5)},  {kFeed, upright(-20, 0, -10)}, {kRapid, upright(-20, 0, 5)},
          {kRapid, upright(20, 0, 5)},   {kFeed, upright(20, 0, -10)},  {kRapid, upright(20, 0, -8)},
          {kRapid, upright(-20, 0, -8)}, {kFeed, upright(-20, 0, -12)}};
}

TEST(CorrectStock, ARapidBetweenTwoPocketsGoesOverTheWall) {
  const Case c(two_pockets());
  const LawfulCorrection lawful = c.correct();
  expect_clean_again(c, lawful);
  ASSERT_EQ(lawful.correction.changes.size(), 1U);
  const PathChange& change = lawful.correction.changes.front();
  EXPECT_EQ(change.move, 6U);
  EXPECT_FALSE(change.new_end.has_value());
  ASSERT_EQ(change.inserted_before.size(), 2U);
  EXPECT_NEAR(change.inserted_before[0].tip.z(), change.inserted_before[1].tip.z(), 1e-9);
  // The wall reaches up to z = 0. The lift is the lowest with the clearance, up to the steps of the search.
  EXPECT_GE(highest_mm(change.inserted_before), kClearance_mm);
  EXPECT_LE(highest_mm(change.inserted_before), kClearance_mm + 0.5);
  ASSERT_TRUE(lawful.before.has_value());
  EXPECT_TRUE(lawful.before->verdicts[6].is_in_stock());
}

TEST(CorrectStock, ARapidCrossesInALowGateWhereItIsWideEnough) {
  // A gate 16 mm wide and 6 mm deep leads through the wall between the two pockets, and beyond them.
  std::vector<Step> steps{{kRapid, upright(-24, 0, 5)}};
  for (const double y : {-3.0, 0.0, 3.0}) {
    steps.push_back({kFeed, upright(-24, y, -6)});
    steps.push_back({kFeed, upright(24, y, -6)});
    steps.push_back({kRapid, upright(24, y, 5)});
    steps.push_back({kRapid, upright(-24, 0, 5)});
  }
  const std::vector<Step> pockets = two_pockets();
  steps.insert(steps.end(), pockets.begin(), pockets.end());
  const Case c(steps);
  const LawfulCorrection lawful = c.correct();
  expect_clean_again(c, lawful);
  ASSERT_EQ(lawful.correction.changes.size(), 1U);
  const double highest = highest_mm(lawful.correction.changes.front().inserted_before);
  EXPECT_GE(highest, -6 + kClearance_mm);
  EXPECT_LE(highest, -6 + kClearance_mm + 0.5);
}

TEST(CorrectStock, ARapidBetweenTwoAxesIsLiftedAlongBoth) {
  const Vec3 left = Vec3(-0.4, 0, 1).normalized(), right = Vec3(0.4, 0.2, 1).normalized();
  const auto at = [](double x, const Vec3& axis, double up) { return Pose{Vec3(Vec3(x, 0, 0) + up * axis), axis}; };
  const Case c({{kRapid, at(-20, left, 10)},
                {kFeed, at(-20, left, -10)},
                {kRapid, at(-20, left, 10)},
                {kRapid, at(20, right, 10)},
                {kFeed, at(20, right, -10)},
                {kRapid, at(-20, left, -8)},
                {kFeed, at(-20, left, -9)}});
  ASSERT_EQ(c.check_again(c.path).counts.gouge, 1U);
  const LawfulCorrection lawful = c.correct();
  expect_clean_again(c, lawful);
  ASSERT_EQ(lawful.correction.changes.size(), 1U);
  EXPECT_EQ(lawful.correction.changes.front().move, 5U);
}

TEST(CorrectStock, ARapidThatPlungesIntoMaterialIsListed) {
  const Case c({{kRapid, upright(-80, 0, 5)}, {kRapid, upright(0, 0, -5)}, {kFeed, upright(20, 0, -5)}});
  const LawfulCorrection lawful = c.correct();
  EXPECT_TRUE(lawful.correction.changes.empty());
  ASSERT_EQ(lawful.correction.uncorrected.size(), 1U);
  EXPECT_EQ(lawful.correction.uncorrected.front().move, 1U);
  EXPECT_NE(lawful.correction.uncorrected.front().reason.find("only a feed"), std::string::npos);
}

TEST(CorrectStock, APositionBetweenTwoRapidsIsLifted) {
  const Case c({{kRapid, upright(-80, 0, -5)}, {kRapid, upright(0, 20, -5)}, {kRapid, upright(80, 0, -5)}});
  const LawfulCorrection lawful = c.correct();
  expect_clean_again(c, lawful);
  ASSERT_FALSE(lawful.correction.changes.empty());
  EXPECT_EQ(lawful.correction.changes.front().move, 1U);
  ASSERT_TRUE(lawful.correction.changes.front().new_end.has_value());
  EXPECT_GE(lawful.correction.changes.front().new_end->tip.z(), kClearance_mm);
}

TEST(CorrectStock, ARapidThatOnlyACorrectionShowsIsCorrectedToo) {
  // The second rapid runs through the place where the first one was: what is left there is not known.
  const Case c({{kRapid, upright(-80, 0, -5)},
                {kRapid, upright(80, 0, -5)},
                {kRapid, upright(80, 0, 5)},
                {kRapid, upright(80, 0, -4)},
                {kRapid, upright(-80, 0, -4)}});
  const CheckResult before = c.check_again(c.path);
  EXPECT_EQ(before.verdicts[1].state, MoveState::gouge);
  EXPECT_EQ(before.verdicts[4].state, MoveState::not_certified);
  const LawfulCorrection lawful = c.correct();
  expect_clean_again(c, lawful);
  EXPECT_EQ(lawful.correction.changes.size(), 2U);
}

/// A slot in levels with a holder 20 mm above the tip.
std::vector<Step> levels(double lowest) {
  std::vector<Step> steps{{kRapid, upright(-80, 0, 20)}};
  for (const double z : {-10.0, -20.0, lowest}) {
    steps.push_back({kRapid, upright(-80, 0, z)});
    steps.push_back({kFeed, upright(80, 0, z)});
    steps.push_back({kRapid, upright(80, 0, 20)});
    steps.push_back({kRapid, upright(-80, 0, 20)});
  }
  return steps;
}

TEST(CorrectStock, AHolderInTheWallOfASlotIsLifted) {
  const Case c(levels(-25), flat(15));
  const LawfulCorrection lawful = c.correct();
  expect_clean_again(c, lawful);
  ASSERT_EQ(lawful.correction.changes.size(), 1U);
  const PathChange& change = lawful.correction.changes.front();
  EXPECT_EQ(change.move, 10U);
  EXPECT_GE(highest_mm(change.inserted_before), -20 - kTolerance_mm - kResolution_mm);
  EXPECT_LE(highest_mm(change.inserted_before), -19.5);
}

/// A ball cutter that finishes the floor 10 mm beside a wall of stock 60 mm high. Its holder reaches 10 mm into the wall.
struct WallCase : Case {
  WallCase()
      : Case({{kRapid, upright(-60, 10, 80)},
              {kRapid, upright(-60, 10, 0)},
              {kFeed, upright(-20, 10, 0)},
              {kFeed, upright(60, 10, 0)},
              {kFeed, upright(100, 10, 0)},
              {kRapid, upright(100, 10, 80)}},
             wide_tool()) {
    scene.parts = {shapes::box(Vec3(0, -40, -20), Vec3(40, 60, 0))};
    stock.solid = StockSolid::box(Vec3(0, 20, 0), Vec3(40, 60, 60));
  }

  static ToolAssembly wide_tool() {
    ToolAssembly tool = tools::assembly(BallCutter{10, 15}, 10);
    tool.shank = {{10, 10, 10}};
    tool.holder = {{40, 40, 40}};
    return tool;
  }
};

TEST(CorrectStock, AHolderBesideAWallOfStockIsTiltedAndTheFloorStaysCut) {
  const WallCase c;
  EXPECT_EQ(c.check_again(c.path).counts.gouge, 1U);
  const LawfulCorrection lawful = c.correct();
  expect_clean_again(c, lawful);
  EXPECT_TRUE(lawful.correction.not_tilted.empty());
  double lowest = 1, off_floor_mm = 0;
  for (const Move& move : lawful.after.path.moves) {
    if (move.end.tip.x() < 0 || move.end.tip.x() > 40) continue;
    lowest = std::min(lowest, move.end.axis.z());
    // The ball stays on the floor: its centre is 5 mm above it, along the tilted axis from the tip.
    const Vec3 centre = move.end.tip + 5 * move.end.axis;
    off_floor_mm = std::max(off_floor_mm, std::abs(centre.z() - 5));
  }
  EXPECT_LT(lowest, std::cos(0.1));
  EXPECT_LT(off_floor_mm, 0.02);
}

TEST(CorrectStock, OnlyALiftFreesTheHolderWhereTiltsAreNotAllowed) {
  WallCase c;
  c.correction.strategies = BodyStrategies::all(Strategy::axis);
  const LawfulCorrection lawful = c.correct();
  for (const Move& move : lawful.after.path.moves) EXPECT_TRUE(move.end.axis.isApprox(Vec3::UnitZ()));
  EXPECT_TRUE(lawful.correction.uncorrected.size() == 1 ||
              highest_mm(lawful.correction.changes.at(0).inserted_before) > 34);
}

TEST(CorrectStock, ALiftThatIsTooLongIsListed) {
  Case c(levels(-25), flat(15));
  c.correction.max_shift_mm = 2;
  const LawfulCorrection lawful = c.correct();
  EXPECT_TRUE(lawful.correction.changes.empty());
  ASSERT_EQ(lawful.correction.uncorrected.size(), 1U);
  EXPECT_NE(lawful.correction.uncorrected.front().reason.find("shank or holder"), std::string::npos);
}

TEST(CorrectStock, ALiftThatLeavesStockForALaterMoveIsTakenBack) {
  // A longer tool then goes down at rapid to the floor that only the lowest level cuts, and a cut begins there.
  Case c(levels(-25), flat(15));
  c.add_with_long_tool({{kRapid, upright(-20, 0, 20)}, {kRapid, upright(-20, 0, -25)}, {kFeed, upright(0, 0, -25)}});
  const CheckResult before = c.check_again(c.path);
  EXPECT_EQ(before.counts.gouge, 1U);
  EXPECT_EQ(before.counts.clean + 1, c.path.moves.size());
  const LawfulCorrection lawful = c.correct();
  EXPECT_TRUE(lawful.correction.changes.empty());
  ASSERT_EQ(lawful.correction.uncorrected.size(), 1U);
  EXPECT_EQ(lawful.correction.uncorrected.front().move, 10U);
  EXPECT_NE(lawful.correction.uncorrected.front().reason.find("into remaining stock"), std::string::npos);
  EXPECT_EQ(c.check_again(lawful.after.path).counts.gouge, 1U);
}

/// Cuts and rapids through the block, with a fixed axis or with a new one at each position.
std::vector<Step> random_steps(test::Scatter& random, bool is_tilted) {
  Vec3 axis = Vec3::UnitZ();
  const auto offset = [&random](double size, double low, double high) {
    Vec3 by = random.point(size);
    by.z() = random.in(low, high);
    return by;
  };
  std::vector<Step> steps{{kRapid, {offset(60, 30, 30), axis}}};
  for (int k = 0; k < 4; ++k) {
    Vec3 at = offset(45, -5, 5);
    if (is_tilted) axis = offset(0.4, 1, 1).normalized();
    steps.push_back({kRapid, {at, axis}});
    at.z() = random.in(-14, -3);
    steps.push_back({kFeed, {at, axis}});
    at += offset(40, -1, 1);
    steps.push_back({kFeed, {at, axis}});
    at.z() = random.in(-5, 3);
    steps.push_back({kRapid, {at, axis}});
  }
  steps.push_back({kRapid, upright(0, 0, 60)});
  return steps;
}

// The feed ends 0.2 mm deep in the part. The rapid after it stays in stock, because a cut begins at its end.
TEST(CorrectStock, ARapidThatStaysInStockBeginsAtTheCorrectedEndOfTheFeed) {
  Case c({{kRapid, upright(-20, 0, 5)},
          {kFeed, upright(-20, 0, -35.2)},
          {kRapid, upright(20, 0, -20)},
          {kFeed, upright(25, 0, -20)},
          {kRapid, upright(25, 0, 60)}},
         flat(60));
  const LawfulCorrection lawful = c.correct();
  ASSERT_EQ(lawful.correction.changes.size(), 1U);
  const PathChange& change = lawful.correction.changes.front();
  EXPECT_EQ(change.move, 1U);
  EXPECT_TRUE(change.inserted_before.empty());
  ASSERT_TRUE(change.new_end.has_value());
  EXPECT_NEAR(change.new_end->tip.z(), -35, 0.01);
  ASSERT_EQ(lawful.correction.uncorrected.size(), 1U);
  EXPECT_EQ(lawful.correction.uncorrected.front().move, 2U);
  EXPECT_FALSE(lawful.correction.uncorrected.front().is_changed);
}

TEST(CorrectStock, NoMoveOfRandomProgramsBecomesWorseAndChangedOnesAreCleanOrListed) {
  test::Scatter random(7);
  std::size_t changed = 0, freed = 0;
  for (int k = 0; k < 8; ++k) {
    const Case c(random_steps(random, k % 2 == 1), flat(k % 3 == 0 ? 8 : 20));
    const LawfulCorrection lawful = c.correct();
    const CheckResult before = c.check_again(c.path), after = c.check_again(lawful.after.path);
    const auto spans = moves_after(c.path.moves.size(), lawful.correction.changes);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const auto is_it = [i](const auto& thing) { return thing.move == i; };
      const bool is_listed = std::ranges::any_of(lawful.correction.uncorrected, is_it);
      const bool is_changed = std::ranges::any_of(lawful.correction.changes, is_it);
      const MoveState was = before.verdicts[i].state;
      changed += is_changed ? 1U : 0U;
      for (std::size_t m = spans[i].first; m < spans[i].last; ++m) {
        const MoveState is = after.verdicts[m].state;
        EXPECT_TRUE(was != MoveState::clean || is == MoveState::clean) << k << " move " << i;
        EXPECT_TRUE(is != MoveState::gouge || is_listed) << k << " move " << i;
        const bool is_claimed = is_changed && !is_listed && was == MoveState::gouge;
        EXPECT_TRUE(!is_claimed || is == MoveState::clean) << k << " move " << i;
      }
      freed += was == MoveState::gouge && !is_listed ? 1U : 0U;
    }
  }
  EXPECT_GT(changed, 10U);
  EXPECT_GT(freed, 10U);
}

}  // namespace
}  // namespace gouge::correct_stock_test
