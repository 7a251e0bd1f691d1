// The guarantee within a tolerance tube: random tools, paths and boxes, against poses that depart from the law of motion
// by as much as the tube allows. GOUGE_TUBE_MOVES sets how many moves.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "lib/tool/evaluate.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/whole_check.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge::tube_law_test {
namespace {

constexpr double kRounding_mm = 1e-7, kWitness_mm = 1e-6;
constexpr int kInstants = 12, kDepartures = 8, kTilts = 400;

std::size_t wanted_moves() {
  const char* const given = std::getenv("GOUGE_TUBE_MOVES");
  return given == nullptr ? 240 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// Returns the pose on the great circle, by its own formula.
Pose pose_at(const Pose& from, const Pose& to, double t) {
  const double turn = std::acos(std::clamp(from.axis.dot(to.axis), -1.0, 1.0));
  const Vec3 axis = turn > 1e-9
                        ? Vec3((std::sin((1 - t) * turn) * from.axis + std::sin(t * turn) * to.axis) / std::sin(turn))
                        : from.axis;
  return {(1 - t) * from.tip + t * to.tip, axis.normalized()};
}

class TubeCampaign {
 public:
  /// `is_mismatched`: the check knows of no tube, so that violations are expected and only counted.
  explicit TubeCampaign(bool is_mismatched) : is_mismatched_(is_mismatched) {}

  void run(std::size_t moves) {
    const std::vector<ToolAssembly> tools = test::sample_tools();
    for (std::size_t job = 0; moves_ < moves; ++job) check_job(tools[job % tools.size()], job);
  }

  std::size_t gouges = 0, clean = 0, violations = 0;

 private:
  void check_job(const ToolAssembly& assembly, std::size_t job) {
    const MotionTube tube{std::array{0.0, 0.02, 0.5}[job % 3], std::array{0.002, 0.02, 0.0, 0.1}[job % 4]};
    const Result<ToolVariants> bare = make_tool_variants(assembly, 0, 0, 0);
    const Result<ToolVariants> tool =
        make_tool_variants(assembly, 0, 0, 0, false, is_mismatched_ ? MotionTube{} : tube);
    ASSERT_TRUE(bare && tool) << assembly.name;
    const double size = bare->bare.z_max_mm;
    Scene scene;
    scene.parts = {shapes::box({-0.4 * size, -0.4 * size, -size}, {0.4 * size, 0.4 * size, 0}),
                   shapes::box({0.4 * size, -0.4 * size, -size}, {0.9 * size, 0.4 * size, random_.in(0, size)})};
    const Toolpath path = random_path(size);
    CheckOptions options;
    options.threads = 1;
    options.tube = tube;
    const CheckResult result = whole_check(path, &*tool, scene, options);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i)
      judge(path, i, result.verdicts[i], bare->bare, scene, tube);
    moves_ += result.verdicts.size();
  }

  Toolpath random_path(double size) {
    Toolpath path;
    for (int k = 0; k < 8; ++k) {
      Move move;
      move.has_start = k > 0;
      move.end = {size * Vec3(random_.in(-0.5, 0.4), random_.in(-0.5, 0.5), random_.in(0, 0.3)), random_.axis(0.4)};
      move.tool = 0;
      path.moves.push_back(move);
    }
    path.tools.emplace_back();
    return path;
  }

  void judge(const Toolpath& path, std::size_t i, const MoveVerdict& verdict, const CompiledTool& bare,
             const Scene& scene, const MotionTube& tube) {
    if (verdict.state != MoveState::clean && verdict.state != MoveState::gouge) return;
    const Pose& to = path.moves[i].end;
    const Pose from = path.moves[i].has_start ? path.moves[i - 1].end : to;
    ++(verdict.state == MoveState::clean ? clean : gouges);
    double deepest = 0;
    for (int k = 0; k <= kInstants; ++k) {
      for (int n = 0; n < kDepartures; ++n) {
        const Pose pose = departed_from(pose_at(from, to, k / double{kInstants}), tube);
        for (const IndexedMesh& mesh : scene.parts) deepest = std::max(deepest, deepest_corner(mesh, pose, bare));
      }
    }
    violations += deepest > verdict.depth_upper_mm + kRounding_mm ? 1U : 0U;
    if (!verdict.witness) return;
    const Witness& w = *verdict.witness;
    const double reached = least_distance(bare, pose_at(from, to, w.t), w.point, tube);
    EXPECT_LE(reached, tube.tip_mm + kWitness_mm) << "no pose of the tube reaches the witness of move " << i;
  }

  /// Returns a pose of the tube, more often than not on its border.
  Pose departed_from(const Pose& pose, const MotionTube& tube) {
    const Vec3 across = pose.axis.unitOrthogonal();
    const Vec3 about = Eigen::AngleAxisd(random_.in(0, 6.2831853), pose.axis) * across;
    const double angle = tube.axis_rad * std::min(1.0, random_.in(0, 2));
    const double away = tube.tip_mm * std::min(1.0, random_.in(0, 2));
    return {pose.tip + away * random_.axis(3), Eigen::AngleAxisd(angle, about) * pose.axis};
  }

  /// Returns the largest depth of corners and of points between them, on the triangles of a mesh.
  double deepest_corner(const IndexedMesh& mesh, const Pose& pose, const CompiledTool& tool) {
    double deepest = 0;
    for (const auto& corners : mesh.triangles) {
      const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
      for (int k = 0; k < 4; ++k) {
        const double u = k == 0 ? 0 : random_.in(0, 1), v = k < 2 ? 0 : random_.in(0, 1 - u);
        deepest = std::max(deepest, -signed_distance_mm(tool, pose, a + u * (b - a) + v * (c - a)));
      }
    }
    return deepest;
  }

  /// Returns the least distance of a point from the tool over the tilts of a tube, in the plane of point and axis.
  static double least_distance(const CompiledTool& tool, const Pose& pose, const Vec3& point, const MotionTube& tube) {
    const Vec3 q = point - pose.tip;
    const double z = q.dot(pose.axis), r = (q - z * pose.axis).norm();
    double least = 1e300;
    for (int k = -kTilts; k <= kTilts; ++k) {
      const double angle = tube.axis_rad * k / kTilts, c = std::cos(angle), s = std::sin(angle);
      least = std::min(least, evaluate_brute_force(tool, std::abs(r * c + z * s), z * c - r * s).signed_distance_mm);
    }
    return least;
  }

  bool is_mismatched_;
  test::Scatter random_{5};
  std::size_t moves_ = 0;
};

TEST(TubeLaw, NoPoseOfTheTubeIsDeeperAndEveryWitnessIsReached) {
  TubeCampaign campaign(false);
  campaign.run(wanted_moves());
  EXPECT_EQ(campaign.violations, 0U);
  EXPECT_GT(campaign.clean, wanted_moves() / 20);
  EXPECT_GT(campaign.gouges, wanted_moves() / 4);
}

TEST(TubeLaw, TheCampaignFindsWhatACheckWithoutTheTubeMisses) {
  TubeCampaign campaign(true);
  campaign.run(120);
  EXPECT_GT(campaign.violations, 2U);
}

}  // namespace
}  // namespace gouge::tube_law_test
