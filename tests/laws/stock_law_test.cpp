// Remaining stock where the law of a machine, or the tolerances of its control, leave the motion open: random points beside
// the poses of a machine that moves in one of the ways that the law admits.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "lib/stock/check_stock.h"
#include "lib/tool/evaluate.h"
#include "tests/laws/machine_moves.h"
#include "tests/lib/stock/block.h"
#include "tests/support/scatter.h"

namespace gouge::stock_law_test {
namespace {

constexpr int kInstants = 60;

struct Case {
  std::string name;
  TurnLaw law = TurnLaw::vector;
  MotionTube tube;
};

/// One way in which the machine may run a program.
class MachineRun {
 public:
  MachineRun(const Toolpath& path, const Case& with, test::Scatter& scatter) : path_(path), law_(law_of(with)) {
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const TurnLaw law = with.law == TurnLaw::documented ? (scatter.is(0.5) ? TurnLaw::vector : TurnLaw::axis)
                                                          : (with.law == TurnLaw::any ? TurnLaw::axis : with.law);
      ways_.push_back({law, with.law == TurnLaw::any, scatter.in(0.2, 5), scatter.in(0.2, 5),
                       with.tube.tip_mm * scatter.axis(3), with.tube.axis_rad * scatter.in(0, 1), scatter.axis(3)});
    }
  }

  static MotionLaw law_of(const Case& with) { return laws::law_of_campaign(with.law); }

  /// Returns the pose at t of a move; none: the machine cannot reach it.
  [[nodiscard]] std::optional<Pose> at(std::size_t i, double t) const {
    const JointPath& joints = *path_.joints;
    const Move& move = path_.moves[i];
    if (!joints.end[i] || (move.has_start && !joints.start[i])) return std::nullopt;
    const Pose from = move.has_start ? path_.start_of(i) : move.end;
    const RotaryAngles start = move.has_start ? *joints.start[i] : *joints.end[i];
    const test::MachineReference machine(laws::machine_of_campaign(), laws::kToolLength_mm);
    const auto ends = machine.with_joints({from, move.end, start, *joints.end[i], {}, {}});
    const Way& way = ways_[i];
    const Pose pose = way.is_any ? machine.at(ends, t, TurnShares{std::pow(t, way.first), std::pow(t, way.second)})
                                 : machine.at(way.law, ends, t);
    const Vec3 about = pose.axis.cross(way.tilt_to);
    const Eigen::AngleAxisd tilt(way.tilt_rad,
                                 about.norm() > 0.1 ? Vec3(about.normalized()) : pose.axis.unitOrthogonal());
    return Pose{Vec3(pose.tip + way.off), Vec3(tilt * pose.axis)};
  }

  /// Bounds the way of the points of a small tool during a move.
  [[nodiscard]] double way_mm(std::size_t i) const {
    const Motion motion = law_.of(path_, i);
    const double shares = std::max({5.0, ways_[i].first, ways_[i].second});
    return motion.path_length_mm(0, 1, 0) + 2 * shares * motion.turn_rad() * 80;
  }

 private:
  struct Way {
    TurnLaw law = TurnLaw::vector;
    bool is_any = false;
    double first = 1, second = 1;  // powers of the shares of both rotary joints
    Vec3 off = Vec3::Zero();
    double tilt_rad = 0;
    Vec3 tilt_to = Vec3::UnitX();
  };

