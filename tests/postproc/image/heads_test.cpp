#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/field/depth_field.h"
#include "lib/motion/body_motion.h"
#include "lib/motion/motion_law.h"
#include "lib/surface/surface.h"
#include "postproc/image/heat_map.h"
#include "postproc/image/picture_events.h"
#include "postproc/image/report_pictures.h"
#include "postproc/image/section_panel.h"
#include "tests/postproc/image/small_pages.h"
#include "tests/postproc/image/small_scene.h"

namespace gouge::heads_test {
namespace {

constexpr double kDeep = 0.4;

/// The block of the small scene and a head beside the tool that dips into it, which the tool passes.
struct HeadScene : SmallScene {
  std::vector<HeadBody> heads;

  explicit HeadScene(const std::vector<std::array<Vec3, 2>>& boxes = {{Vec3(14, -9, 4.4), Vec3(34, 9, 30)}}) {
    for (const auto& box : boxes) heads.push_back(*build_head_body(box_mesh("head.stl", box[0], box[1])));
    go({{-10, 15, 30}, {-10, 15, 10 - 4.4 - kDeep}, {-7, 15, 10 - 4.4 - kDeep}});
  }

  void go(const std::vector<Vec3>& tips, const Vec3& axis = Vec3::UnitZ()) {
    path.moves.resize(1);
    path.moves[0].end = {tips[0], axis};
    for (std::size_t k = 1; k < tips.size(); ++k) {
      Move move = path.moves.back();
      move.has_start = true;
      move.line = move.line + 1;
      move.end.tip = tips[k];
      path.moves.push_back(move);
    }
    check_all();
  }

  void check_all() {
    check(heads);
    input.heads = heads;
  }
};

std::size_t count_colour(const Raster& raster, const Colour& colour) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < raster.rgb.size(); i += 3)
    count += raster.rgb[i] == colour.r && raster.rgb[i + 1] == colour.g && raster.rgb[i + 2] == colour.b;
  return count;
}

Colour over(const Colour& below, const Colour& colour, double opacity) {
  const auto mix = [&](unsigned char a, unsigned char b) {
    return static_cast<unsigned char>(std::lround(a * (1 - opacity) + b * opacity));
  };
  return {mix(below.r, colour.r), mix(below.g, colour.g), mix(below.b, colour.b), 1};
}

const Colour kWhite{255, 255, 255, 1}, kMaterial{214, 218, 222, 1};

std::size_t head_pixels(const Raster& raster) {
  return count_colour(raster, over(kWhite, body_colour(static_cast<int>(Body::head)), 0.26));
}

std::size_t alarm_pixels(const Raster& raster) { return count_colour(raster, over(kMaterial, kAlarm, 0.62)); }

