// Verdicts by the law of two rotary joints, against dense evaluation of the machine's own formula, for machines of every
// arrangement. GOUGE_MACHINE_MOVES sets how many moves a machine has; docs/develop/testing.md has the longest run.
#include <gtest/gtest.h>

#include <cstdlib>

#include "lib/machine/rotary_law.h"
#include "lib/tool/evaluate.h"
#include "tests/laws/random_moves.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/whole_check.h"

namespace gouge {
namespace {

constexpr int kInstants = 200;
constexpr double kRounding_mm = 1e-7, kWitness_mm = 1e-6;

std::size_t wanted_moves() {
  const char* const given = std::getenv("GOUGE_MACHINE_MOVES");
  return given == nullptr ? 100 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// The pose at t by the formula of the machine: the tip on its line, both joints evenly.
Pose pose_at(const Machine& machine, const JointPath& joints, const Toolpath& path, std::size_t move, double t) {
  const RotaryAngles &from = *joints.start[move], &to = *joints.end[move];
  const double alpha = (1 - t) * from[0] + t * to[0], beta = (1 - t) * from[1] + t * to[1];
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(alpha, machine.joints[machine.rotary[0]].direction).toRotationMatrix() *
      Eigen::AngleAxisd(beta, machine.joints[machine.rotary[1]].direction).toRotationMatrix();
  const Vec3 &a = path.start_of(move).tip, &b = path.moves[move].end.tip;
  return {(1 - t) * a + t * b, turned * Vec3::UnitZ()};
}

double depth_in(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  return tool.elements.empty() ? -1e9 : -signed_distance_mm(tool, pose, point);
}

class Campaign {
 public:
  explicit Campaign(const Machine& machine) : machine_(machine) {}

  void run(std::size_t moves) {
    for (std::uint64_t stream = 0; moves_ < moves; ++stream) {
      laws::RandomJobs jobs(stream);
      for (int k = 0; k < 8 && moves_ < moves; ++k) check_job(jobs.next());
    }
  }

  std::size_t gouges = 0, clean = 0, turning = 0;

 private:
  void check_job(laws::RandomJob job) {
    // Most paths of a job keep their axis: here it turns in every straight move.
    for (Move& move : job.path.moves) {
      if (move.curve_kind == CurveKind::none && move.kind != MoveKind::cycle) move.end.axis = scatter_.axis(0.7);
    }
    job.path.joints = std::make_shared<const JointPath>(choose_joints(machine_, job.path).path);
    CheckOptions options;
    options.threads = 1;
    options.law = {RapidMode::straight, std::make_shared<RotaryLaw>(machine_)};
    const CheckResult result = whole_check(job.path, &job.tool, job.scene, options);
    for (std::size_t i = 0; i < job.path.moves.size(); ++i) {
      ++moves_;
      const Move& move = job.path.moves[i];
      const bool is_straight = move.has_start && move.curve_kind == CurveKind::none;
      if (is_straight && job.path.joints->start[i] && job.path.joints->end[i]) check_move(job, result.verdicts[i], i);
    }
  }

  void check_move(const laws::RandomJob& job, const MoveVerdict& verdict, std::size_t i) {
    const JointPath& joints = *job.path.joints;
    if (std::abs((*joints.end[i])[0] - (*joints.start[i])[0]) > 0.1) ++turning;
    const bool is_known = verdict.state == MoveState::clean || verdict.state == MoveState::gouge;
    if (!is_known) return;
    (verdict.state == MoveState::clean ? clean : gouges) += 1;
    for (int n = 0; n <= kInstants; ++n) {
      const Pose pose = pose_at(machine_, joints, job.path, i, static_cast<double>(n) / kInstants);
      for (const IndexedMesh& part : job.scene.parts) {
        for (const Vec3& vertex : part.vertices)
          ASSERT_LE(depth_in(job.tool.against_part, pose, vertex), verdict.depth_upper_mm + kRounding_mm)
              << machine_.name << ", " << job.tool_name << ", move " << i << " at " << n;
      }
    }
    if (verdict.state != MoveState::gouge || !verdict.witness) return;
    const Witness& witness = *verdict.witness;
    const Pose pose = pose_at(machine_, joints, job.path, i, witness.t);
    const CompiledTool& form = witness.against == Against::part ? job.tool.against_part : job.tool.against_fixture;
    const double depth =
        std::max(depth_in(form, pose, witness.point), depth_in(job.tool.with_clearance, pose, witness.point));
    ASSERT_NEAR(depth, verdict.depth_mm, kWitness_mm) << machine_.name << ", " << job.tool_name << ", move " << i;
  }

  const Machine& machine_;
  test::Scatter scatter_{20261128};
  std::size_t moves_ = 0;
};

TEST(MachineLaw, AgreesWithTheFormulaOfEveryArrangement) {
  for (const Machine& machine : test::machines()) {
    Campaign campaign(machine);
    campaign.run(wanted_moves());
    EXPECT_GT(campaign.gouges, wanted_moves() / 20) << machine.name;
    EXPECT_GT(campaign.clean, wanted_moves() / 20) << machine.name;
    EXPECT_GT(campaign.turning, wanted_moves() / 20) << machine.name;
    std::cout << machine.name << ": " << campaign.clean << " clean, " << campaign.gouges << " gouges, "
              << campaign.turning << " turn a table or the first joint of a head\n";
  }
}

}  // namespace
}  // namespace gouge
