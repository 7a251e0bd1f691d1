#include "postproc/image/thin_lines.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/path/toolpath.h"
#include "postproc/image/path_plot.h"

namespace gouge::thin_lines_test {
namespace {

const DrawnLine kStyle{{}, {0, 0, 0, 1}, 1.4, false, {}};

std::size_t points_of(const std::vector<DrawnLine>& lines) {
  std::size_t count = 0;
  for (const DrawnLine& line : lines) count += line.points.size();
  return count;
}

TEST(ThinLines, KeepsWhatIsSeen) {
  ThinLines lines({0, 0}, {100, 100});
  lines.add({{10, 10}, {50, 10}}, 0, kStyle);
  lines.add({{50, 10}, {50, 40}}, 0, kStyle);
  lines.add({{60, 60}, {60, 60}}, 0, kStyle);
  const std::vector<DrawnLine> kept = lines.take();
  ASSERT_EQ(kept.size(), 2U) << "strokes that go on are one line, a dot stays a dot";
  EXPECT_EQ(kept[0].points, (std::vector<Vec2>{{10, 10}, {50, 10}, {50, 40}}));
  EXPECT_EQ(kept[1].points.size(), 2U);
}

TEST(ThinLines, StrokesThroughOnePointInOtherInksStayApart) {
  ThinLines lines({0, 0}, {100, 100});
  lines.add({{10, 10}, {50, 10}}, 0, kStyle);
  lines.add({{50, 10}, {90, 10}}, 1, kStyle);
  EXPECT_EQ(lines.take().size(), 2U);
}

TEST(ThinLines, NoPointLeftOutIsFarFromTheLine) {
  ThinLines lines({0, 0}, {1000, 1000});
  std::vector<Vec2> points;
  for (int i = 0; i <= 3000; ++i) points.emplace_back(i * 0.25, 500 + 300 * std::sin(i * 0.004));
  lines.add(points, 0, kStyle);
  const std::vector<DrawnLine> kept = lines.take();
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_LT(kept[0].points.size(), 200U);
  for (const Vec2& p : points) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < kept[0].points.size(); ++i) {
      const Vec2 a = kept[0].points[i - 1], along = kept[0].points[i] - a;
      const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - a - t * along).norm());
    }
    ASSERT_LE(nearest, 0.1 + 1e-12);
  }
}

TEST(ThinLines, TurnsBackWhereTheStrokeDoes) {
  ThinLines lines({0, 0}, {100, 100});
  lines.add({{10, 10}, {90, 10}, {50, 10}, {50, 50}}, 0, kStyle);
  const std::vector<DrawnLine> kept = lines.take();
  ASSERT_FALSE(kept.empty());
  EXPECT_EQ(kept[0].points[1], Vec2(90, 10));
}

TEST(ThinLines, DrawsNothingTwiceUnlessAnotherInkCameBetween) {
  ThinLines lines({0, 0}, {100, 100});
  for (int i = 0; i < 1000; ++i) lines.add({{10, 10}, {90, 10}, {90, 90}, {10, 10}}, 0, kStyle);
  EXPECT_LE(points_of(lines.take()), 8U);
  lines.add({{10, 10}, {90, 90}}, 1, kStyle);
  lines.add({{10, 10}, {90, 90}}, 0, kStyle);
  EXPECT_EQ(lines.take().size(), 2U);
}

// It was 432 bytes a move, 432 MB for a million.
TEST(PlotPath, OfADensePathIsSmall) {
  Toolpath path;
  path.file = "dense.apt";
  constexpr std::size_t kMoves = 300000;
  for (std::size_t i = 0; i < kMoves; ++i) {
    Move move;
    const std::size_t row = i / 1000, k = row % 2 == 0 ? i % 1000 : 999 - i % 1000;
    move.end = {{0.4 * static_cast<double>(k), 0.3 * static_cast<double>(row), 0.0}, Vec3::UnitZ()};
    move.has_start = i > 0;
    path.moves.push_back(move);
  }
  const Result<std::string> svg = plot_path(path, {}, true);
  ASSERT_TRUE(svg);
  EXPECT_LT(svg->size(), 1000000U);
  EXPECT_GT(svg->size(), 10000U);
}

}  // namespace
}  // namespace gouge::thin_lines_test
