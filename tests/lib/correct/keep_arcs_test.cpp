// Arcs that are too deep in part, or more than their ends are, and stay arcs all the same.
#include "lib/correct/keep_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/motions.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::keep_arcs_test {
namespace {

using paths::upright;

constexpr double kPi = std::numbers::pi;

/// An arc of radius 10 about the origin at height 0, from (10, 0) on, that feeds lead to and from.
struct ArcCase {
  ToolVariants tool = tools::flat();
  Scene scene;
  CheckOptions options;
  Toolpath path;
  bool can_split = true;

  explicit ArcCase(double sweep, const Vec3& lead = Vec3(0, 0, 20)) {
    const bool is_full = sweep >= 2 * kPi;
    const Vec3 start(10, 0, 0);
    const Vec3 end = is_full ? start : Vec3(10 * std::cos(sweep), 10 * std::sin(sweep), 0);
    path = paths::through({upright(0, 0, 0), upright(0, 0, 0), upright(0, 0, 0), upright(0, 0, 0)});
    path.moves[0].end.tip = start + lead;
    path.moves[1].end.tip = start;
    path.moves[2].end.tip = end;
    path.moves[3].end.tip = end + lead;
    path.moves[2].kind = MoveKind::arc;
    path.moves[2].curve_kind = CurveKind::arc;
    path.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), sweep});
    for (std::size_t i = 0; i < path.moves.size(); ++i) path.moves[i].statement = i;
  }

  [[nodiscard]] Correction correct(const CorrectOptions& asked = {}) const {
    const OwnSetup own(&tool, scene, options);
    RewritableMoves rewritable;
    rewritable.arc.assign(path.moves.size(), true);
    rewritable.split.assign(path.moves.size(), can_split);
    CorrectOptions correct = asked;
    correct.rewritable = &rewritable;
    return correct_path(path, check(path, own.setup), own.setup, correct);
  }

  /// The motions that the arc became.
  [[nodiscard]] std::vector<Motion> motions(const Correction& correction) const {
    std::vector<Motion> all;
    Pose at = path.moves[1].end;
    for (const PathChange& change : correction.changes) {
      if (change.move == 1 && change.new_end) at = *change.new_end;
      if (change.move != 2) continue;
      const Pose end = change.new_end.value_or(path.moves[2].end);
      for (std::size_t k = 0; k <= change.inserted_before.size(); ++k) {
        const bool is_own = k == change.inserted_before.size();
        const Pose& to = is_own ? end : change.inserted_before[k];
        const std::optional<PathArc> arc = is_own                            ? change.new_arc
                                           : k < change.inserted_arcs.size() ? change.inserted_arcs[k]
                                                                             : std::nullopt;
        all.push_back(arc ? test::along(at, to, *arc) : test::straight(at, to));
        at = to;
      }
    }
    return all;
  }

  void expect_clean(const Correction& correction) const {
    const OwnSetup own(&tool, scene, options);
    for (const Motion& motion : motions(correction))
      EXPECT_EQ(own.checker().check(motion, MoveKind::arc, tool, options).state, MoveState::clean);
  }
};

const PathChange* change_of(const Correction& correction, std::size_t move) {
  for (const PathChange& change : correction.changes) {
    if (change.move == move) return &change;
  }
  return nullptr;
}

std::size_t arcs_in(const PathChange& change) {
  return (change.new_arc ? 1U : 0U) +
         static_cast<std::size_t>(std::count_if(change.inserted_arcs.begin(), change.inserted_arcs.end(),
                                                [](const auto& arc) { return arc.has_value(); }));
}

void expect_on_programmed_circle(const PathArc& arc, const Pose& end) {
  EXPECT_EQ(arc.center, Vec3::Zero());
  EXPECT_NEAR((end.tip - arc.center).norm(), 10, 1e-9);
  EXPECT_NEAR(end.tip.z(), 0, 1e-12);
}

// A wall beside the end alone.
TEST(KeepArcs, WhatIsCleanBeforeItsEndStaysOnItsCircle) {
  ArcCase c(kPi / 2, Vec3(-3, -3, 0));
  c.scene.parts.push_back(shapes::box(Vec3(-40, 14.9, -10), Vec3(40, 40, 10)));
  const Correction correction = c.correct();
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  EXPECT_TRUE(correction.uncorrected.empty());
  ASSERT_FALSE(change->inserted_arcs.empty());
  ASSERT_TRUE(change->inserted_arcs[0].has_value());
  expect_on_programmed_circle(*change->inserted_arcs[0], change->inserted_before[0]);
  EXPECT_GT(change->inserted_arcs[0]->sweep_rad, 1.4) << "up to where 0.1 mm of the wall begin";
  EXPECT_LT(c.motions(correction).size(), 5U);
  c.expect_clean(correction);
}

