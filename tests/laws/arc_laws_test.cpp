// The guarantee on arcs and helices: random ones among random triangles, against poses turned by a quaternion and
// the contour alone.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/laws/random_scenes.h"
#include "tests/support/reference.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::arc_laws_test {
namespace {

struct ArcScene {
  Pose from, to;
  PathArc arc;
  double rise = 0;
  Toolpath path;
  Scene scene;

  [[nodiscard]] Pose at(double t) const {
    Pose pose = reference::pose_at(from, to, t);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(t * arc.sweep_rad, arc.axis));
    pose.tip = arc.center + turn * (from.tip - arc.center) + t * rise * arc.axis;
    return pose;
  }
};

ArcScene random_scene(laws::SceneScatter& scatter) {
  ArcScene s;
  const double radius = std::pow(10, scatter.in(-1, 1.5));
  const double turns = scatter.in(0, 1) < 0.3 ? 1.0 : scatter.in(0.02, 1.5);
  s.arc.axis =
      scatter.in(0, 1) < 0.5 ? Vec3(0, 0, scatter.in(0, 1) < 0.5 ? 1 : -1) : Vec3(scatter.point(1).normalized());
  s.arc.sweep_rad = 2 * std::numbers::pi * turns;
  s.rise = scatter.in(0, 1) < 0.5 ? 0 : scatter.in(-4, 4);
  s.arc.center = scatter.point(2) - radius * s.arc.axis.unitOrthogonal();
  s.from = {s.arc.center + radius * s.arc.axis.unitOrthogonal(), scatter.axis(0.2)};
  s.to.axis = scatter.in(0, 1) < 0.5 ? s.from.axis : scatter.axis(0.4);
  s.to.tip = s.at(1).tip;
  s.path = paths::through({s.from, s.to});
  s.path.moves[1].kind = MoveKind::arc;
  s.path.moves[1].curve_kind = CurveKind::arc;
  s.path.arcs.push_back(s.arc);
  s.scene.parts.push_back(scatter.triangles(6));
  return s;
}

// Deepest place that even sampling finds; a lower bound.
double sampled(const ArcScene& s, const reference::Contour& tool, int instants, int cuts) {
  double deepest = 0;
  const IndexedMesh& mesh = s.scene.parts[0];
  for (int k = 0; k <= instants; ++k) {
    const Pose pose = s.at(static_cast<double>(k) / instants);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
      for (int i = 0; i <= cuts; ++i) {
        for (int j = 0; i + j <= cuts; ++j) {
          deepest = std::max(deepest, tool.depth(pose, a + (b - a) * i / cuts + (c - a) * j / cuts));
        }
      }
    }
  }
  return deepest;
}

TEST(ArcLaws, TheGuaranteeHoldsOnRandomArcs) {
  const auto tools = tools::all();
  std::size_t gouges = 0, close = 0, clean = 0;
  for (std::uint64_t stream = 0; stream < 120; ++stream) {
    laws::SceneScatter scatter(5000 + stream);
    const ArcScene s = random_scene(scatter);
    const ToolVariants& tool = tools[stream % tools.size()];
    CheckOptions options;
    options.threads = 1;
    const CheckResult result = whole_check(s.path, &tool, s.scene, options);
    const MoveVerdict& v = result.verdicts[1];
    const reference::Contour contour(tool.against_part);
    const double found = sampled(s, contour, 96, 10);
    if (v.state == MoveState::buried || v.state == MoveState::not_certified) continue;
    EXPECT_LE(found, v.depth_upper_mm + 1e-9) << "scene " << stream;
    if (v.witness) {
      EXPECT_NEAR(contour.depth(s.at(v.witness->t), v.witness->point), v.depth_mm, 1e-6) << "scene " << stream;
    }
    if (v.state == MoveState::gouge) {
      ++gouges;
      EXPECT_LE(v.depth_upper_mm - v.depth_mm, options.resolution_mm) << "scene " << stream;
      if (found > v.depth_mm - 0.2) ++close;
    }
    if (v.state == MoveState::clean) {
      ++clean;
      EXPECT_LE(v.depth_upper_mm, options.tolerance_mm + options.resolution_mm) << "scene " << stream;
    }
  }
  EXPECT_GT(gouges, 20U);
  EXPECT_GT(clean, 2U);
  EXPECT_GT(2 * close, gouges);  // the sampling sees what there is
}

// A thin post beside the chord, on the arc, and the reverse: chords in place of arcs would state the opposite of both.
TEST(ArcLaws, AnArcIsNotItsChord) {
  const ToolVariants ball = tools::ball(4);
  Toolpath path = paths::through({paths::upright(10, 0, 0), paths::upright(-10, 0, 0)});
  path.moves[1].curve_kind = CurveKind::arc;
  path.moves[1].kind = MoveKind::arc;
  path.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), std::numbers::pi});
  for (const double y : {10.0, -10.0, 0.0}) {
    Scene scene;
    scene.parts.push_back(shapes::box(Vec3(-0.1, y - 0.1, -9), Vec3(0.1, y + 0.1, 9)));
    const CheckResult result = whole_check(path, &ball, scene, {});
    EXPECT_EQ(result.verdicts[1].state, y > 5 ? MoveState::gouge : MoveState::clean) << y;
    path.arcs[0].sweep_rad = -std::numbers::pi;
    const CheckResult other = whole_check(path, &ball, scene, {});
    EXPECT_EQ(other.verdicts[1].state, y < -5 ? MoveState::gouge : MoveState::clean) << y;
    path.arcs[0].sweep_rad = std::numbers::pi;
  }
}

}  // namespace
}  // namespace gouge::arc_laws_test