double distance_to(const SectionLine& line, const Vec2& p) {
  const Vec2 d = line.b - line.a;
  const double t = std::clamp((p - line.a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
  return (line.a + t * d - p).norm();
}

double distance_to_heads(const Section& section, const Vec2& p) {
  double least = 1e9;
  for (const auto& head : section.heads)
    for (const SectionLine& line : head) least = std::min(least, distance_to(line, p));
  return least;
}

TEST(Heads, AreFilledInTheSectionsOfTheirGougeAndRedWhereTheyAreInThePart) {
  const HeadScene small;
  ASSERT_EQ(small.result.events.at(0).body, Body::head);
  const SmallPages pages(small);
  const Page page = draw_event(pages.set, pages.set.events.at(0));
  ASSERT_EQ(page.rasters.size(), 3U);
  for (const std::size_t panel : {1U, 2U}) {
    EXPECT_GT(head_pixels(page.rasters[panel].raster), 10000U) << panel;
    EXPECT_GT(alarm_pixels(page.rasters[panel].raster), 300U) << panel;
  }
  EXPECT_EQ(count_with(page, "Part, tool and head"), 1U);
  EXPECT_EQ(count_with(draw_depth_strip(pages.set), "head"), 1U);
}

TEST(Heads, AreNowhereInThePicturesOfAJobWithoutThem) {
  const SmallScene small;
  const SmallPages pages(small);
  const Page page = draw_event(pages.set, pages.set.events.at(0));
  for (const PlacedRaster& raster : page.rasters) EXPECT_EQ(head_pixels(raster.raster), 0U);
  EXPECT_GT(alarm_pixels(page.rasters.at(2).raster), 300U);
  EXPECT_EQ(count_with(page, "head"), 0U);
  EXPECT_EQ(count_with(draw_depth_strip(pages.set), "head"), 0U);
}

TEST(Heads, ThatOverlapDoNotCancelInASection) {
  const HeadScene one({{Vec3(14, -9, 4.4), Vec3(34, 9, 30)}});
  const HeadScene two({{Vec3(14, -9, 4.4), Vec3(34, 9, 30)}, {Vec3(16, -6, 10), Vec3(30, 6, 25)}});
  const auto filled = [](const HeadScene& small) {
    const SmallPages pages(small);
    return head_pixels(draw_event(pages.set, pages.set.events.at(0)).rasters.at(1).raster);
  };
  EXPECT_EQ(filled(one), filled(two)) << "the second lies in the first";
}

TEST(Heads, AreDrawnBesideACutterThatGougesWithoutMovingThePicture) {
  SmallScene alone;
  HeadScene with({{Vec3(-20, -20, 30), Vec3(20, 20, 60)}});
  with.path.moves = alone.path.moves;
  with.check_all();
  ASSERT_EQ(with.result.events.at(0).body, Body::cutter);
  const SmallPages pages_alone(alone), pages_with(with);
  const Page a = draw_event(pages_alone.set, pages_alone.set.events.at(0));
  const Page b = draw_event(pages_with.set, pages_with.set.events.at(0));
  EXPECT_EQ(a.rasters.at(2).raster.rgb, b.rasters.at(2).raster.rgb) << "the head is far from the finding";
  EXPECT_NE(a.rasters.at(0).raster.rgb, b.rasters.at(0).raster.rgb);
  EXPECT_EQ(texts_of(a).size(), texts_of(b).size());
}

TEST(Heads, EndTheArrowOfTheirDepthOnTheirOutline) {
  // From above, from the side (the way out is square to the tool axis and beside it), and both on a tilted
  // axis.
  for (const bool is_side : {false, true}) {
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0.3, 0.2, 0.9)}) {
      HeadScene small({is_side ? std::array<Vec3, 2>{Vec3(-14, -9, -8), Vec3(-8, 9, 30)}
                               : std::array<Vec3, 2>{Vec3(14, -9, 4.4), Vec3(34, 9, 30)}});
      const Eigen::Matrix3d turn = rotation_to_axis(axis.normalized());
      // An edge of the block in the head's lower or outer face, a little off its middle.
      const Vec3 swept = is_side ? Vec3(-14 + 0.3, 2, 3) : Vec3(20, 2, 4.4 + 0.3);
      const Vec3 edge = is_side ? Vec3(40, 15, 10) : Vec3(0, 15, 10);
      small.go({edge - turn * swept}, axis.normalized());
      bool is_found = false;
      for (const PictureEvent& event : worst_events(small.input, 6)) {
        if (event.event.body != Body::head) continue;
        is_found = true;
        Section section = make_section(*small.prepared, event.pose, event.at, 30, event.witness.normal);
        section.heads = cut_heads(small.heads, event.heads, section.plane);
        const Vec3 foot = event.at - event.depth_mm * event.witness.normal;
        const double tall = (section.plane.flat(event.at) - section.plane.flat(foot)).norm();
        EXPECT_NEAR(tall, event.depth_mm, 0.002 * event.depth_mm);
        EXPECT_LT(distance_to_heads(section, section.plane.flat(foot)), 0.003);
        EXPECT_GE(section.plane.flat(event.at).x(), -1e-9);
      }
      EXPECT_TRUE(is_found) << is_side << " " << axis.transpose();
    }
  }
}

TEST(Heads, AreKnownByNameOfThePieceThatGouges) {
  const HeadScene small({{Vec3(-5, -5, 60), Vec3(5, 5, 80)}, {Vec3(14, -9, 4.4), Vec3(34, 9, 30)}});
  const std::vector<PictureEvent> events = worst_events(small.input, 6);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].head, std::optional<std::size_t>(1));
  EXPECT_NEAR(small.heads[1].surface.closest_point(events[0].heads.inverse().point(events[0].at))->signed_mm(),
              -events[0].depth_mm, 1e-9);
}

