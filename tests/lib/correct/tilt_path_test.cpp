#include "lib/correct/tilt_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// A holder of 32 mm beside a wall 12 mm from a ball cutter of 10 mm, on a floor at z = 0.

namespace gouge::tilt_path_test {
namespace {

using paths::upright;

struct Beside {
  ToolVariants tool = tools::ball(10);
  Scene scene;
  Toolpath path;
  CorrectOptions correct;

  Beside() {
    scene.parts = {shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)),
                   shapes::box(Vec3(12, -30, -5), Vec3(60, 30, 90))};
    std::vector<Pose> poses{upright(0, -80, 120)};
    for (double y = -80; y <= 80; y += 4) poses.push_back(upright(0, y, 0));
    poses.push_back(upright(0, 80, 120));
    path = paths::through(poses);
  }

  [[nodiscard]] Correction propose() const {
    const OwnSetup own(&tool, scene);
    return correct_path(path, check(path, own.setup), own.setup, correct);
  }
};

bool turns_an_axis(const Correction& correction) {
  for (const PathChange& change : correction.changes) {
    if (change.new_end && std::abs(change.new_end->axis.x()) > 0.01) return true;
  }
  return false;
}

TEST(TiltPath, TiltsWhatIsAboveTheCutterUnlessAnotherStrategyIsAskedFor) {
  Beside beside;
  const Correction tilted = beside.propose();
  EXPECT_TRUE(turns_an_axis(tilted));
  EXPECT_TRUE(tilted.uncorrected.empty());
  EXPECT_TRUE(tilted.not_tilted.empty());
  for (const ChangeRecord& record : tilted.records) EXPECT_EQ(record.strategy, Strategy::tilt);
  beside.correct.strategies.of[static_cast<std::size_t>(Body::holder)] = Strategy::axis;
  beside.correct.max_shift_mm = 60;
  EXPECT_FALSE(turns_an_axis(beside.propose()));
}

TEST(TiltPath, OfAFileWithoutAxesWantsLeave) {
  Beside beside;
  RewritableMoves rewritable;
  rewritable.arc = rewritable.split = rewritable.hole = std::vector<bool>(beside.path.moves.size(), false);
  beside.correct.rewritable = &rewritable;
  const Correction refused = beside.propose();
  EXPECT_FALSE(turns_an_axis(refused));
  ASSERT_FALSE(refused.not_tilted.empty());
  EXPECT_NE(refused.not_tilted.front().reason.find("--allow-multax"), std::string::npos);
  beside.correct.may_add_axes = true;
  EXPECT_TRUE(turns_an_axis(beside.propose()));
  beside.correct.may_add_axes = false;
  rewritable.has_axes = true;
  EXPECT_TRUE(turns_an_axis(beside.propose()));
}

TEST(TiltPath, LeavesWhatIsFarFromTheCollisionAsItIs) {
  const Correction tilted = Beside().propose();
  for (const PathChange& change : tilted.changes) {
    // The wall ends at 30, the holder reaches 16 mm beyond, the tilt fades over 10 mm.
    const double y = Beside().path.moves[change.move].end.tip.y();
    EXPECT_LT(std::abs(y), 30 + 16 + 10 + 8);
  }
}

}  // namespace
}  // namespace gouge::tilt_path_test
