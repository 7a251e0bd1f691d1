#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "lib/correct/correct_path.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// Tilts that the written file does not allow: it is lifted instead, and the reason is named once.

namespace gouge::tilt_fallback_test {
namespace {

using paths::upright;

constexpr const char* kBeyond = "the machine cannot be there: joint A would be beyond its limit, 1 degrees";

/// A holder of 32 mm beside two walls 12 mm from a ball cutter of 10 mm, on a floor at z = 0.
struct BesideWalls {
  ToolVariants tool = tools::ball(10);
  Scene scene;
  Toolpath path;
  CorrectOptions correct;
  std::function<bool(const Move&)> is_beyond = [](const Move& move) { return move.end.axis.z() < 1; };

  BesideWalls() {
    scene.parts = {shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)),
                   shapes::box(Vec3(12, -90, -5), Vec3(60, -60, 55)), shapes::box(Vec3(12, 60, -5), Vec3(60, 90, 55))};
    std::vector<Pose> poses{upright(0, -150, 120)};
    for (double y = -150; y <= 150; y += 5) poses.push_back(upright(0, y, 0));
    poses.push_back(upright(0, 150, 120));
    path = paths::through(poses);
  }

  /// Applies the changes without a file. The machine cannot run the tilted moves, as after a limit of its joints.
  [[nodiscard]] Toolpath changed(const std::vector<PathChange>& changes) const {
    Toolpath after = path;
    after.moves.clear();
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const auto change = std::ranges::find(changes, i, &PathChange::move);
      Move move = path.moves[i];
      for (std::size_t k = 0; change != changes.end() && k < change->inserted_before.size(); ++k) {
        move.end = change->inserted_before[k];
        after.moves.push_back(move);
      }
      move.end = change != changes.end() && change->new_end ? *change->new_end : path.moves[i].end;
      after.moves.push_back(move);
    }
    for (std::size_t i = 0; i < after.moves.size(); ++i) {
      if (!is_beyond(after.moves[i])) continue;
      after.moves[i].not_checked_reason = kBeyond;
      if (i + 1 < after.moves.size()) after.moves[i + 1].not_checked_reason = kBeyond;
    }
    return after;
  }

  [[nodiscard]] LawfulCorrection run() const {
    const OwnSetup own(&tool, scene);
    const auto rewrite = [&](const std::vector<PathChange>& changes) -> Result<Toolpath> { return changed(changes); };
    Result<LawfulCorrection> done = correct_lawfully(path, check(path, own.setup), own.setup, correct, rewrite);
    EXPECT_TRUE(done);
    return std::move(*done);
  }
};

TEST(TiltFallback, LiftsARunWhoseTiltsTheMachineCannotRun) {
  const LawfulCorrection done = BesideWalls().run();
  EXPECT_EQ(done.after.result.counts.clean, done.after.path.moves.size());
  EXPECT_TRUE(done.correction.uncorrected.empty());
  ASSERT_EQ(done.correction.not_tilted.size(), 2U);
  for (const NotTilted& run : done.correction.not_tilted)
    EXPECT_NE(run.reason.find("joint A would be beyond its limit, 1 degrees"), std::string::npos) << run.reason;
}

TEST(TiltFallback, KeepsTheTiltsThatTheMachineCanRun) {
  BesideWalls walls;
  walls.is_beyond = [](const Move& move) { return move.end.axis.z() < 1 && move.end.tip.y() > 0; };
  const LawfulCorrection done = walls.run();
  EXPECT_EQ(done.after.result.counts.clean, done.after.path.moves.size());
  ASSERT_EQ(done.correction.not_tilted.size(), 1U);
  EXPECT_GT(walls.path.moves[done.correction.not_tilted[0].first].end.tip.y(), 0);
  EXPECT_TRUE(std::ranges::any_of(done.correction.records,
                                  [](const ChangeRecord& record) { return record.strategy == Strategy::tilt; }));
}

// The joints of all later moves depend on a tilt, also of moves that no change touches.
TEST(TiltFallback, LiftsIfATiltLeavesOtherMovesUnchecked) {
  BesideWalls walls;
  const auto plain = walls.is_beyond;
  bool is_any = false;
  walls.is_beyond = [&](const Move& move) {
    is_any = plain(move) || (is_any && move.end.tip.y() > -150);
    const bool is_last = move.end.tip.z() > 100 && move.end.tip.y() > 0;
    const bool is_now = is_last && is_any;
    if (is_last) is_any = false;
    return is_now;
  };
  const LawfulCorrection done = walls.run();
  EXPECT_EQ(done.after.result.counts.clean, done.after.path.moves.size());
  EXPECT_EQ(done.correction.not_tilted.size(), 2U);
}

TEST(TiltFallback, StatesAReasonOnceIfNoChangeIsAllowed) {
  BesideWalls walls;
  walls.is_beyond = [](const Move& move) {
    return move.end.axis.z() < 1 || (move.end.tip.z() > 0.1 && move.end.tip.z() < 119);
  };
  const LawfulCorrection done = walls.run();
  ASSERT_FALSE(done.correction.uncorrected.empty());
  for (const Uncorrected& left : done.correction.uncorrected) {
    const std::size_t first = left.reason.find("joint A");
    ASSERT_NE(first, std::string::npos) << left.reason;
    EXPECT_EQ(left.reason.find("joint A", first + 1), std::string::npos) << left.reason;
  }
}

}  // namespace
}  // namespace gouge::tilt_fallback_test
