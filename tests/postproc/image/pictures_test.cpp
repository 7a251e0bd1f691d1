#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/field/depth_field.h"
#include "lib/tool/evaluate.h"
#include "postproc/image/heat_map.h"
#include "postproc/image/picture_events.h"
#include "postproc/image/render_drawing.h"
#include "postproc/image/report_pictures.h"
#include "postproc/image/tilt_field.h"
#include "tests/postproc/image/small_pages.h"
#include "tests/postproc/image/small_scene.h"

namespace gouge::pictures_test {
namespace {

double depth_at_pose(const CompiledTool& tool, const Pose& pose, const Vec3& p) {
  const Vec3 d = p - pose.tip;
  const double z = d.dot(pose.axis);
  return -evaluate(tool, (d - pose.axis * z).norm(), z).signed_distance_mm;
}

std::vector<std::string> names(const std::vector<NamedFile>& files) {
  std::vector<std::string> out;
  for (const NamedFile& file : files) out.push_back(file.name);
  return out;
}

double right_edge(const Page& page) {
  double right = 0;
  for (const DrawnText& text : texts_of(page)) {
    if (text.anchor == TextAnchor::left)
      right = std::max(right, text.at.x() + text_width(text.text, text.size, text.is_bold));
  }
  return right;
}

TEST(DepthField, IsTheDeepestOfTheMovesAtEveryPoint) {
  const SmallScene small;
  ASSERT_GT(small.result.counts.gouge, 0U);
  std::vector<DepthField::Point> points;
  for (double x = 0.25; x < 40; x += 0.5) {
    for (double y = 12.05; y < 18; y += 0.1) points.push_back({{x, y, 10}, Against::part});
  }
  const std::vector<float> depth = DepthField(small.input).depth_at(points);
  std::size_t gouged = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double dense = 0;
    for (std::size_t m = 0; m < small.path.moves.size(); ++m) {
      const Move& move = small.path.moves[m];
      if (!move.has_start) continue;
      const Vec3& from = small.path.start_of(m).tip;
      for (int k = 0; k <= 400; ++k) {
        const double t = k / 400.0;
        const Pose pose{from + t * (move.end.tip - from), move.end.axis};
        dense = std::max(dense, depth_at_pose(small.tool.against_part, pose, points[i].at));
      }
    }
    if (depth[i] > 0) ++gouged;
    const double reported = static_cast<double>(depth[i]);
    EXPECT_LE(reported, dense + 1e-3) << points[i].at.transpose();
    EXPECT_GE(reported + 0.011, dense) << points[i].at.transpose();
  }
  EXPECT_GT(gouged, 100U);
  EXPECT_LT(gouged, points.size());
}

TEST(DepthField, CoversTheWholePathHoweverFewPosesItMayHave) {
  SmallScene small;
  // Back and forth in the groove, so that there are far more gouging moves than poses allowed.
  small.path.moves.resize(1);
  for (int k = 0; k < 300; ++k) {
    Move move = small.path.moves.back();
    move.has_start = true;
    move.end.tip = Vec3(2 + 0.12 * k, 15, 9.7);
    small.path.moves.push_back(move);
  }
  small.check();
  ASSERT_GT(small.result.counts.gouge, 250U);
  const DepthField field(small.input, 40);
  for (const double x : {6.0, 20.0, 36.0}) {
    EXPECT_NEAR(static_cast<double>(field.depth_at({{{x, 15, 10}, Against::part}})[0]), 0.3, 0.1) << x;
  }
}

TEST(DepthField, LooksOnceWhereMovesMeetAndMissesNoCorner) {
  SmallScene small;
  small.path.moves.resize(1);
  small.path.moves[0].end.tip = Vec3(4, 12, 9.7);
  const auto go = [&](const Vec3& by, int count) {
    for (int k = 0; k < count; ++k) {
      Move move = small.path.moves.back();
      move.has_start = true;
      move.end.tip += by;
      small.path.moves.push_back(move);
    }
  };
  for (int row = 0; row < 4; ++row) {  // short moves; single ones of its own at each corner
    go({row % 2 == 0 ? 0.12 : -0.12, 0, 0}, 200);
    go({0, 0.5, 0}, 1);
    go({row % 2 == 0 ? 0.3 : -0.3, 0, 0}, 1);
    go({row % 2 == 0 ? -0.3 : 0.3, 0, 0}, 1);
  }
  small.check();
  const DepthField field(small.input);
  const std::size_t moves = small.path.moves.size();
  EXPECT_GE(field.poses().size(), moves - 1);
  EXPECT_LE(field.poses().size(), 3 * moves / 2);
  std::vector<DepthField::Point> points;
  for (double x = 1.05; x < 32; x += 0.7) {
    for (double y = 9.5; y < 17; y += 0.13) points.push_back({{x, y, 10}, Against::part});
  }
  const std::vector<float> depth = field.depth_at(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double dense = 0;
    for (std::size_t m = 1; m < moves; ++m) {
      const Vec3& from = small.path.start_of(m).tip;
      const Move& move = small.path.moves[m];
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Pose pose{from + t * (move.end.tip - from), move.end.axis};
        dense = std::max(dense, depth_at_pose(small.tool.against_part, pose, points[i].at));
      }
    }
    EXPECT_NEAR(static_cast<double>(depth[i]), dense, 0.012 + 0.03 * dense) << points[i].at.transpose();
  }
}

