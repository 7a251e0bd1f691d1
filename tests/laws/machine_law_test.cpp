// Verdicts by each law of motion, against dense evaluation of the machine's own formula, for every preset.
// GOUGE_MACHINE_MOVES sets how many moves a machine has by a law; docs/develop/testing.md has the longest run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "lib/machine/joint_law.h"
#include "lib/machine/read_machine.h"
#include "lib/machine/rotary_law.h"
#include "lib/tool/evaluate.h"
#include "tests/laws/random_moves.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/machine_reference.h"
#include "tests/support/whole_check.h"

namespace gouge::machine_law_test {
namespace {

constexpr int kInstants = 80;
constexpr double kRounding_mm = 1e-7, kWitness_mm = 1e-6, kToolLength_mm = 90;

std::size_t wanted_moves() {
  const char* const given = std::getenv("GOUGE_MACHINE_MOVES");
  return given == nullptr ? 60 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// All presets, which have every arrangement, without and with a part zero; what they leave empty is any number here.
std::vector<Machine> all_machines() {
  std::vector<Machine> all;
  for (const MachinePreset& preset : machine_presets())
    all.push_back(read_machine(std::string(preset.name), preset.text).value());
  for (Machine& machine : all) {
    for (std::size_t k = 0; k < machine.joints.size(); ++k) {
      Joint& joint = machine.joints[k];
      if (joint.type == JointType::rotary && !joint.has_point)
        joint.point = Vec3(3, -2, 5) * static_cast<double>(k + 1);
      if (!joint.rate) joint.rate = joint.type == JointType::rotary ? 40 : 3000 + 500.0 * static_cast<double>(k);
    }
  }
  test::Scatter scatter(63);
  const std::size_t presets = all.size();
  for (std::size_t k = 0; k < presets; ++k) {
    RigidTransform zero = test::random_zero(scatter);
    zero.shift *= 0.1;
    all.push_back(place_part(all[k], zero));
    all.back().name += " with a part zero";
  }
  return all;
}

MotionLaw law_on(const Machine& machine, TurnLaw law) {
  switch (law) {
    case TurnLaw::vector:
      break;
    case TurnLaw::axis:
      return {RapidMode::straight, std::make_shared<RotaryLaw>(machine)};
    case TurnLaw::documented:
      return {RapidMode::straight, std::make_shared<RotaryLaw>(machine, LawScope::documented)};
    case TurnLaw::any:
      return {RapidMode::straight, std::make_shared<RotaryLaw>(machine, LawScope::any)};
    case TurnLaw::joint:
      return {RapidMode::straight, std::make_shared<JointLaw>(machine, JointTiming::together, kToolLength_mm)};
    case TurnLaw::independent:
      return {RapidMode::straight, std::make_shared<JointLaw>(machine, JointTiming::independent, kToolLength_mm)};
  }
  return {};
}

double depth_in(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  return tool.elements.empty() ? -1e9 : -signed_distance_mm(tool, pose, point);
}

/// The same for a point that may be outside of the tool's extent, where it is -1e9.
double depth_within(const CompiledTool& tool, const Pose& pose, const Vec3& point) {
  const Vec3 from_tip = point - pose.tip;
  const double z = from_tip.dot(pose.axis);
  if (z < tool.z_min_mm || z > tool.z_max_mm) return -1e9;
  if (from_tip.squaredNorm() - z * z > tool.r_max_mm * tool.r_max_mm) return -1e9;
  return depth_in(tool, pose, point);
}

/// Points of the surface: corners and middles of triangles. A mesh may have vertices that no triangle uses.
std::vector<Vec3> surface_points(const std::vector<IndexedMesh>& meshes) {
  std::vector<Vec3> points;
  for (const IndexedMesh& mesh : meshes) {
    std::vector<bool> is_used(mesh.vertices.size(), false);
    for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
      Vec3 sum = Vec3::Zero();
      for (const auto corner : mesh.triangles[n]) {
        is_used[corner] = true;
        sum += mesh.vertices[corner];
      }
      points.push_back(sum / 3);
    }
    for (std::size_t v = 0; v < is_used.size(); ++v)
      if (is_used[v]) points.push_back(mesh.vertices[v]);
  }
  return points;
}

/// Checks random moves by one law and compares them with the formula of another, or of the same.
class Campaign {
 public:
  /// `streams`: the first stream of random jobs.
  Campaign(const Machine& machine, TurnLaw checked, TurnLaw reference, std::uint64_t streams)
      : machine_(machine), checked_(checked), reference_(reference), stream_(streams), scatter_(streams) {}

