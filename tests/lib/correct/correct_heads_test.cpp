#include <gtest/gtest.h>

#include "lib/correct/correct_path.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// Corrections with bodies that move with the tool: a block beside the spindle, 100 mm above the tip, and a
// post 130 mm high that it runs into.

namespace gouge::correct_heads_test {
namespace {

using paths::upright;

struct Case {
  std::vector<Pose> poses;
  IndexedMesh part = shapes::box(Vec3(89, -1, 0), Vec3(91, 1, 130));
  double max_shift_mm = 40;

  [[nodiscard]] Scene scene() const {
    Scene scene;
    scene.parts = {part};
    return scene;
  }
};

const ToolVariants kTool = tools::ball(10);

std::vector<HeadBody> heads() { return {*build_head_body(shapes::box(Vec3(60, -20, 100), Vec3(120, 20, 160)))}; }

CheckResult check(const Scene& scene, const Toolpath& path, const std::vector<HeadBody>& heads) {
  return whole_check(path, &kTool, scene, {}, heads);
}

Correction propose(const Case& c, const std::vector<HeadBody>& heads) {
  const Scene scene = c.scene();
  const Toolpath path = paths::through(c.poses);
  CorrectOptions correct;
  correct.max_shift_mm = c.max_shift_mm;
  correct.strategies = BodyStrategies::all(Strategy::weighted);
  const OwnSetup own(&kTool, scene, {}, heads);
  return correct_path(path, gouge::check(path, own.setup), own.setup, correct);
}

std::vector<Pose> corrected_poses(const Case& c, const Correction& correction) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < c.poses.size(); ++i) {
    Pose end = c.poses[i];
    for (const PathChange& change : correction.changes) {
      if (change.move != i) continue;
      poses.insert(poses.end(), change.inserted_before.begin(), change.inserted_before.end());
      if (change.new_end) end = *change.new_end;
    }
    poses.push_back(end);
  }
  return poses;
}

TEST(CorrectHeads, LiftsTheHeadOverWhatItRunsIntoBetweenPositions) {
  const Case c{{upright(0, -80, 0), upright(0, 80, 0)}};
  const std::vector<HeadBody> bodies = heads();
  const Correction correction = propose(c, bodies);
  for (const Uncorrected& left : correction.uncorrected) ADD_FAILURE() << left.move << ": " << left.reason;
  const std::vector<Pose> poses = corrected_poses(c, correction);
  EXPECT_GT(poses.size(), c.poses.size());
  const CheckResult after = check(c.scene(), paths::through(poses), bodies);
  EXPECT_EQ(after.counts.clean, poses.size());
}

TEST(CorrectHeads, LiftsAPositionWhoseHeadIsInThePart) {
  const Case c{{upright(0, -80, 0), upright(0, -10, 0), upright(0, -80, 5)}};
  const std::vector<HeadBody> bodies = heads();
  const Correction correction = propose(c, bodies);
  for (const Uncorrected& left : correction.uncorrected) ADD_FAILURE() << left.move << ": " << left.reason;
  ASSERT_FALSE(correction.records.empty());
  const std::vector<Pose> poses = corrected_poses(c, correction);
  EXPECT_EQ(check(c.scene(), paths::through(poses), bodies).counts.clean, poses.size());
  // Only the head was in: it comes free 30 mm higher.
  for (const PathChange& change : correction.changes) {
    if (change.new_end) {
      EXPECT_NEAR(change.new_end->tip.z(), 30, 0.02);
    }
  }
}

TEST(CorrectHeads, SaysWhatItTakesWhereNoLiftServes) {
  Case c{{upright(0, -80, 0), upright(0, -10, 0), upright(0, 80, 0)}};
  c.max_shift_mm = 20;
  const Correction correction = propose(c, heads());
  EXPECT_TRUE(correction.changes.empty());
  ASSERT_EQ(correction.uncorrected.size(), 2U);
  for (const Uncorrected& left : correction.uncorrected) {
    EXPECT_NE(left.reason.find("the head is in the way"), std::string::npos) << left.reason;
    EXPECT_NE(left.reason.find("another tilt or a longer tool"), std::string::npos) << left.reason;
  }
}

TEST(CorrectHeads, ReportsABuriedHead) {
  Case c{{upright(0, -80, 0), upright(0, -79, 0)}};
  c.part = shapes::box(Vec3(30, -200, 60), Vec3(300, 200, 300));
  const Correction correction = propose(c, heads());
  EXPECT_TRUE(correction.changes.empty());
  ASSERT_EQ(correction.uncorrected.size(), 2U);
  EXPECT_EQ(correction.uncorrected[0].reason, "the head is buried: there is no way out to follow");
}

TEST(CorrectHeads, ThatAreFreeChangeNothing) {
  Case c{{upright(0, -80, 10), upright(0, -40, -0.3), upright(0, 0, 10)}};
  c.part = shapes::box(Vec3(-20, -60, -20), Vec3(20, 60, 0));
  const Correction with = propose(c, heads()), without = propose(c, {});
  ASSERT_EQ(with.changes.size(), without.changes.size());
  ASSERT_FALSE(with.changes.empty());
  for (std::size_t k = 0; k < with.changes.size(); ++k)
    EXPECT_EQ(with.changes[k].new_end.value_or(Pose{}).tip, without.changes[k].new_end.value_or(Pose{}).tip);
}

}  // namespace
}  // namespace gouge::correct_heads_test
