// A tilt keeps the cut: no point of the part that the programmed path finished is left higher by the tilted
// one than the tolerance and 0.01 mm. The swept cutter is measured against points of the surface by sampled motions, by
// means of its own: the distance of a point to the cutter's contour, nothing of lib/tilt.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "lib/base/parallel.h"
#include "lib/correct/correct_path.h"
#include "lib/correct/laws.h"
#include "lib/correct/measure_stock.h"
#include "lib/correct/reworked_path.h"
#include "lib/motion/motion_law.h"
#include "lib/tool/evaluate.h"
#include "samples/cases.h"
#include "samples/write_sample.h"
#include "tests/laws/guarantee.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::finished_surface_test {
namespace {

constexpr double kStep_mm = 0.05;      // of the tip, between two samples of a motion
constexpr double kTurn_rad = 0.002;    // or of the axis
constexpr double kSampling_mm = 2e-4;  // what both leave open: a ball of 5 mm rises by less between two samples
constexpr double kMore_mm = 0.01;      // how much higher than what was finished

/// A point of the part's surface and its outward normal.
struct SurfacePoint {
  Vec3 point, normal;
};

/// Poses of the moves [first, last) of a path, close to each other.
std::vector<Pose> sampled(const Toolpath& path, std::size_t first, std::size_t last) {
  std::vector<Pose> poses;
  for (std::size_t i = first; i < last; ++i) {
    const Motion motion = MotionLaw().of(path, i);
    const double steps =
        std::max((motion.end().tip - motion.start().tip).norm() / kStep_mm, motion.turn_rad() / kTurn_rad);
    const int count = path.moves[i].has_start ? 1 + static_cast<int>(steps) : 1;
    for (int k = 0; k <= count; ++k) poses.push_back(motion.at(static_cast<double>(k) / count));
  }
  return poses;
}

/// The largest height over the surface at which the swept cutter leaves nothing: the least of `heights_mm` at which the
/// point above the surface is cut by one of the poses, as an index; none: heights.size().
std::vector<std::size_t> heights_cut(const std::vector<SurfacePoint>& points, const std::vector<Pose>& poses,
                                     const CompiledTool& cutter, const std::vector<double>& heights_mm) {
  std::vector<std::size_t> cut(points.size(), heights_mm.size());
  for_each_chunk(points.size(), 16, 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      for (const Pose& pose : poses) {
        if ((points[p].point - pose.tip).squaredNorm() > 400) continue;
        for (std::size_t h = 0; h < cut[p]; ++h) {
          const Vec3 above = points[p].point + heights_mm[h] * points[p].normal;
          if (signed_distance_mm(cutter, pose, above) <= 0) cut[p] = h;
        }
      }
    }
  });
  return cut;
}

struct Finish {
  std::size_t finished = 0;  // points of the surface by the programmed path, to the tolerance
  std::size_t left = 0;      // of these, those that the new path leaves higher than that and kMore_mm
  double highest_mm = 0;     // of those, at least: by the heights that were examined
  double farthest_mm = 0;    // the farthest of those from all that is cut
};

Finish compare(const std::vector<SurfacePoint>& points, const std::vector<Pose>& before, const std::vector<Pose>& after,
               const CompiledTool& cutter, double tolerance_mm) {
  const double allowed = tolerance_mm + kMore_mm + kSampling_mm;
  const std::vector<double> heights = {tolerance_mm, allowed, 0.03, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6};
  const std::vector<std::size_t> was = heights_cut(points, before, cutter, heights);
  const std::vector<std::size_t> is = heights_cut(points, after, cutter, heights);
  Finish finish;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (was[p] > 0) continue;
    ++finish.finished;
    if (is[p] <= 1) continue;
    ++finish.left;
    double away = 1e9;
    for (const Pose& pose : after) away = std::min(away, signed_distance_mm(cutter, pose, points[p].point));
    finish.farthest_mm = std::max(finish.farthest_mm, away);
    finish.highest_mm = std::max(finish.highest_mm, is[p] < heights.size() ? heights[is[p] - 1] : heights.back());
  }
  std::cout << finish.finished << " of " << points.size() << " points finished before, " << finish.left
            << " of them left higher, by up to " << finish.highest_mm << " mm or the next height looked at\n";
  return finish;
}

