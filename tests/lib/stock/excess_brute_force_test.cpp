// Material left on random parts after random programs, beside random columns at many instants.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "lib/stock/excess.h"
#include "lib/tool/evaluate.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::excess_brute_force_test {
namespace {

constexpr int kInstants = 60, kHeights = 40;

std::size_t wanted_points() {
  const char* const given = std::getenv("GOUGE_EXCESS_POINTS");
  return given == nullptr ? 1500 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

Toolpath random_program(test::Scatter& scatter, bool is_five_axis) {
  std::vector<Pose> poses;
  Vec3 tip = scatter.point(12), axis = is_five_axis ? scatter.axis(0.5) : Vec3::UnitZ();
  tip.z() = scatter.in(0, 6);
  for (int k = 0; k < 30; ++k) {
    poses.push_back({tip, axis});
    tip += scatter.point(scatter.is(0.3) ? 2 : 12);
    tip = tip.cwiseMin(Vec3(14, 14, 4)).cwiseMax(Vec3(-14, -14, -5));
    if (is_five_axis && scatter.is(0.7)) axis = Vec3((axis + 0.15 * scatter.point(1)).normalized());
  }
  Toolpath path = paths::through(poses);
  for (Move& move : path.moves) move.kind = scatter.is(0.2) ? MoveKind::rapid : MoveKind::feed;
  return path;
}

IndexedMesh random_part(test::Scatter& scatter) {
  if (scatter.is(0.3)) return shapes::sphere(scatter.in(6, 10), 10, 16);
  const double top = scatter.in(-6, -1);
  const IndexedMesh plate = shapes::box(Vec3(-15, -15, -15), Vec3(15, 15, top));
  if (scatter.is(0.4)) return plate;
  const Vec3 low(scatter.in(-10, 0), scatter.in(-10, 0), top);
  return shapes::joined(plate, shapes::box(low, Vec3(low.x() + scatter.in(2, 8), low.y() + scatter.in(2, 8), 0)));
}

class Program {
 public:
  Program(const Toolpath& path, const MotionLaw& law, const ToolVariants& tool) : path_(path), law_(law), tool_(tool) {}

  /// Returns the least distance of the cutter from a point at many instants, less half of the way between them.
  [[nodiscard]] double nearest_mm(const Vec3& point, bool is_sampled_exactly = false) const {
    double nearest = 1e9;
    for (std::size_t i = 1; i < path_.moves.size(); ++i) {
      if (path_.moves[i].kind == MoveKind::rapid) continue;
      const Motion motion = law_.of(path_, i);
      const double way = motion.path_length_mm(0, 1, 0) + motion.turn_rad() * 80;
      for (int n = 0; n <= kInstants; ++n) {
        const double at = signed_distance_mm(tool_.cutting, motion.at(static_cast<double>(n) / kInstants), point);
        nearest = std::min(nearest, at - (is_sampled_exactly ? 0 : 0.5 * way / kInstants));
      }
    }
    return nearest;
  }

 private:
  const Toolpath& path_;
  const MotionLaw& law_;
  const ToolVariants& tool_;
};

/// A random point of the surface with its normal.
struct Foot {
  Vec3 point, normal;
  std::uint32_t triangle;
};

Foot random_foot(test::Scatter& scatter, const IndexedMesh& mesh) {
  const auto t = static_cast<std::uint32_t>(scatter.below(mesh.triangles.size()));
  double a = scatter.in(0, 1), b = scatter.in(0, 1);
  if (a + b > 1) a = 1 - a, b = 1 - b;
  const Vec3 &p = mesh.corner(t, 0), &q = mesh.corner(t, 1), &r = mesh.corner(t, 2);
  return {p + a * (q - p) + b * (r - p), face_normal(mesh, t), t};
}

bool is_on(const FacetPiece& piece, const Vec3& point) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = piece.corners[(k + 1) % 3] - piece.corners[k];
    if (piece.normal.cross(edge).dot(point - piece.corners[k]) < -1e-9 * edge.norm()) return false;
  }
  return true;
}

