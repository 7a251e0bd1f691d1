#include "lib/field/overcut_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "postproc/image/heat_map.h"
#include "tests/postproc/image/small_scene.h"

namespace gouge::overcut_field_test {
namespace {

/// The ball of 6 mm plunged into a block 40 x 30 x 30 mm to the tip's height `z`.
struct Plunge : SmallScene {
  explicit Plunge(double z, const IndexedMesh& part = box_mesh("block.stl", {0, 0, 0}, {40, 30, 30})) {
    scene.parts = {part};
    path.moves.resize(2);
    path.moves[0].end.tip = Vec3(20, 15, 50);
    path.moves[1].has_start = true;
    path.moves[1].end.tip = Vec3(20, 15, z);
    check();
    input.result = &result;
  }
};

std::vector<OvercutField::Ray> rays_down(double height) {
  std::vector<OvercutField::Ray> rays;
  for (double x = 15.05; x < 25; x += 0.1) rays.push_back({Vec3(x, 15, height), -Vec3::UnitZ(), 0});
  return rays;
}

TEST(OvercutField, SaysHowFarBelowTheSurfaceTheToolReachedWhereDepthCannot) {
  const Plunge plunge(18);
  const DepthField depths(plunge.input);
  const OvercutField field(plunge.input, depths);
  ASSERT_FALSE(field.is_empty());
  const std::vector<OvercutField::Ray> rays = rays_down(30);
  const std::vector<float> reported = field.overcut_at(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double r = std::abs(rays[i].at.x() - 20);
    const double truth = r < 3 ? 12 - 3 + std::sqrt(9 - r * r) : 0;
    if (std::abs(r - 3) > 0.06) {
      EXPECT_NEAR(static_cast<double>(reported[i]), truth, 0.15) << r;
    }
  }
  // Depth saturates at the radius.
  EXPECT_NEAR(static_cast<double>(depths.depth_at({{Vec3(20, 15, 30), Against::part}})[0]), 3, 0.05);
}

TEST(OvercutField, StopsHalfwayThroughAThinWall) {
  // Below the middle of the plate the bottom is nearer.
  const Plunge plunge(-5, box_mesh("plate.stl", {0, 0, 26}, {40, 30, 30}));
  const DepthField depths(plunge.input);
  const OvercutField field(plunge.input, depths);
  const std::vector<float> reported = field.overcut_at({{Vec3(20, 15, 30), -Vec3::UnitZ(), 0}});
  EXPECT_NEAR(static_cast<double>(reported[0]), 2, 0.15);
}

TEST(OvercutField, IsNowhereMoreThanTheOvercutOfThePath) {
  const Plunge plunge(21);
  const DepthField depths(plunge.input);
  const OvercutField field(plunge.input, depths);
  float most = 0;
  for (const float mm : field.overcut_at(rays_down(30))) most = std::max(most, mm);
  EXPECT_NEAR(static_cast<double>(most), plunge.result.worst_overcut_mm, 0.02 * plunge.result.worst_overcut_mm);
  EXPECT_NEAR(plunge.result.worst_overcut_mm, 9, 0.1);
}

TEST(OvercutField, FindsTheToolBelowASurfaceItDoesNotPierce) {
  // From the side, its centre 5 mm below the top: the top is not touched, and the nearest surface to the
  // tool's axis.
  Plunge plunge(60);
  plunge.path.moves[0].end = {Vec3(-20, 15, 25), Vec3(-1, 0, 0)};
  plunge.path.moves[1].end = {Vec3(14, 15, 25), Vec3(-1, 0, 0)};
  plunge.check();
  plunge.input.result = &plunge.result;
  const DepthField depths(plunge.input);
  const OvercutField field(plunge.input, depths);
  const Vec3 above(8, 15, 30);
  EXPECT_EQ(depths.depth_at({{above, Against::part}})[0], 0.0F);
  EXPECT_NEAR(static_cast<double>(field.overcut_at({{above, -Vec3::UnitZ(), 0}})[0]), 8, 0.4);
}

// A query for balls first must not lose a ray: one from above, and one the tool passes below.
TEST(OvercutField, MayBeDeepWhereverARayHasAnOvercut) {
  Plunge below(60);
  below.path.moves[0].end = {Vec3(-20, 15, 25), Vec3(-1, 0, 0)};
  below.path.moves[1].end = {Vec3(14, 15, 25), Vec3(-1, 0, 0)};
  below.check();
  below.input.result = &below.result;
  const Plunge above(18);
  std::size_t left_out = 0;
  for (const SmallScene* const scene :
       {static_cast<const SmallScene*>(&below), static_cast<const SmallScene*>(&above)}) {
    const DepthField depths(scene->input);
    const OvercutField field(scene->input, depths);
    std::vector<OvercutField::Ray> rays;
    std::vector<Vec3> places;
    for (double x = 0.25; x < 40; x += 0.5) {
      for (double y = 0.25; y < 30; y += 0.5) {
        rays.push_back({Vec3(x, y, 30), -Vec3::UnitZ(), 0});
        places.push_back(rays.back().at);
      }
    }
    const std::vector<float> deep = field.at(rays);
    std::size_t gouged = 0;
    for (const double radius_mm : {0.0, 0.3, 2.0}) {
      const std::vector<std::uint8_t> may_be = field.may_be_deep(places, radius_mm);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        gouged += deep[i] > 0 ? 1U : 0U;
        left_out += may_be[i] == 0 ? 1U : 0U;
        EXPECT_TRUE(may_be[i] != 0 || !(deep[i] > 0)) << places[i].transpose() << " of " << radius_mm;
        // The places within a ball are those of other rays.
        for (std::size_t k = 0; k < rays.size() && may_be[i] == 0; k += 7) {
          EXPECT_TRUE((places[k] - places[i]).norm() > radius_mm || !(deep[k] > 0)) << places[k].transpose();
        }
      }
    }
    EXPECT_GT(gouged, 100U);
  }
  EXPECT_GT(left_out, 100U);
}

TEST(OvercutField, IsEmptyForSurfacesThatAreNotClosed) {
  IndexedMesh open = box_mesh("open.stl", {0, 0, 0}, {40, 30, 30});
  open.triangles.pop_back();
  open.file_triangle.pop_back();
  const Plunge plunge(21, open);
  ASSERT_GT(plunge.result.counts.gouge, 0U);
  const DepthField depths(plunge.input);
  EXPECT_TRUE(OvercutField(plunge.input, depths).is_empty());
}

TEST(HeatMap, IsColouredByOvercutAndSaysSo) {
  const Plunge plunge(18);
  const PictureScene scene(*plunge.prepared);
  const DepthField depths(plunge.input);
  const OvercutField overcuts(plunge.input, depths);
  const ColourScale depth_scale = make_colour_scale(0.01, 3, LengthUnit::mm);
  const PictureSet set{plunge.model,    plunge.input,
                       scene,           depths,
                       overcuts,        worst_events(plunge.input, 6),
                       depth_scale,     make_colour_scale(0.01, 12, LengthUnit::mm),
                       {Vec3::UnitZ()}, {}};
  EXPECT_EQ(heat_map_title(set), "Overcut on the part");
  const Page page = draw_heat_map(set);
  std::string words;
  for (const auto& item : page.drawing.items) {
    if (const auto* text = std::get_if<DrawnText>(&item)) words += "|" + text->text + "|";
  }
  EXPECT_NE(words.find("|Overcut|"), std::string::npos) << words;
  EXPECT_NE(words.find("WORST 3.000 mm, OVERCUT 12"), std::string::npos) << words;
  EXPECT_NE(words.find("|overcut 12"), std::string::npos) << words;
}

}  // namespace
}  // namespace gouge::overcut_field_test