/// The moves of the changed path between the first and the last that a tilt changed, and those they were.
struct Span {
  std::size_t before_first = 0, before_last = 0, after_first = 0, after_last = 0;
};

Span tilted_span(const Toolpath& before, const Correction& correction) {
  std::size_t first = before.moves.size(), last = 0;
  for (const ChangeRecord& record : correction.records) {
    if (record.strategy != Strategy::tilt) continue;
    first = std::min(first, record.move);
    last = std::max(last, record.move);
  }
  last = std::min(last + 2, before.moves.size());
  const std::vector<MovesAfter> spans = moves_after(before.moves.size(), correction.changes);
  return {first, last, spans[first].first, spans[last - 1].last};
}

Result<LawfulCorrection> correct_without_file(const Toolpath& path, const CheckSetup& setup,
                                              const CorrectOptions& correct) {
  const auto rewrite = [&](const std::vector<PathChange>& changes) -> Result<Toolpath> {
    Toolpath after = path;
    after.moves.clear();
    std::vector<const PathChange*> of(path.moves.size(), nullptr);
    for (const PathChange& change : changes) of[change.move] = &change;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      Move move = path.moves[i];
      if (of[i] != nullptr) {
        for (const Pose& pose : of[i]->inserted_before) {
          move.end = pose;
          after.moves.push_back(move);
        }
      }
      move.end = of[i] != nullptr && of[i]->new_end ? *of[i]->new_end : path.moves[i].end;
      after.moves.push_back(move);
    }
    return after;
  };
  return correct_lawfully(path, check(path, setup), setup, correct, rewrite);
}

// The last pass of `freeform`, whose holder is in the wall: points of its triangles within reach of the cutter.
TEST(FinishedSurface, OfTheFreeformsTiltedPassIsAsFinishedAsBefore) {
  const testing_support::TemporaryFolder folder;
  const samples::Sample sample = samples::make_freeform();
  ASSERT_TRUE(samples::write_sample(sample, folder.path()).has_value());
  const std::string own = folder.at(sample.name) + "/";
  JobArguments arguments;
  arguments.path = own + sample.toolpath_file;
  arguments.tools_file = own + "tools.json";
  for (const auto& part : sample.parts) arguments.parts.push_back(own + part.file);
  const Job job = guarantee::load(arguments);
  const PreparedScene scene = prepare_scene(job.scene());
  const Result<LawfulCorrection> corrected = correct_without_file(job.toolpath, job.setup(scene), {});
  ASSERT_TRUE(corrected.has_value());
  const Span span = tilted_span(job.toolpath, corrected->correction);
  const std::vector<Pose> before = sampled(job.toolpath, span.before_first, span.before_last);
  const std::vector<Pose> after = sampled(corrected->after.path, span.after_first, span.after_last);
  const CompiledTool& cutter = job.tools()[0]->cutting;
  std::vector<SurfacePoint> points;
  test::Scatter scatter(1);
  for (const IndexedMesh& mesh : job.scene().parts) {
    for (const auto& triangle : mesh.triangles) {
      const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]], &c = mesh.vertices[triangle[2]];
      const Vec3 normal = (b - a).cross(c - a).normalized();
      for (int k = 0; k < 12; ++k) {
        double u = scatter.in(0, 1), v = scatter.in(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const Vec3 point = a + u * (b - a) + v * (c - a);
        const bool is_near =
            std::ranges::any_of(before, [&](const Pose& pose) { return (point - pose.tip).squaredNorm() < 1; });
        if (is_near) points.push_back({point, normal});
      }
    }
  }
  const Finish finish = compare(points, before, after, cutter, job.options.check.tolerance_mm);
  EXPECT_GT(finish.finished, 50U);
  EXPECT_EQ(finish.left, 0U);
}

/// A floor at z = 0 and beside the path along y a wall on which the holder is.
struct FloorRun {
  ToolVariants tool;
  Scene scene;
  Toolpath path;
  OwnSetup own;
  Result<LawfulCorrection> corrected;