TEST(DepthField, IsEmptyForACleanPath) {
  SmallScene small;
  for (Move& move : small.path.moves) move.end.tip.z() += 1;
  small.check();
  ASSERT_EQ(small.result.counts.gouge, 0U);
  const DepthField field(small.input);
  EXPECT_TRUE(field.is_empty());
  EXPECT_EQ(field.depth_at({{{20, 15, 10}, Against::part}}), std::vector<float>{0.0F});
}

TEST(PictureEvents, AreNumberedFromTheDeepestAndKeepApart) {
  SmallScene small;
  // The same finding again and again must not crowd out the others.
  const Event event = small.result.events.front();
  for (int k = 0; k < 5; ++k) small.result.events.push_back(event);
  const std::vector<PictureEvent> events = worst_events(small.input, 6);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].rank, 1);
  EXPECT_NEAR(events[0].depth_mm, small.result.worst_depth_mm, 1e-12);
  EXPECT_NEAR(depth_at_pose(small.tool.against_part, events[0].pose, events[0].at), events[0].depth_mm, 1e-6);
}

TEST(PictureEvents, HaveTheNumbersOfTheirFindings) {
  SmallScene small;
  Event buried = small.result.events.front();
  buried.state = MoveState::buried;
  small.result.events.push_back(buried);
  const std::vector<PictureEvent> events = worst_events(small.input, 6);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].rank, 1);
  EXPECT_EQ(events[0].number, 2U) << "a buried tool is the first finding, and the last picture";
  EXPECT_EQ(events[1].rank, 2);
  EXPECT_EQ(events[1].number, 1U);
}

TEST(ReportPictures, AreTheOnesGuaranteedAndTheSameOnEveryRun) {
  const SmallScene small;
  const Result<std::vector<NamedFile>> first = draw_report_pictures({small.model, small.input});
  const Result<std::vector<NamedFile>> second = draw_report_pictures({small.model, small.input});
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_EQ(names(*first), (std::vector<std::string>{"heat_map.png", "event_1.png", "depth_along_path.png"}));
  for (std::size_t i = 0; i < first->size(); ++i) EXPECT_EQ((*first)[i].bytes, (*second)[i].bytes) << (*first)[i].name;
  EXPECT_EQ((*first)[1].move, small.result.events.front().worst_move);
}

