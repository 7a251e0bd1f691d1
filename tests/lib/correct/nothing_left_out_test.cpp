// No step of a correction leaves out a head, a fixture, or whether the tool is inside a solid.
#include <gtest/gtest.h>

#include <numbers>

#include "lib/correct/correct_path.h"
#include "tests/support/motions.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::nothing_left_out_test {
namespace {

using paths::upright;

enum class Ceiling { none, of_fixture, of_part_over_head };

const ToolVariants kTool = tools::ball(10);  // 120 mm high

/// A floor that the tool is a little too deep in, and a ceiling that a lift would touch: with the holder, or the head
/// alone.
struct Case {
  Scene scene{{shapes::box(Vec3(-40, -200, -20), Vec3(40, 200, 0))}, {}};
  std::vector<HeadBody> heads{*build_head_body(shapes::box(Vec3(30, -10, 150), Vec3(50, 10, 180)))};
  Toolpath path;
  CorrectOptions how;
  RewritableMoves rewritable;
  CheckOptions options;

  explicit Case(const std::vector<Pose>& poses, MoveKind kind = MoveKind::feed) : path(paths::through(poses, kind)) {
    for (std::size_t i = 0; i < path.moves.size(); ++i) path.moves[i].statement = i;
    rewritable.arc.assign(path.moves.size(), false);
    rewritable.hole.assign(path.moves.size(), false);
    how.rewritable = &rewritable;
    options.tolerance_mm = 0.2;  // few chords
  }

  [[nodiscard]] Correction corrected(Ceiling ceiling, double gap_mm) {
    double highest = -1e9;
    for (const Move& move : path.moves) highest = std::max(highest, move.end.tip.z());
    const double over_tool = highest + 120 + gap_mm, over_head = highest + 180 + gap_mm;
    if (ceiling == Ceiling::of_fixture)
      scene.fixtures = {shapes::box(Vec3(-25, -50, over_tool), Vec3(25, 50, over_tool + 20))};
    if (ceiling == Ceiling::of_part_over_head)
      scene.parts.push_back(shapes::box(Vec3(0, -50, over_head), Vec3(80, 50, over_head + 20)));
    const OwnSetup own(&kTool, scene, options, heads);
    return correct_path(path, check(path, own.setup), own.setup, how);
  }
};

using MakeCase = Case (*)();

Case along(MoveKind kind) {
  return Case({upright(-80, 0, -0.3), upright(-20, 0, -0.3), upright(20, 0, -0.3), upright(80, 0, -0.3)}, kind);
}

Case feeds() { return along(MoveKind::feed); }
Case rapids() { return along(MoveKind::rapid); }

Case arc() {
  Case c = along(MoveKind::feed);
  c.path.moves[2].kind = MoveKind::arc;
  c.path.moves[2].curve_kind = CurveKind::arc;
  c.path.arcs.push_back({Vec3::Zero(), -Vec3::UnitZ(), std::numbers::pi});
  return c;
}

Case kept_arc() {
  Case c = arc();
  c.rewritable.arc[2] = true;
  c.rewritable.split = c.rewritable.arc;
  return c;
}

// 5 mm deep in the part; drilled a little deeper.
Case hole() {
  Case c({upright(-80, 0, 3), upright(0, 0, 3), upright(0, 0, -5.3), upright(0, 0, 3)});
  const double r = 5.5;
  c.scene.parts = {shapes::box(Vec3(-40, -200, -20), Vec3(40, 200, -5)),
                   shapes::box(Vec3(-40, -200, -5), Vec3(-r, 200, 0)), shapes::box(Vec3(r, -200, -5), Vec3(40, 200, 0)),
                   shapes::box(Vec3(-r, -200, -5), Vec3(r, -r, 0)), shapes::box(Vec3(-r, r, -5), Vec3(r, 200, 0))};
  for (std::size_t i = 1; i < 4; ++i) {
    c.path.moves[i].kind = MoveKind::cycle;
    c.path.moves[i].statement = 1;
  }
  c.rewritable.hole[1] = true;
  return c;
}

class NothingLeftOut : public ::testing::TestWithParam<std::pair<const char*, MakeCase>> {};

INSTANTIATE_TEST_SUITE_P(Moves, NothingLeftOut,
                         ::testing::Values(std::pair("feeds", &feeds), std::pair("rapids", &rapids),
                                           std::pair("arc", &arc), std::pair("kept_arc", &kept_arc),
                                           std::pair("hole", &hole)),
                         [](const auto& test) { return std::string(test.param.first); });

TEST_P(NothingLeftOut, OfWhatALiftWouldTouch) {
  const MakeCase make = GetParam().second;
  const Correction free = make().corrected(Ceiling::none, 0.05);
  EXPECT_FALSE(free.changes.empty()) << (free.uncorrected.empty() ? "nothing gouges" : free.uncorrected[0].reason);
  EXPECT_TRUE(make().corrected(Ceiling::of_fixture, 0.05).changes.empty());
  EXPECT_TRUE(make().corrected(Ceiling::of_part_over_head, 0.05).changes.empty());
  // The ceiling is what forbids it: where the lift has room below it, it is made.
  EXPECT_FALSE(make().corrected(Ceiling::of_fixture, 5).changes.empty());
  EXPECT_FALSE(make().corrected(Ceiling::of_part_over_head, 5).changes.empty());
}

TEST(NothingLeftOut, OfASingleMotion) {
  const Scene scene{{shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 0))},
                    {shapes::box(Vec3(100, -10, 0), Vec3(120, 10, 50))}};
  const std::vector<HeadBody> bodies{*build_head_body(shapes::box(Vec3(30, -5, -40), Vec3(40, 5, -30)))};
  const OwnSetup own_without(&kTool, scene), own_with(&kTool, scene, {}, bodies);
  const MotionChecker without(own_without.setup), with(own_with.setup);
  const auto state = [&](const MotionChecker& checker, const Pose& a, const Pose& b) {
    return checker.check(test::straight(a, b), MoveKind::feed, kTool, checker.options()).state;
  };
  EXPECT_EQ(state(without, upright(0, 0, 1), upright(50, 0, 1)), MoveState::clean);
  EXPECT_EQ(state(without, upright(0, 0, 1), upright(150, 0, 1)), MoveState::gouge);  // the fixture
  EXPECT_EQ(state(without, upright(0, 0, -300), upright(50, 0, -300)), MoveState::buried);
  EXPECT_EQ(state(with, upright(0, 0, 35), upright(50, 0, 35)), MoveState::gouge);   // the head in the part
  EXPECT_EQ(state(with, upright(0, 0, 10), upright(50, 0, 10)), MoveState::buried);  // all of the head
  EXPECT_EQ(state(with, upright(0, 0, 45), upright(50, 0, 45)), MoveState::clean);
}

}  // namespace
}  // namespace gouge::nothing_left_out_test