  FloorRun(const ToolVariants& of, double lean, double tip_mm, const CorrectOptions& correct)
      : tool(of),
        scene{{shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)), shapes::box(Vec3(13, -30, -5), Vec3(60, 30, 60))},
              {}},
        path(paths::through(poses(lean, tip_mm))),
        own(&tool, scene),
        corrected(correct_without_file(path, own.setup, correct)) {}

  static std::vector<Pose> poses(double lean, double tip_mm) {
    std::vector<Pose> all{paths::upright(0, -80, 120)};
    const Vec3 axis = Vec3(0, lean, 1).normalized();
    for (double y = -80; y <= 80; y += 4) all.push_back({Vec3(0, y, tip_mm), axis});
    return all;
  }

  [[nodiscard]] bool is_tilted() const {
    return std::ranges::any_of(corrected->correction.records,
                               [](const ChangeRecord& record) { return record.strategy == Strategy::tilt; });
  }

  /// For points of the floor.
  [[nodiscard]] Finish finish() const {
    const Span span = tilted_span(path, corrected->correction);
    std::vector<SurfacePoint> points;
    test::Scatter scatter(2);
    for (int k = 0; k < 4000; ++k) points.push_back({Vec3(scatter.in(-6, 6), scatter.in(-60, 60), 0), Vec3::UnitZ()});
    return compare(points, sampled(path, span.before_first, span.before_last),
                   sampled(corrected->after.path, span.after_first, span.after_last), tool.cutting,
                   own.options.tolerance_mm);
  }
};

TEST(FinishedSurface, OfABallOnAFloorIsAsFinishedAsBefore) {
  for (const double lean : {0.0, 0.1}) {
    // The tip of a leaning ball is above the floor by what its centre is higher.
    const FloorRun run(tools::ball(10), lean, 5 - 5 / std::hypot(lean, 1), {});
    ASSERT_TRUE(run.corrected.has_value());
    EXPECT_EQ(run.corrected->after.result.counts.gouge, 0U);
    EXPECT_TRUE(run.is_tilted());
    EXPECT_TRUE(run.corrected->correction.stock.empty());
    const Finish finish = run.finish();
    EXPECT_GT(finish.finished, 100U);
    EXPECT_EQ(finish.left, 0U);
  }
}

// A flat or bull-nose end that stood square on a floor touches it with its edge alone once it leans: so it is not tilted,
// and where that is allowed what it leaves is stated, as high as samples of the swept cutter find it.
TEST(FinishedSurface, OfAFlatEndOnAFloorKeepsItFromBeingTilted) {
  for (const ToolVariants& tool : {tools::flat(10), tools::bull(10, 2)}) {
    const FloorRun lifted(tool, 0, 0, {});
    ASSERT_TRUE(lifted.corrected.has_value());
    EXPECT_EQ(lifted.corrected->after.result.counts.gouge, 0U);
    EXPECT_FALSE(lifted.is_tilted());
    EXPECT_EQ(lifted.corrected->correction.not_tilted.size(), 1U);
    EXPECT_FALSE(lifted.corrected->correction.stock.empty());
    CorrectOptions allowed;
    allowed.tilt.max_stock_mm = 10;
    const FloorRun tilted(tool, 0, 0, allowed);
    ASSERT_TRUE(tilted.corrected.has_value());
    EXPECT_TRUE(tilted.is_tilted());
    const Finish finish = tilted.finish();
    EXPECT_GT(finish.finished, 1000U);
    EXPECT_GT(finish.left, 0U);
    // The same path measured for what is left: no less than the samples find, but for how they are spaced.
    CorrectOptions usual;
    const std::vector<StockStretch> stock =
        measure_stock(tilted.path, tilted.corrected->correction, tilted.corrected->after.path, tilted.own.setup, usual);
    ASSERT_EQ(stock.size(), 1U);
    EXPECT_GT(stock[0].most.thickness_mm * 1.02 + 0.006, finish.farthest_mm);
    EXPECT_LT(stock[0].most.thickness_mm, finish.farthest_mm + 0.05);
  }
}

}  // namespace
}  // namespace gouge::finished_surface_test
