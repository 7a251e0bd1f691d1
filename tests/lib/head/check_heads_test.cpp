#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/head/check_heads.h"
#include "lib/head/head_search.h"
#include "lib/surface/surface.h"
#include "tests/support/motions.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::check_heads_test {
namespace {

/// A block beside the spindle, 100 mm above the tip.
IndexedMesh side_box() { return shapes::box(Vec3(60, -20, 100), Vec3(120, 20, 160)); }

CheckResult check(const std::vector<Pose>& poses, const std::vector<IndexedMesh>& heads, const IndexedMesh& part,
                  unsigned threads = 1) {
  const ToolVariants tool = tools::ball(10);
  const Toolpath path = paths::through(poses);
  Scene scene;
  scene.parts = {part};
  CheckOptions options;
  options.threads = threads;
  std::vector<HeadBody> bodies;
  for (const IndexedMesh& head : heads) bodies.push_back(*build_head_body(head));
  return whole_check(path, &tool, scene, options, bodies);
}

const IndexedMesh kPost = shapes::box(Vec3(89, -1, 0), Vec3(91, 1, 130));

TEST(Heads, ThatAreTooFarAwayOrNoNumbersAreRefused) {
  for (const double far :
       {1.1e5, 1e300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    IndexedMesh mesh = side_box();
    mesh.vertices[3].y() = far;
    const Result<HeadBody> head = build_head_body(mesh);
    ASSERT_FALSE(head) << far;
    EXPECT_EQ(head.error().code, "mesh-too-far");
  }
}

TEST(Heads, MakeNothingCleanInASceneOrOnAPathThatCannotBeChecked) {
  const ToolVariants tool = tools::ball(10);
  const std::vector<HeadBody> heads = {*build_head_body(side_box())};
  const Toolpath path = paths::through({paths::upright(0, -80, 0), paths::upright(0, 80, 0)});
  const Scene scene{{kPost}, {}};
  const CheckResult clean = whole_check(path, &tool, scene, {});
  ASSERT_EQ(clean.counts.clean, 2U);
  for (const double far : {1.1e5, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    Scene far_scene = scene;
    far_scene.parts[0].vertices[0].x() = far;
    CheckResult result = clean;
    check_heads(path, heads, prepare_scene(far_scene), {}, result);
    for (const MoveVerdict& verdict : result.verdicts) EXPECT_EQ(verdict.state, MoveState::not_checked) << far;

    Toolpath far_path = path;
    far_path.moves[1].end.tip.y() = far;
    result = clean;
    check_heads(far_path, heads, prepare_scene(scene), {}, result);
    EXPECT_EQ(result.verdicts[0].state, MoveState::clean);
    EXPECT_EQ(result.verdicts[1].state, MoveState::not_checked) << far;
  }
  CheckOptions options;
  options.tolerance_mm = std::numeric_limits<double>::quiet_NaN();
  CheckResult result = clean;
  check_heads(path, heads, prepare_scene(scene), options, result);
  for (const MoveVerdict& verdict : result.verdicts) EXPECT_EQ(verdict.state, MoveState::not_checked);
}

TEST(Heads, AreFoundBetweenTwoCleanPositionsWhereTheToolAloneIsClean) {
  const std::vector<Pose> poses = {paths::upright(0, -80, 0), paths::upright(0, 80, 0)};
  EXPECT_EQ(check(poses, {}, kPost).counts.clean, 2U);
  const CheckResult result = check(poses, {side_box()}, kPost);
  EXPECT_EQ(result.verdicts[0].state, MoveState::clean);
  ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
  const MoveVerdict& v = result.verdicts[1];
  EXPECT_EQ(v.witness->body, Body::head);
  // The post's edges x = 89 and 91 lie 29 mm deep at mid width, but 20 mm is half of the box's width.
  EXPECT_NEAR(v.depth_mm, 20, 2e-3);
  EXPECT_GE(v.depth_upper_mm, v.depth_mm);
  EXPECT_EQ(result.counts.gouge, 1U);
  EXPECT_EQ(result.events.size(), 1U);
}

TEST(Heads, ThatPassAtADistanceAreClean) {
  const std::vector<Pose> poses = {paths::upright(0, -80, 30.5), paths::upright(0, 80, 30.5)};
  const CheckResult result = check(poses, {side_box()}, kPost);
  EXPECT_EQ(result.counts.clean, 2U) << reason_text(result.verdicts[1].reason);
  EXPECT_LE(result.verdicts[1].depth_upper_mm, 0.011);
}

TEST(Heads, ThatGrazeByALittleAreReportedWithThatDepth) {
  const std::vector<Pose> poses = {paths::upright(0, -80, 29.8), paths::upright(0, 80, 29.8)};
  const CheckResult result = check(poses, {side_box()}, kPost);
  ASSERT_EQ(result.verdicts[1].state, MoveState::gouge);
  EXPECT_NEAR(result.verdicts[1].depth_mm, 0.2, 2e-3);
  EXPECT_NEAR(result.verdicts[1].witness->normal.z(), 1, 1e-6) << "the head must go up";
}

TEST(Heads, InsideASolidAreBuriedAndNeverClean) {
  const IndexedMesh block = shapes::box(Vec3(40, -60, 60), Vec3(160, 60, 200));
  const CheckResult result = check({paths::upright(0, 0, 0), paths::upright(0, 5, 0)}, {side_box()}, block);
  EXPECT_EQ(result.verdicts[0].state, MoveState::buried);
  EXPECT_EQ(result.verdicts[1].state, MoveState::buried);
  ASSERT_EQ(result.events.size(), 1U);
  EXPECT_EQ(result.events[0].body, Body::head);
}

TEST(Heads, ThatAreOpenAreRefused) {
  const Result<HeadBody> head = build_head_body(shapes::open_cube());
  ASSERT_FALSE(head.has_value());
  EXPECT_EQ(head.error().code, "mesh-head-open");
}

TEST(Heads, WhoseTrianglesAreDoubledAreRefused) {
  const IndexedMesh cube = shapes::cube();
  EXPECT_FALSE(build_head_body(shapes::joined(cube, shapes::inside_out(cube))).has_value());
}

TEST(Heads, InsideASolidThatDoesNotTellAreNotCertifiedUnlessTheirPathLeadsOut) {
  const IndexedMesh block = shapes::box(Vec3(40, -60, 60), Vec3(160, 60, 200));
  const IndexedMesh doubled = shapes::joined(block, shapes::inside_out(block));
  const CheckResult staying = check({paths::upright(0, 0, 0), paths::upright(0, 5, 0)}, {side_box()}, doubled);
  EXPECT_EQ(staying.counts.not_certified, 2U);
  IndexedMesh pot = block;
  pot.triangles.resize(10);
  pot.file_triangle.resize(10);
  const CheckResult rising =
      check({paths::upright(0, 0, 0), paths::upright(0, 5, 0), paths::upright(0, 5, 150)}, {side_box()}, pot);
  EXPECT_EQ(rising.counts.clean, 3U) << reason_text(rising.verdicts[0].reason);
}

TEST(Heads, HaveACoreInEveryPiece) {
  const IndexedMesh two = shapes::joined(shapes::cube(10), shapes::moved(shapes::cube(4), Vec3(30, 0, 0)));
  const HeadBody head = *build_head_body(two);
  ASSERT_EQ(head.cores.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GT(head.core_depths_mm[k], 0.5);
    EXPECT_TRUE(head.surface.closest_point(head.cores[k])->is_inside);
  }
}

TEST(Heads, ArePiecesWhereTheseAreBodiesApart) {
  const IndexedMesh apart = shapes::joined(shapes::cube(10), shapes::moved(shapes::cube(10), Vec3(20, 0, 0)));
  EXPECT_EQ(head_pieces(Surface(apart)).size(), 2U);
  EXPECT_EQ(shells_of(shapes::cubes_crossing()).size(), 2U);
  EXPECT_EQ(head_pieces(Surface(shapes::cubes_crossing())).size(), 1U) << "how deep a point is in both, neither shows";
  EXPECT_EQ(head_pieces(Surface(shapes::hollow_cube())).size(), 1U);
  const HeadBody crossing = *build_head_body(shapes::cubes_crossing());
  EXPECT_NEAR(crossing.surface.closest_point(Vec3(7.5, 7.5, 7.5))->signed_mm(), -std::sqrt(2 * 2.5 * 2.5), 1e-9);
}

TEST(Heads, MotionKeepsRotationsAndEndsWhereTheRuleSays) {
  const Motion motion = test::straight(Pose{Vec3(1, 2, 3), Vec3(0.3, -0.2, 1).normalized()},
                                       Pose{Vec3(9, 1, 0), Vec3(-0.5, 0.7, 0.4).normalized()});
  const BodyMotion head(motion);
  for (const double t : {0.0, 0.3, 1.0}) {
    const RigidTransform at = head.at(t);
    EXPECT_NEAR((at.rotation.transpose() * at.rotation - Eigen::Matrix3d::Identity()).norm(), 0, 1e-12);
    EXPECT_NEAR((at.rotation.col(2) - motion.at(t).axis).norm(), 0, 1e-12);
  }
  EXPECT_NEAR((head.at(1).rotation - rotation_to_axis(motion.end().axis)).norm(), 0, 1e-9);
  EXPECT_NEAR((rotation_to_axis(Vec3(0, 0, -1)) * Vec3::UnitZ() - Vec3(0, 0, -1)).norm(), 0, 1e-12);
}

/// Random heads and parts: dense sampling never finds more than the bound, and the witness holds.
TEST(Heads, BoundsHoldAgainstSampling) {
  test::Scatter random(3);
  const IndexedMesh part = shapes::star_prism();
  const HeadBody head = *build_head_body(shapes::torus(20, 6, 24, 12));
  const BlockTree tree = build_block_tree({&part, 1});
  const std::array targets{HeadTarget{&tree}};
  std::size_t gouges = 0;
  for (int i = 0; i < 12; ++i) {
    const Motion motion = test::straight(Pose{45 * random.direction(), random.direction()},
                                         Pose{45 * random.direction(), random.direction()});
    const BodyMotion moving(motion);
    const HeadResult reported = search_head(moving, head, targets, {0.01, 0.02, 0.02, 20000});
    double sampled = 0;
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      for (int k = 0; k < 20; ++k) {
        const double u = random.in(0, 1), v = (1 - u) * (random.in(0, 1));
        const Vec3 p = part.corner(t, 0) + u * (part.corner(t, 1) - part.corner(t, 0)) +
                       v * (part.corner(t, 2) - part.corner(t, 0));
        for (int s = 0; s <= 60; ++s) {
          sampled = std::max(sampled, -head.surface.closest_point(moving.at(s / 60.0).inverse().point(p))->signed_mm());
        }
      }
    }
    EXPECT_LE(sampled, reported.depth_upper_mm + 1e-9);
    if (!reported.has_witness) continue;
    ++gouges;
    EXPECT_NEAR(-head.surface.closest_point(moving.at(reported.t).inverse().point(reported.point))->signed_mm(),
                reported.depth_mm, 1e-9);
    // Given way by the depth, the witness is on the head's boundary.
    const Vec3 freed = moving.at(reported.t).inverse().point(reported.point - reported.depth_mm * reported.normal);
    EXPECT_NEAR(head.surface.closest_point(freed)->distance_mm, 0, 1e-9);
  }
  EXPECT_GT(gouges, 3U);
}

TEST(Heads, GiveTheSameResultAtAnyNumberOfThreads) {
  std::vector<Pose> poses;
  for (int i = 0; i < 40; ++i)
    poses.push_back({Vec3(2.0 * i - 40, -30 + i, 0), Vec3(0.02 * i - 0.4, 0.1, 1).normalized()});
  const CheckResult one = check(poses, {side_box()}, kPost, 1), three = check(poses, {side_box()}, kPost, 3);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(one.verdicts[i].state, three.verdicts[i].state);
    EXPECT_EQ(one.verdicts[i].depth_mm, three.verdicts[i].depth_mm);
    EXPECT_EQ(one.verdicts[i].depth_upper_mm, three.verdicts[i].depth_upper_mm);
  }
}

// A flat face that slides over a flat face, reaching past its edge: above it by a little, on it, below it. What is near
// the edge of the head lies beside one face and under another.
TEST(Heads, AFaceThatSlidesAlongAFaceTakesFewBounds) {
  const IndexedMesh wall = shapes::box(Vec3(24, -50, -10), Vec3(60, 50, 70));
  for (const double height_mm : {69.9, 69.995, 70.0, 70.000001, 70.005}) {
    const IndexedMesh head = shapes::box(Vec3(-30, -30, height_mm), Vec3(30, 30, 130));
    const CheckResult result = check({paths::upright(0, -30, 0), paths::upright(0, 30, 0)}, {head}, wall);
    EXPECT_EQ(result.verdicts[1].state, height_mm < 69.99 ? MoveState::gouge : MoveState::clean) << height_mm;
    EXPECT_GE(result.verdicts[1].depth_upper_mm, std::max(0.0, 70 - height_mm)) << height_mm;
    EXPECT_LE(result.verdicts[1].depth_upper_mm, std::max(0.01, 70 - height_mm) + 0.001) << height_mm;
    EXPECT_LT(result.evaluations, 2000U) << height_mm << ": 100,000 did not do without the second plane";
  }
}

}  // namespace
}  // namespace gouge::check_heads_test
