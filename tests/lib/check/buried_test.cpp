#include "lib/check/buried.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// A move that the meshes do not prove is never clean.

namespace gouge::buried_test {
namespace {

using paths::through;
using paths::upright;

const Toolpath kInside = through({upright(0, 0, -20), upright(10, 0, -20), upright(20, 5, -10)});

ToolVariants cutter_alone(double diameter = 10, double length = 30) {
  return make_tool_variants({1, "ball", BallCutter{diameter, length}, {}, {}}, 0, 0, 0).value();
}

CheckResult check(const Toolpath& path, const ToolVariants& tool, const Scene& scene, double tolerance_mm = 0.01,
                  unsigned threads = 1) {
  CheckOptions options;
  options.tolerance_mm = tolerance_mm;
  options.threads = threads;
  return whole_check(path, &tool, scene, options);
}

IndexedMesh block(double half = 100) { return shapes::box(Vec3::Constant(-half), Vec3::Constant(half)); }

/// Each triangle cut into four.
IndexedMesh finer(const IndexedMesh& mesh) {
  IndexedMesh fine;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    IndexedMesh four;
    for (std::size_t k = 0; k < 3; ++k) four.vertices.push_back(mesh.corner(t, k));
    for (std::size_t k = 0; k < 3; ++k)
      four.vertices.push_back(0.5 * (mesh.corner(t, k) + mesh.corner(t, (k + 1) % 3)));
    shapes::add_triangle(four, 0, 3, 5);
    shapes::add_triangle(four, 3, 1, 4);
    shapes::add_triangle(four, 5, 4, 2);
    shapes::add_triangle(four, 3, 4, 5);
    fine = shapes::joined(fine, four);
  }
  fine.name = "fine";
  return fine;
}

IndexedMesh turned(IndexedMesh mesh, std::size_t first, std::size_t step) {
  for (std::size_t t = first; t < mesh.triangles.size(); t += step)
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  return mesh;
}

/// The faces of a box, a mesh each.
std::vector<IndexedMesh> faces(const IndexedMesh& box) {
  std::vector<IndexedMesh> all;
  for (std::size_t f = 0; f < 6; ++f) {
    IndexedMesh face;
    face.name = "face" + std::to_string(f);
    for (std::size_t t = 2 * f; t < 2 * f + 2; ++t) {
      IndexedMesh one;
      for (std::size_t k = 0; k < 3; ++k) one.vertices.push_back(box.corner(t, k));
      shapes::add_triangle(one, 0, 1, 2);
      face = shapes::joined(face, one);
    }
    all.push_back(face);
  }
  return all;
}

TEST(Buried, InASolidWhoseTrianglesAreDoubledInBothOrientationsNothingIsCertified) {
  const IndexedMesh fine = finer(block());
  IndexedMesh doubled = shapes::joined(fine, shapes::inside_out(fine));
  doubled.name = "doubled.stl";
  const CheckResult r = check(kInside, cutter_alone(), {{doubled}, {}});
  EXPECT_EQ(r.counts.not_certified, 3U);
  EXPECT_EQ(reason_text(r.verdicts[0].reason),
            "whether the cutter is inside the solid cannot be determined: the shells of doubled.stl cancel each other "
            "there: doubled, or overlapping inside out");
}

TEST(Buried, TurnedTrianglesDoNotMakeASolidTransparent) {
  const IndexedMesh fine = finer(block());
  IndexedMesh half = fine;
  for (std::size_t t = 0; t < half.triangles.size() / 2; ++t) std::swap(half.triangles[t][1], half.triangles[t][2]);
  EXPECT_EQ(check(kInside, cutter_alone(), {{half}, {}}).counts.buried, 3U);
  EXPECT_EQ(check(kInside, cutter_alone(), {{turned(fine, 0, 2)}, {}}).counts.buried, 3U);
  EXPECT_EQ(check(kInside, cutter_alone(), {{turned(fine, 5, 1000)}, {}}).counts.buried, 3U);
}

TEST(Buried, InASolidOverlappedByAnInsideOutBoxNothingIsCertified) {
  for (const IndexedMesh& other : {shapes::box(Vec3(-80, -80, -150), Vec3(150, 80, 80)), block(110), block(100)}) {
    const Scene scene{{shapes::joined(block(), shapes::inside_out(other))}, {}};
    EXPECT_EQ(check(kInside, cutter_alone(), scene).counts.not_certified, 3U);
  }
}

TEST(Buried, FilesOfAKindAreOneSurface) {
  EXPECT_EQ(check(kInside, cutter_alone(), {faces(block()), {}}).counts.buried, 3U);
  EXPECT_EQ(
      check(kInside, cutter_alone(), {{shapes::moved(shapes::cube(1), Vec3(500, 0, 0))}, faces(block())}).counts.buried,
      3U);
  // One of them missing: inside by its rim, unless the tool stands where the missing one may bulge.
  std::vector<IndexedMesh> five = faces(block());
  five.pop_back();
  EXPECT_EQ(check(kInside, cutter_alone(), {five, {}}).counts.clean, 0U);
}

TEST(Buried, NamesTheMeshAndItsFaultWhereASideIsNotKnown) {
  IndexedMesh open = block();
  open.name = "open.stl";
  open.triangles.resize(8);
  open.file_triangle.resize(8);
  const CheckResult r = check(kInside, cutter_alone(), {{open}, {}});
  EXPECT_EQ(r.counts.not_certified, 3U);
  EXPECT_EQ(reason_text(r.verdicts[0].reason),
            "whether the cutter is inside the solid cannot be determined: open.stl has 6 open edges");
}

TEST(Buried, AnOpenMeshGivenTwiceIsNotCertifiedAndTheReasonSaysWhy) {
  IndexedMesh open = block();
  open.name = "open.stl";
  open.triangles.resize(8);
  open.file_triangle.resize(8);
  const CheckResult twice = check(kInside, cutter_alone(), {{open, open}, {}});
  EXPECT_EQ(twice.counts.not_certified, 3U);
  EXPECT_EQ(reason_text(twice.verdicts[0].reason),
            "whether the cutter is inside the solid cannot be determined: open.stl, open.stl have together 6 open "
            "edges when triangles that stand there more than once are counted once");
  const CheckResult flipped = check(kInside, cutter_alone(), {{open, shapes::inside_out(open)}, {}});
  EXPECT_EQ(flipped.counts.not_certified, 3U);
  EXPECT_EQ(reason_text(flipped.verdicts[0].reason),
            "whether the cutter is inside the solid cannot be determined: open.stl, open.stl have together 1 piece of "
            "surface that lies on itself and may enclose nothing");
}

TEST(Buried, InAPartThatIsInsideOutWithinAnother) {
  const Scene scene{{block(), shapes::inside_out(block(60))}, {}};
  EXPECT_EQ(check(kInside, cutter_alone(), scene).counts.buried, 3U);
}

TEST(Buried, AChainThatLeavesTheBoxIsOutsideFromItsBeginningHoweverBrokenTheMesh) {
  // An open pot, and a tool that begins down in it.
  IndexedMesh pot = block();
  pot.triangles.resize(10);
  pot.file_triangle.resize(10);
  const ToolVariants tool = cutter_alone();
  const CheckResult rising =
      check(through({upright(0, 0, 0), upright(5, 0, 0), upright(5, 0, 120)}), tool, {{pot}, {}});
  EXPECT_EQ(rising.counts.clean, 3U);
  const CheckResult staying =
      check(through({upright(0, 0, 0), upright(5, 0, 0), upright(5, 0, 20)}), tool, {{pot}, {}});
  EXPECT_EQ(staying.counts.clean, 0U);
  // Where a move is not checked the chain ends.
  Toolpath broken = through({upright(0, 0, 0), upright(5, 0, 0), upright(5, 0, 20), upright(5, 0, 120)});
  broken.moves[2].not_checked_reason = "an arc";
  const CheckResult r = check(broken, tool, {{pot}, {}});
  EXPECT_EQ(r.verdicts[0].state, MoveState::not_certified);
  EXPECT_EQ(r.verdicts[1].state, MoveState::not_certified);
  EXPECT_EQ(r.verdicts[3].state, MoveState::clean);
}

TEST(Buried, ATopAboveTheBoxProvesTheBodiesBelow) {
  IndexedMesh pot = block();
  pot.triangles.resize(10);
  pot.file_triangle.resize(10);
  EXPECT_EQ(check(through({upright(0, 0, 0)}), tools::ball(), {{pot}, {}}).counts.clean, 1U);
}

TEST(Buried, AHolderInsideTheSolidBehindANeckThinnerThanTheToleranceIsReported) {
  ToolAssembly tool;
  tool.number = 1;
  tool.cutter = BallCutter{10, 20};
  tool.shank = {{0.6, 0.6, 20}};
  tool.holder = {{30, 30, 40}};
  const ToolVariants variants = tools::variants(tool);
  // The cutter is below the block, the shank passes through its lower face, the holder is within it.
  const Scene scene{{shapes::box(Vec3(-100, -100, 30), Vec3(100, 100, 300))}, {}};
  const CheckResult r = check(through({upright(0, 0, 0), upright(5, 0, 0)}), variants, scene, 0.5);
  ASSERT_EQ(r.counts.buried, 2U) << reason_text(r.verdicts[0].reason);
  EXPECT_EQ(reason_text(r.verdicts[0].reason), "the holder is inside the solid; no surface is inside the holder");
  ASSERT_EQ(r.events.size(), 1U);
  EXPECT_EQ(r.events[0].body, Body::holder);
}

TEST(Buried, ACutterThatStandsPartlyOutsideIsNotBuriedAndNotCleanWhereTheToleranceSwallowsIt) {
  const ToolVariants tool = make_tool_variants({1, "flat", FlatCutter{6, 10}, {}, {}}, 0, 0, 0).value();
  const Scene scene{{shapes::box(Vec3(-100, -100, -100), Vec3(100, 100, 0))}, {}};
  const CheckResult r = check(through({upright(0, 0, -8)}), tool, scene, 3.5);
  ASSERT_EQ(r.counts.not_certified, 1U) << state_name(r.verdicts[0].state);
  EXPECT_EQ(reason_text(r.verdicts[0].reason), reason_text({Reason::Kind::body_too_thin, Body::cutter}));
}

TEST(Buried, AHollowCutterIsAskedForItsRing) {
  for (const ToolVariants& tool : tools::shapes()) {
    const Scene scene{{block(500)}, {}};
    EXPECT_EQ(check(through({upright(0, 0, 0)}), tool, scene).counts.buried, 1U) << tool.bare.name;
    EXPECT_EQ(check(through({upright(0, 0, 500 - tool.bare.z_min_mm + 1)}), tool, scene).counts.clean, 1U)
        << tool.bare.name;
  }
}

TEST(Buried, ThreadsDoNotChangeAVerdict) {
  std::vector<Pose> poses;
  for (int i = 0; i < 60; ++i) poses.push_back(upright(3 * i - 90, 0, -20));
  Toolpath path = through(poses);
  for (std::size_t i = 0; i < path.moves.size(); i += 3) path.moves[i].has_start = false;
  const Scene scene{{turned(finer(block()), 0, 2)}, {}};
  const CheckResult one = check(path, cutter_alone(), scene, 0.01, 1),
                    two = check(path, cutter_alone(), scene, 0.01, 2);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(one.verdicts[i].state, two.verdicts[i].state);
    EXPECT_EQ(reason_text(one.verdicts[i].reason), reason_text(two.verdicts[i].reason));
  }
}

}  // namespace
}  // namespace gouge::buried_test