TEST(KeepArcs, WhatIsCleanAfterItsStartToo) {
  ArcCase c(kPi / 2, Vec3(-3, -3, 0));
  c.scene.parts.push_back(shapes::box(Vec3(14.9, -40, -10), Vec3(40, 40, 10)));
  const Correction correction = c.correct();
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  ASSERT_TRUE(change->new_arc.has_value());
  EXPECT_FALSE(change->is_straightened);
  EXPECT_FALSE(change->new_end.has_value());
  expect_on_programmed_circle(*change->new_arc, c.path.moves[2].end);
  c.expect_clean(correction);
}

// A corner of the part in the middle: both stretches beside it stay.
TEST(KeepArcs, BothSidesOfASpotInTheMiddle) {
  ArcCase c(kPi);
  c.tool = tools::ball();
  c.scene.parts.push_back(shapes::box(Vec3(-1, 5, -10), Vec3(1, 25, 0.05)));
  const Correction correction = c.correct();
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  EXPECT_TRUE(correction.uncorrected.empty());
  ASSERT_TRUE(change->new_arc.has_value());
  ASSERT_FALSE(change->inserted_arcs.empty());
  ASSERT_TRUE(change->inserted_arcs[0].has_value());
  expect_on_programmed_circle(*change->inserted_arcs[0], change->inserted_before[0]);
  expect_on_programmed_circle(*change->new_arc, c.path.moves[2].end);
  EXPECT_GE(arcs_in(*change), 2U);
  EXPECT_EQ(change_of(correction, 1), nullptr);
  c.expect_clean(correction);
}

TEST(KeepArcs, OnlyWhereTheFileCanSaySeveralArcs) {
  ArcCase c(kPi);
  c.tool = tools::ball();
  c.scene.parts.push_back(shapes::box(Vec3(-1, 5, -10), Vec3(1, 25, 0.05)));
  c.can_split = false;
  const Correction correction = c.correct();
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  EXPECT_TRUE(change->is_straightened);
  EXPECT_FALSE(change->has_arc());
}

/// The round wall of a pocket in `sides` facets, their middles `apothem` from the axis.
IndexedMesh pocket_wall(std::size_t sides, double apothem) {
  IndexedMesh mesh;
  const double inner = apothem / std::cos(kPi / static_cast<double>(sides));
  for (std::size_t i = 0; i < sides; ++i) {
    const double a = 2 * kPi * (static_cast<double>(i) + 0.5) / static_cast<double>(sides);
    for (const double r : {inner, 40.0}) {
      for (const double z : {-10.0, 10.0}) mesh.vertices.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
  }
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t a = 4 * i, b = 4 * ((i + 1) % sides);
    shapes::add_quad(mesh, a, a + 1, b + 1, b);          // the wall
    shapes::add_quad(mesh, a + 2, b + 2, b + 3, a + 3);  // outside
    shapes::add_quad(mesh, a + 1, a + 3, b + 3, b + 1);  // top
    shapes::add_quad(mesh, a, b, b + 2, a + 2);          // bottom
  }
  return mesh;
}

// Its start lies at a corner of the facets, where it is least deep.
TEST(KeepArcs, ACircleTakesTheRadiusThatItsDeepestPlaceAsksFor) {
  ArcCase c(2 * kPi, Vec3(-10, 0, 0));
  const double corner = kPi / 64;
  IndexedMesh wall = pocket_wall(64, 14.96);
  for (Vec3& v : wall.vertices)
    v = Vec3(std::cos(corner) * v.x() - std::sin(corner) * v.y(), std::sin(corner) * v.x() + std::cos(corner) * v.y(),
             v.z());
  c.scene.parts.push_back(wall);
  const Correction correction = c.correct();
  const PathChange* change = change_of(correction, 2);
  ASSERT_NE(change, nullptr);
  EXPECT_TRUE(correction.uncorrected.empty());
  ASSERT_TRUE(change->new_arc.has_value());
  EXPECT_TRUE(change->inserted_before.empty());
  EXPECT_EQ(change->new_end->tip, change_of(correction, 1)->new_end->tip) << "a full circle still";
  const double radius = (change->new_end->tip - change->new_arc->center).norm();
  EXPECT_LT(radius, 10 - 0.02);
  EXPECT_GT(radius, 10 - 0.06);
  c.expect_clean(correction);
  for (const ChangeRecord& record : correction.records) {
    if (record.move != 1 || record.is_inserted) continue;
    EXPECT_NEAR(record.shift_mm.norm(), 10 - radius, 1e-6);
  }

  CorrectOptions narrow;  // the bound of a shift holds for the ends as well
  narrow.max_side_shift_mm = 10 - radius - 0.002;
  const Correction held = c.correct(narrow);
  for (const PathChange& other : held.changes) {
    if (other.move > 2 || !other.new_end) continue;
    const Vec3 shift = other.new_end->tip - c.path.moves[other.move].end.tip;
    EXPECT_LE(std::hypot(shift.x(), shift.y()), *narrow.max_side_shift_mm + 1e-9);
  }
}

}  // namespace
}  // namespace gouge::keep_arcs_test
