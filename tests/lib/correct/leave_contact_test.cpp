#include <gtest/gtest.h>

#include "lib/correct/correct_path.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// Rapids that begin or end at a contact. A ball of 10 mm cuts 0.2 mm too deep at the start of the rapid.

namespace gouge::leave_contact_test {
namespace {

using paths::upright;

struct Case {
  Toolpath path;
  ToolVariants tool = tools::ball();
  Scene scene;
  CheckOptions options;
  CorrectOptions correct;
};

/// A cut down to the floor and a rapid from there.
Case rapid_to(const Pose& end, std::vector<IndexedMesh> more = {}) {
  Case c;
  c.path = paths::through({upright(0, 0, 20), upright(0, 0, -0.2), end});
  c.path.moves[2].kind = MoveKind::rapid;
  c.scene.parts = std::move(more);
  c.scene.parts.push_back(shapes::box(Vec3(-90, -90, -30), Vec3(90, 90, 0)));
  return c;
}

Correction propose(const Case& c) {
  const CheckResult before = whole_check(c.path, &c.tool, c.scene, c.options);
  return correct_path(c.path, before, OwnSetup(&c.tool, c.scene, c.options).setup, c.correct);
}

/// Returns the positions inserted in the rapid. Expects that the cut moves up to the floor.
std::vector<Pose> inserted_in_rapid(const Case& c, std::size_t rapid = 2) {
  const Correction correction = propose(c);
  EXPECT_TRUE(correction.uncorrected.empty());
  std::vector<Pose> inserted;
  for (const PathChange& change : correction.changes) {
    if (change.new_end) {
      EXPECT_EQ(change.move, 1U);
      EXPECT_NEAR(change.new_end->tip.z(), -0.005, 0.003);
    }
    if (change.move == rapid) inserted = change.inserted_before;
  }
  return inserted;
}

TEST(LeaveContact, AStraightRetractStaysAsProgrammed) {
  EXPECT_TRUE(inserted_in_rapid(rapid_to(upright(0, 0, 80))).empty());
  EXPECT_TRUE(inserted_in_rapid(rapid_to(upright(0, 0, 0.5))).empty()) << "it ends within the clearance";
  EXPECT_TRUE(inserted_in_rapid(rapid_to(upright(40, 0, 60))).empty()) << "it leads away from the part";
  EXPECT_TRUE(inserted_in_rapid(rapid_to(upright(0, 0, 15), {shapes::box(Vec3(5, -90, -1), Vec3(9, 90, 30))})).empty())
      << "it follows a wall";
}

TEST(LeaveContact, ARapidDownToAContactStaysAsProgrammed) {
  Case c = rapid_to(upright(0, 0, 20));
  c.path.moves[1].kind = MoveKind::rapid;
  c.path.moves[2].kind = MoveKind::feed;
  c.correct.max_shift_mm = 0.5;  // no lift to the clearance is possible
  EXPECT_TRUE(inserted_in_rapid(c, 1).empty());
}

TEST(LeaveContact, ARapidThatGrazesThePartElsewhereGetsItsClearance) {
  // The programmed line passes the edge of the post at 0.3 mm.
  Case c = rapid_to(upright(40, 0, 30), {shapes::box(Vec3(16, -50, -1), Vec3(24, 50, 10.375))});
  const std::vector<Pose> inserted = inserted_in_rapid(c);
  ASSERT_FALSE(inserted.empty());
  Case near = c;
  near.correct.rapid_clearance_mm = 0.2;
  EXPECT_TRUE(inserted_in_rapid(near).empty()) << "the line itself is clean and keeps this clearance";
  c.options.tolerance_mm = 0;
  c.options.near_miss_mm = 0.99;
  std::vector<Pose> beyond = inserted;
  beyond.push_back(upright(40, 0, 30));
  const CheckResult after = whole_check(paths::through(beyond, MoveKind::rapid), &c.tool, c.scene, c.options);
  EXPECT_EQ(after.counts.clean, beyond.size());
}

TEST(LeaveContact, ARapidAlongThePartRisesAtOnceAndNoHigherThanItsEnd) {
  const std::vector<Pose> inserted = inserted_in_rapid(rapid_to(upright(60, 0, 8)));
  ASSERT_EQ(inserted.size(), 1U);
  EXPECT_NEAR(inserted[0].tip.x(), 0, 1e-6);
  EXPECT_GT(inserted[0].tip.z(), 0.99);
  EXPECT_LT(inserted[0].tip.z(), 2);
}

TEST(LeaveContact, OfALongClearanceIsTheSame) {
  Case c = rapid_to(upright(0, 0, 80));
  c.correct.rapid_clearance_mm = 5;
  EXPECT_TRUE(inserted_in_rapid(c).empty());
  c.correct.rapid_clearance_mm = 0;
  EXPECT_TRUE(inserted_in_rapid(c).empty());
}

}  // namespace
}  // namespace gouge::leave_contact_test