TEST(ReportPictures, TellHowManyOfThemAreDone) {
  const SmallScene small;
  std::vector<std::size_t> told;
  const auto listen = [&](std::string_view stage, std::size_t done, std::size_t total) {
    EXPECT_EQ(stage, "drawing pictures");
    told.push_back(done);
    EXPECT_EQ(total, 3U);
  };
  ASSERT_TRUE(draw_report_pictures({small.model, small.input}, listen));
  EXPECT_EQ(told, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(GougeWitnesses, AreSeenFromWhereTheToolComesFromAndNotThroughThePart) {
  const SmallScene small;
  const std::vector<GougeWitness> gouges = gouge_witnesses(small.input, 100);
  ASSERT_EQ(gouges.size(), small.result.counts.gouge);
  for (const GougeWitness& gouge : gouges) {
    EXPECT_GT(gouge.weight, 0);
    EXPECT_TRUE(is_in_sight(small.input, gouge.at, Vec3::UnitZ(), 0.1));
    EXPECT_TRUE(is_in_sight(small.input, gouge.at, Vec3(0.5, 0, 0.8).normalized(), 0.1));
    EXPECT_FALSE(is_in_sight(small.input, gouge.at, -Vec3::UnitZ(), 0.1));
  }
  EXPECT_EQ(gouge_witnesses(small.input, 1).size(), 1U);
}

TEST(ReportPictures, ShowBeforeAndAfterForACorrection) {
  SmallScene before;
  SmallScene after;
  for (Move& move : after.path.moves) move.end.tip.z() += 0.4;
  after.check();
  ASSERT_EQ(after.result.counts.gouge, 0U);
  after.model.has_correction = true;
  after.model.correction.toolpath_before = &before.path;
  after.model.correction.result_before = &before.result;
  const Result<std::vector<NamedFile>> files = draw_report_pictures({after.model, after.input, before.input});
  ASSERT_TRUE(files);
  EXPECT_EQ(names(*files), (std::vector<std::string>{"heat_map.png", "before_after.png", "depth_along_path.png"}));
}

TEST(ReportPictures, ShowTheTiltedAxesOfACorrection) {
  const SmallScene before;
  SmallScene after;
  std::vector<std::size_t> origins;
  for (std::size_t i = 0; i < after.path.moves.size(); ++i) {
    origins.push_back(i);
    if (i > 1 && i + 1 < after.path.moves.size()) after.path.moves[i].end.axis = Vec3(0.2, 0, 1).normalized();
  }
  after.check();
  after.model.has_correction = true;
  EXPECT_FALSE(has_tilt_field(after.model));
  after.model.correction.axes = AxisFacts{};
  EXPECT_FALSE(has_tilt_field(after.model));
  after.model.correction.axes->tilts = find_axis_tilts(before.path, after.path, origins);
  ASSERT_TRUE(has_tilt_field(after.model));
  const Result<std::vector<NamedFile>> files = draw_report_pictures({after.model, after.input});
  ASSERT_TRUE(files);
  const std::vector<std::string> all = names(*files);
  EXPECT_NE(std::ranges::find(all, "tilt_field.png"), all.end());
}

TEST(ReportPictures, SurviveWhatIsMissing) {
  SmallScene small;
  small.input.tools = {nullptr};
  EXPECT_TRUE(draw_report_pictures({small.model, small.input}));
  small.scene.parts.clear();
  small.prepared.emplace(small.scene);
  const Result<std::vector<NamedFile>> without_part = draw_report_pictures({small.model, small.input});
  ASSERT_TRUE(without_part);
  EXPECT_EQ(names(*without_part), std::vector<std::string>{"depth_along_path.png"});
  small.path.moves.clear();
  small.result = CheckResult{};
  EXPECT_TRUE(draw_report_pictures({small.model, small.input}));
}

TEST(ReportPictures, ShowAGougeThatIsDeeperThanThePartIsLarge) {
  SmallScene small;
  small.scene.parts = {box_mesh("block.stl", {19, 14, 9}, {21, 16, 11})};
  small.check();
  ASSERT_GT(small.result.worst_depth_mm, 1);
  ASSERT_GT(8 * small.result.worst_depth_mm, 1.1 * std::sqrt(12.0)) << "the view is limited by the part's size";
  EXPECT_TRUE(draw_report_pictures({small.model, small.input}));
}

TEST(ReportPictures, SurviveABuriedToolAndAnUnfinishedCheck) {
  SmallScene small;
  small.result.verdicts[2] = MoveVerdict{};
  small.result.verdicts[2].state = MoveState::buried;
  small.result.verdicts[3] = MoveVerdict{};
  small.result.verdicts[3].state = MoveState::not_certified;
  small.result.verdicts[3].depth_upper_mm = std::numeric_limits<double>::infinity();
  small.result.events = {{MoveState::buried, 2, 2, 2, 1, 0, Body::cutter, Against::part}};
  small.result.worst_depth_mm = 0;
  const Result<std::vector<NamedFile>> files = draw_report_pictures({small.model, small.input});
  ASSERT_TRUE(files);
  EXPECT_EQ(names(*files), (std::vector<std::string>{"heat_map.png", "event_1.png", "depth_along_path.png"}));
}

TEST(Pictures, CutNoNumberShort) {
  SmallScene small;
  small.path.unit = LengthUnit::inch;
  for (MoveVerdict& v : small.result.verdicts)
    if (v.state == MoveState::gouge) v.overcut = OvercutBounds{25.4 * 12193, 25.4 * 12193};
  small.path.moves.at(small.result.events.at(0).worst_move).line = 123456789;
  const SmallPages pages(small);
  const Page heat = draw_heat_map(pages.set), strip = draw_depth_strip(pages.set);
  EXPECT_EQ(count_with(heat, "overcut 12193.0000 in"), 1U);
  EXPECT_EQ(count_with(heat, "line 123456789"), 1U);
  EXPECT_EQ(count_with(strip, "0.000394 in"), 2U) << "in the caption and beside the line";
  EXPECT_LE(right_edge(heat), kPageWidth);
  EXPECT_LE(right_edge(strip), kPageWidth);
  const std::string words = "overcut 193.000 mm";
  EXPECT_LE(text_width(words, fitting_size(words, 13, 100), false), 100 + 1e-9);
  const std::string depths = "depth 1234567.891 mm of 765432.198 mm";
  for (double room = 40; room < 300; room += 3) {
    std::string rest = fitted(depths, 13, room);
    for (const std::string number : {"1234567.891", "765432.198"}) {
      const std::size_t at = rest.find(number);
      if (at != std::string::npos) rest.erase(at, number.size());
    }
    EXPECT_EQ(rest.find_first_of("0123456789"), std::string::npos) << rest;
  }
}

TEST(Pictures, ReportBuriedMovesBeforeAndAfter) {
  SmallScene small;
  const SmallPages clean(small);
  EXPECT_EQ(count_with(draw_before_after(clean.set, clean.set), "buried"), 0U);
  small.result.counts.buried = 2;
  const SmallPages pages(small);
  EXPECT_EQ(count_with(draw_before_after(pages.set, pages.set), "2 buried"), 2U);
}

TEST(Markers, CoverNeitherEachOtherNorTheirTargets) {
  Page page;
  const Area area{0, 0, 800, 600};
  for (std::size_t k = 1; k <= 6; ++k) add_marker(page, area, {400.0 + 3.0 * static_cast<double>(k), 300}, k, false);
  std::vector<Area> discs;
  for (const Area& taken : page.taken) {
    if (taken.width > 20) discs.push_back(taken);
  }
  ASSERT_EQ(discs.size(), 6U);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool is_apart = discs[i].right() <= discs[j].x || discs[j].right() <= discs[i].x ||
                            discs[i].bottom() <= discs[j].y || discs[j].bottom() <= discs[i].y;
      EXPECT_TRUE(is_apart) << i << " and " << j;
    }
  }
}

}  // namespace
}  // namespace gouge::pictures_test