TEST(Heads, ThatAreBuriedAreShownWhereTheyLie) {
  HeadScene small({{Vec3(20, -2, 2), Vec3(24, 2, 6)}});
  small.go({{-10, 15, 1}});
  ASSERT_EQ(small.result.counts.buried, 1U);
  const SmallPages pages(small);
  const PictureEvent& event = pages.set.events.at(0);
  ASSERT_TRUE(event.head.has_value());
  EXPECT_TRUE(Box3(Vec3(10, 13, 3), Vec3(14, 17, 7)).contains(event.at)) << event.at.transpose();
  const Page page = draw_event(pages.set, event);
  EXPECT_EQ(count_with(page, "HEAD BURIED"), 1U);
  EXPECT_EQ(count_with(page, "TOOL BURIED"), 0U);
  EXPECT_GT(alarm_pixels(page.rasters.at(1).raster), 1000U);
}

TEST(HeadField, IsTheDepthInTheHeadsAtEveryPoint) {
  HeadScene small({{Vec3(14, -9, 4.4), Vec3(34, 9, 30)}, {Vec3(20, -4, 4.2), Vec3(30, 4, 12)}});
  small.go({{-10, 15, 8}, {-9, 14, 5}, {-6, 17, 5.1}, {-12, 15, 5.3}});
  ASSERT_EQ(small.result.counts.gouge, 3U);
  std::vector<FieldPoint> points;
  for (double x = 0.25; x < 40; x += 1) {
    for (double y = 0.25; y < 30; y += 1) points.push_back({{x, y, 10}, Against::part});
  }
  const DepthField field(small.input);
  const std::vector<float> depth = field.depth_at(points);
  const auto deepest = [&](double so_far, const HeadBody& head, const Vec3& q) {
    return std::max(so_far, -head.surface.closest_point(q)->signed_mm());
  };
  std::size_t gouged = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sampled = 0, dense = 0;
    for (const HeadField::SweptPose& swept : field.heads().all_swept())
      sampled = deepest(sampled, small.heads[swept.head], swept.to_tool.point(points[i].at));
    for (std::size_t m = 1; m < small.path.moves.size(); ++m) {
      const Motion motion = MotionLaw().of(small.path, m);
      for (int k = 0; k <= 150; ++k) {
        const Vec3 q = BodyMotion(motion).at(k / 150.0).inverse().point(points[i].at);
        for (const HeadBody& head : small.heads) dense = deepest(dense, head, q);
      }
    }
    const auto reported = static_cast<double>(depth[i]);
    if (reported > 0) ++gouged;
    EXPECT_LE(reported, sampled + 1e-6) << points[i].at.transpose();
    EXPECT_GE(reported * 1.03 + 0.0101, sampled) << points[i].at.transpose();
    EXPECT_LE(reported, dense + 0.02) << points[i].at.transpose();
    EXPECT_GE(reported + 0.2, dense) << "half a step: " << points[i].at.transpose();
  }
  EXPECT_GT(gouged, 200U);
  EXPECT_LT(gouged, points.size());
  EXPECT_EQ(field.tool_depth_at(points), std::vector<float>(points.size(), 0.0F));
}

TEST(HeadField, StaysEmptyWhereNoHeadComesNear) {
  HeadScene small({{Vec3(14, -9, 4.4), Vec3(34, 9, 30)}});
  const SmallScene alone;
  small.path.moves = alone.path.moves;
  for (Move& move : small.path.moves) move.end.tip.x() += 1000;
  small.check_all();
  EXPECT_TRUE(DepthField(small.input).heads().is_empty());
}

TEST(ReportPictures, OfHeadsAreTheSameOnEveryRun) {
  const HeadScene small;
  const Result<std::vector<NamedFile>> first = draw_report_pictures({small.model, small.input});
  const Result<std::vector<NamedFile>> second = draw_report_pictures({small.model, small.input});
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  ASSERT_EQ(first->size(), 3U);
  for (std::size_t i = 0; i < first->size(); ++i) EXPECT_EQ((*first)[i].bytes, (*second)[i].bytes) << (*first)[i].name;
}

}  // namespace
}  // namespace gouge::heads_test