  void run(std::size_t moves) {
    for (; moves_ < moves; ++stream_) {
      laws::RandomJobs jobs(stream_);
      for (int k = 0; k < 8 && moves_ < moves; ++k) {
        laws::RandomJob job = jobs.next();
        // Random profiles take most of the time and no law depends on the profile: one job of ten has one.
        if (job.tool_name.starts_with("free") && scatter_.in(0, 1) > 0.1) continue;
        check_job(std::move(job));
      }
    }
  }

  std::size_t gouges = 0, clean = 0, turning = 0;
  std::size_t too_deep = 0, unreal = 0;  ///< moves deeper than proved; witnesses that are not there
  std::string first_fault;

 private:
  void check_job(laws::RandomJob job) {
    turn_axes(job.path);
    job.path.joints = std::make_shared<const JointPath>(choose_joints(machine_, job.path).path);
    CheckOptions options;
    options.threads = 1;
    options.resolution_mm = 0.01;  // a bound may be above the truth by no less, and moves are cut less often
    options.law = law_on(machine_, checked_);
    const CheckResult result = whole_check(job.path, &job.tool, job.scene, options);
    const std::vector<Vec3> points = surface_points(job.scene.parts);
    for (std::size_t i = 0; i < job.path.moves.size(); ++i) {
      const Move& move = job.path.moves[i];
      const bool is_straight = move.has_start && move.curve_kind == CurveKind::none;
      if (!is_straight || !job.path.joints->start[i] || !job.path.joints->end[i]) continue;
      ++moves_;
      check_move(job, points, result.verdicts[i], i);
    }
  }

  /// Makes every move straight and turns the axis in it: in one of ten by any angle, otherwise as in toolpaths. Small turns
  /// have tight bounds.
  void turn_axes(Toolpath& path) {
    Vec3 axis = scatter_.axis(0.7);
    for (Move& move : path.moves) {
      const bool is_wide = scatter_.in(0, 1) < 0.1;
      axis = is_wide ? scatter_.axis(0.7)
                     : Vec3((axis + std::pow(10, scatter_.in(-3, -1)) * scatter_.point(1)).normalized());
      move.end.axis = axis;
      move.curve_kind = CurveKind::none;
    }
  }

  void check_move(const laws::RandomJob& job, const std::vector<Vec3>& points, const MoveVerdict& verdict,
                  std::size_t i) {
    const JointPath& joints = *job.path.joints;
    const test::MachineReference reference(machine_, kToolLength_mm);
    const test::MachineReference::Ends ends =
        reference.with_joints({job.path.start_of(i), job.path.moves[i].end, *joints.start[i], *joints.end[i], {}, {}});
    if (std::abs(ends.angles1[0] - ends.angles0[0]) > 0.02) ++turning;
    const bool is_known = verdict.state == MoveState::clean || verdict.state == MoveState::gouge;
    if (!is_known) return;
    (verdict.state == MoveState::clean ? clean : gouges) += 1;
    double deepest = -1e9;
    for (int n = 0; n <= kInstants; ++n) {
      const Pose pose = admitted_pose(reference, ends, n);
      for (const Vec3& point : points) deepest = std::max(deepest, depth_within(job.tool.against_part, pose, point));
    }
    if (deepest > verdict.depth_upper_mm + kRounding_mm)
      note(too_deep, job, i, std::to_string(deepest) + " above " + std::to_string(verdict.depth_upper_mm));
    if (verdict.state != MoveState::gouge || !verdict.witness) return;
    const Witness& witness = *verdict.witness;
    const Pose pose = pose_of(witness, reference, ends);
    const CompiledTool& form = witness.against == Against::part ? job.tool.against_part : job.tool.against_fixture;
    const double depth =
        std::max(depth_in(form, pose, witness.point), depth_in(job.tool.with_clearance, pose, witness.point));
    if (std::abs(depth - verdict.depth_mm) > kWitness_mm)
      note(unreal, job, i, "a witness of " + std::to_string(verdict.depth_mm) + " is " + std::to_string(depth));
  }

