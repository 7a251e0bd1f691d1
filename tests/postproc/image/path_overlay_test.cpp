#include "postproc/image/path_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/postproc/image/small_scene.h"
#include "tests/support/paths.h"

namespace gouge::path_overlay_test {
namespace {

using paths::upright;

// A block of 40 x 30 x 10 seen from above on white.
class OverlayTest : public testing::Test {
 protected:
  OverlayTest() {
    block_.parts = {box_mesh("block.stl", {0, 0, 0}, {40, 30, 10})};
    const PreparedScene prepared(block_);
    const PictureScene scene(prepared);
    View view = make_view(Vec3::UnitZ(), Vec3::UnitY(), 400, 300);
    fit_view(view, scene.part_points(), 0.1);
    buffer_ = draw_surface(scene, view);
  }

  /// Colour at a place of the top: "white", "blue" or "amber".
  std::string at(const Toolpath& path, double x, double y, MoveState state = MoveState::clean) {
    CheckResult result;
    result.verdicts.resize(path.moves.size());
    for (MoveVerdict& verdict : result.verdicts) verdict.state = state;
    Raster raster(400, 300, 255, 255, 255);
    CheckedToolpath input;
    input.toolpath = &path;
    input.result = &result;
    lay_path(raster, buffer_, input);
    const Vec3 p = buffer_.view.project(Vec3(x, y, 10));
    const std::uint8_t* pixel = raster.pixel(static_cast<int>(p.x()), static_cast<int>(p.y()));
    if (pixel[0] == 255 && pixel[2] == 255) return "white";
    return std::max(pixel[0], pixel[2]) == pixel[2] ? "blue" : "amber";
  }

  Scene block_;
  SurfaceBuffer buffer_;
};

TEST_F(OverlayTest, ShowsWhereTheTipCuts) {
  const Toolpath path = paths::through({upright(5, 10, 10), upright(35, 10, 10)});
  EXPECT_EQ(at(path, 20, 10), "blue");
  EXPECT_EQ(at(path, 20, 20), "white");
  EXPECT_EQ(at(path, 20, 10, MoveState::not_checked), "amber");
  EXPECT_EQ(at(path, 20, 10, MoveState::not_certified), "amber");
}

TEST_F(OverlayTest, LeavesOutRapidsAndWhatThePartHides) {
  EXPECT_EQ(at(paths::through({upright(5, 10, 10), upright(35, 10, 10)}, MoveKind::rapid), 20, 10), "white");
  EXPECT_EQ(at(paths::through({upright(5, 10, 3), upright(35, 10, 3)}), 20, 10), "white");
  EXPECT_EQ(at(paths::through({upright(5, 10, 90), upright(35, 10, 90)}), 20, 10), "blue") << "above it";
}

TEST_F(OverlayTest, FollowsArcs) {
  Toolpath path = paths::through({upright(10, 15, 10), upright(30, 15, 10)});
  path.moves[1].curve_kind = CurveKind::arc;
  path.moves[1].kind = MoveKind::arc;
  path.arcs = {{Vec3(20, 15, 10), Vec3::UnitZ(), 3.14159265358979}};
  EXPECT_EQ(at(path, 20, 5), "blue");
  EXPECT_EQ(at(path, 20, 15), "white");
}

}  // namespace
}  // namespace gouge::path_overlay_test