TEST(ExcessBruteForce, NoColumnIsHigherThanItsBound) {
  const MotionLaw law;
  StockOptions options;
  const Vec3 low(-15, -15, -15), high(15, 15, 0.5);
  const StockSolid stock = StockSolid::box(low, high);
  std::vector<ToolVariants> tools;
  for (const Cutter& cutter : std::vector<Cutter>{FlatCutter{6, 5}, BallCutter{8, 6}, BullNoseCutter{8, 1, 5},
                                                  TaperedCutter{3, 1, 5, 8}, LollipopCutter{6, 3, 0}}) {
    ToolAssembly tool = tools::assembly(cutter, 3);
    tool.shank = {{3, 3, 20}};
    tools.push_back(tools::variants(tool));
  }
  test::Scatter scatter(61);
  std::size_t points = 0, high_columns = 0, proved = 0;
  for (int run = 0; points < wanted_points(); ++run) {
    const ToolVariants& tool = tools[scatter.below(tools.size())];
    const Toolpath path = random_program(scatter, run % 2 == 1);
    const std::vector<StockTool> all{{&tool, true}};
    const double asked = scatter.is(0.5) ? 0.2 : scatter.in(0.1, 3);
    options.resolution_mm = std::min(0.05, 0.5 * asked);
    const CutHistory history(path, law, all, options);
    const std::vector<IndexedMesh> meshes{random_part(scatter)};
    const std::vector<Surface> surfaces{Surface(meshes.front())};
    const Result<PartColumns> parts = PartColumns::of(surfaces);
    ASSERT_TRUE(parts);
    const ExcessResult found = find_excess({history, stock, *parts, options.resolution_mm}, asked, 1);
    const Program program(path, law, tool);
    const Surface& surface = surfaces.front().boundary();

    // Proved columns are stock that no cutter touched, and nearest to their feet.
    for (const ExcessPlace& place : found.places) {
      EXPECT_LE(place.area_mm2, place.area_upper_mm2 + 1e-9);
      if (!place.is_proved()) continue;
      ++proved;
      EXPECT_GE(place.highest.height_mm, asked);
      EXPECT_LE(place.highest.height_mm, place.highest.height_upper_mm);
      for (int n = 1; n <= kHeights; ++n) {
        const double height = place.highest.height_mm * n / kHeights;
        const Vec3 at = place.highest.point + height * place.highest.at.normal;
        EXPECT_GT(program.nearest_mm(at, true), -1e-6);
        EXPECT_TRUE((at.array() > low.array() - 1e-9).all() && (at.array() < high.array() + 1e-9).all());
        EXPECT_NEAR(surface.closest_point(at)->distance_mm, height, 1e-6);
      }
    }
    for (int k = 0; k < 150; ++k, ++points) {
      const Foot foot = random_foot(scatter, surface.mesh());
      double height = 0;
      const double step = asked / 16;
      for (double next = step; next < 20; next += step) {
        const Vec3 at = foot.point + next * foot.normal;
        const bool is_stock = (at.array() > low.array() + options.resolution_mm).all() &&
                              (at.array() < high.array() - options.resolution_mm).all();
        if (!is_stock || program.nearest_mm(at) <= options.resolution_mm) break;
        if (surface.closest_point(at)->distance_mm < next - 1e-7) break;
        height = next;
      }
      if (height > asked) ++high_columns;
      double bound = asked + options.resolution_mm;
      bool is_proved_higher = false;
      for (const ExcessPlace& place : found.places) {
        for (std::uint32_t n = 0; n < place.pieces; ++n) {
          const LeftPiece& left = found.left[place.first_piece + n];
          if (left.piece.triangle != foot.triangle || !is_on(left.piece, foot.point)) continue;
          bound = std::max(bound, place.highest.height_upper_mm);
          is_proved_higher = is_proved_higher || left.is_proved;
        }
      }
      EXPECT_LE(height, bound + 1e-7) << "run " << run;
      if (is_proved_higher) {
        for (int n = 1; n <= kHeights; ++n) {
          const Vec3 at = foot.point + asked * n / kHeights * foot.normal;
          EXPECT_GT(program.nearest_mm(at, true), -1e-6);
          EXPECT_GE(surface.closest_point(at)->distance_mm, asked * n / kHeights - 1e-6);
        }
      }
    }
  }
  std::cout << points << " points, " << high_columns << " high columns, " << proved << " proved places\n";
  EXPECT_GT(high_columns, points / 20);
  EXPECT_GT(proved, 5U);
}

}  // namespace
}  // namespace gouge::excess_brute_force_test