  /// One of the poses that the law of the reference admits.
  Pose admitted_pose(const test::MachineReference& reference, const test::MachineReference::Ends& ends, int n) {
    const double t = static_cast<double>(n) / kInstants;
    if (reference_ == TurnLaw::documented) return reference.at(n % 2 == 0 ? TurnLaw::vector : TurnLaw::axis, ends, t);
    if (reference_ != TurnLaw::any) return reference.at(reference_, ends, t);
    const auto share = [&] { return std::clamp(scatter_.in(-0.2, 1.2), 0.0, 1.0); };
    return reference.at(ends, t, {share(), share()});
  }

  /// The pose of a witness by the law of the reference. Its first motion is that of a witness without shares.
  Pose pose_of(const Witness& witness, const test::MachineReference& reference,
               const test::MachineReference::Ends& ends) const {
    if (witness.turn) return reference.at(ends, witness.t, *witness.turn);
    if (reference_ == TurnLaw::documented) return reference.at(TurnLaw::vector, ends, witness.t);
    return reference.at(reference_ == TurnLaw::any ? TurnLaw::axis : reference_, ends, witness.t);
  }

  void note(std::size_t& count, const laws::RandomJob& job, std::size_t move, const std::string& what) {
    ++count;
    if (first_fault.empty())
      first_fault = machine_.name + ", " + job.tool_name + ", move " + std::to_string(move) + ": " + what;
  }

  const Machine& machine_;
  TurnLaw checked_, reference_;
  std::uint64_t stream_;
  test::Scatter scatter_;
  std::size_t moves_ = 0;
};

class MachineLaw : public testing::TestWithParam<TurnLaw> {};

TEST_P(MachineLaw, AgreesWithTheFormulaOfEveryMachine) {
  std::uint64_t streams = 0;
  std::size_t moves = 0, gouges = 0, clean = 0, turning = 0;
  for (const Machine& machine : all_machines()) {
    Campaign campaign(machine, GetParam(), GetParam(), streams += 1'000'000);
    campaign.run(wanted_moves());
    EXPECT_EQ(campaign.too_deep, 0U) << campaign.first_fault;
    EXPECT_EQ(campaign.unreal, 0U) << campaign.first_fault;
    moves += wanted_moves();
    gouges += campaign.gouges;
    clean += campaign.clean;
    turning += campaign.turning;
    std::cout << machine.name << ": " << campaign.clean << " clean, " << campaign.gouges << " gouges, "
              << campaign.turning << " turn a table or the first joint of a head\n";
  }
  for (const std::size_t count : {gouges, clean, turning}) EXPECT_GT(count, moves / 10);
}

// So the test above can fail: the formula of another law finds moves deeper than proved, and witnesses that are not there.
TEST_P(MachineLaw, DisagreesWithTheFormulaOfAnotherLaw) {
  const auto other = static_cast<TurnLaw>((static_cast<std::size_t>(GetParam()) + 1) % kTurnLawNames.size());
  const Machine machine = all_machines().front();
  Campaign campaign(machine, GetParam(), other, 7'000'000);
  // The random moves depend on the compiler, and some hundreds of them may show too little.
  for (std::size_t moves = 300; moves <= 6000 && (campaign.too_deep == 0 || campaign.unreal <= 3); moves += 300)
    campaign.run(moves);
  EXPECT_GT(campaign.too_deep, 0U);
  EXPECT_GT(campaign.unreal, 3U);
}

INSTANTIATE_TEST_SUITE_P(All, MachineLaw,
                         testing::Values(TurnLaw::vector, TurnLaw::axis, TurnLaw::documented, TurnLaw::any,
                                         TurnLaw::joint, TurnLaw::independent),
                         [](const auto& tested) { return std::string(turn_law_name(tested.param)); });

}  // namespace
}  // namespace gouge::machine_law_test