  const Toolpath& path_;
  MotionLaw law_;
  std::vector<Way> ways_;
};

class StockLaw : public testing::TestWithParam<Case> {};

TEST_P(StockLaw, HoldsForEveryWayThatTheMachineMayRun) {
  const Case& with = GetParam();
  StockOptions options;
  options.tube = with.tube;
  const Vec3 low(-15, -15, -15), high(15, 15, 0);
  const StockSolid stock = StockSolid::box(low, high);
  const std::vector<ToolVariants> tools = block::small_tools();
  const MotionLaw law = MachineRun::law_of(with);
  test::Scatter scatter(440);
  std::size_t deep = 0, witnesses = 0, proved = 0;
  for (int program = 0; program < 12; ++program) {
    const ToolVariants& tool = tools[scatter.below(tools.size())];
    Toolpath path = block::random_program(scatter, true, 16, 0.03);
    laws::choose_joints_of_campaign(path);
    const std::vector<StockTool> all{{&tool, true}};
    const CutHistory history(path, law, all, options);
    const StockResult result = check_stock(history, stock, options, 1);
    proved += result.proved;
    const MachineRun run(path, with, scatter);
    const auto body_of = [&](std::size_t i) -> const CompiledTool& {
      return history.is_cutting(i) ? tool.non_cutting : tool.bare;
    };
    std::vector<double> upper(path.moves.size(), options.tolerance_mm + options.resolution_mm);
    for (const StockFinding& finding : result.findings) {
      upper[finding.move] = finding.witness ? finding.depth_upper_mm : 1e9;
      if (!finding.witness) continue;
      ++witnesses;
      const StockWitness& witness = *finding.witness;
      const std::optional<Pose> pose = run.at(finding.move, witness.t);
      ASSERT_TRUE(pose.has_value());
      EXPECT_GE(-signed_distance_mm(body_of(finding.move), *pose, witness.point), witness.depth_mm - 1e-6);
      for (std::size_t k = 0; k < finding.move; ++k) {
        for (int n = 0; history.is_cutting(k) && n <= kInstants; ++n) {
          const std::optional<Pose> cut = run.at(k, static_cast<double>(n) / kInstants);
          EXPECT_TRUE(cut && signed_distance_mm(tool.cutting, *cut, witness.point) > -1e-6);
        }
      }
    }
    std::vector<std::vector<Pose>> poses(path.moves.size());
    for (std::size_t i = 0; i < path.moves.size(); ++i)
      for (int n = 0; n <= kInstants; ++n)
        if (const std::optional<Pose> pose = run.at(i, static_cast<double>(n) / kInstants)) poses[i].push_back(*pose);
    for (int k = 0; k < 100; ++k) {
      Vec3 point = scatter.point(15);
      point.z() = scatter.in(-10, 0);
      const Vec3 inset = Vec3::Constant(options.resolution_mm);
      point = point.cwiseMax(low + inset).cwiseMin(high - inset);
      double nearest = 1e9;
      for (std::size_t i = 1; i < path.moves.size(); ++i) {
        if (!result.is_examined[i]) break;
        for (const Pose& pose : poses[i]) {
          const double depth = -signed_distance_mm(body_of(i), pose, point);
          if (nearest > options.resolution_mm) {
            EXPECT_LE(depth, upper[i] + 1e-7) << "program " << program << ", move " << i;
            if (depth > options.tolerance_mm) ++deep;
          }
          if (history.is_cutting(i))
            nearest =
                std::min(nearest, signed_distance_mm(tool.cutting, pose, point) - 0.5 * run.way_mm(i) / kInstants);
        }
      }
    }
  }
  std::cout << with.name << ": " << deep << " deep points, " << witnesses << " witnesses, " << proved << " clear\n";
  EXPECT_GT(deep, 100U);
  EXPECT_GT(witnesses, 15U);
  EXPECT_GT(proved, 60U);
}

INSTANTIATE_TEST_SUITE_P(Laws, StockLaw,
                         testing::Values(Case{"vector", TurnLaw::vector, {}},
                                         Case{"documented", TurnLaw::documented, {}}, Case{"any", TurnLaw::any, {}},
                                         Case{"tolerances", TurnLaw::vector, {0.01, 0.0005}},
                                         Case{"both", TurnLaw::documented, {0.01, 0.0005}}),
                         [](const testing::TestParamInfo<Case>& at) { return at.param.name; });

}  // namespace
}  // namespace gouge::stock_law_test
