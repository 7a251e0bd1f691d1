// Certificates of random scenes on machines, by each law: accepted as they are, refused for the motion of another law, and no
// proof is found for less than a witness shows. GOUGE_VERIFY_SCENES sets how many scenes each machine has by a law.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "lib/machine/joint_law.h"
#include "lib/machine/joint_path.h"
#include "lib/machine/rotary_law.h"
#include "lib/verify/certificate.h"
#include "lib/verify/witness_check.h"
#include "tests/laws/random_scenes.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::machine_certificate_test {
namespace {

const std::string kInputs(64, 'a');
constexpr double kToolLength_mm = 90;

std::size_t wanted_scenes() {
  const char* const given = std::getenv("GOUGE_VERIFY_SCENES");
  return given == nullptr ? 2 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

std::vector<Machine> machines_with_rates() {
  std::vector<Machine> all = test::machines_and_placed();
  for (Machine& machine : all)
    for (std::size_t k = 0; k < 5; ++k) machine.joints[k].rate = 500.0 + 900.0 * static_cast<double>(k);
  for (Machine& machine : all)
    for (const std::size_t k : machine.rotary) machine.joints[k].rate = 20;
  return all;
}

std::shared_ptr<const AxisLaw> axes_by(const Machine& machine, ClaimedRun run) {
  if (run == ClaimedRun::rotary) return std::make_shared<RotaryLaw>(machine);
  const auto timing = run == ClaimedRun::together ? JointTiming::together : JointTiming::independent;
  return std::make_shared<JointLaw>(machine, timing, kToolLength_mm);
}

/// A random scene whose tool axis turns in every move, checked by a law, and what is claimed of it.
struct MachineCase {
  MachineCase(const Machine& machine, ClaimedRun run, std::size_t k)
      : scatter(5'000'000 + k), tool(tool_of(k)), random(scatter.scene(tool.against_part)) {
    // Two kinds of motion in one: all of these laws are of feeds and rapids alike here.
    for (Move& move : random.path.moves) {
      const Vec3 lean = scatter.point(0.4);
      move.end.axis = Vec3(lean.x(), lean.y(), 1).normalized();
    }
    random.path.joints = std::make_shared<const JointPath>(choose_joints(machine, random.path).path);
    CheckOptions options;
    options.law = {RapidMode::straight, axes_by(machine, run)};
    const CheckResult result = whole_check(random.path, &tool, random.scene, options);
    scene = std::make_unique<ClaimedScene>(
        ClaimedScene{random.path, {&tool}, random.scene.parts, random.scene.fixtures, {}});
    scene->axis_law = options.law.name();
    scene->joints = ClaimedJoints{};
    for (const Joint& joint : machine.joints)
      scene->joints->chain.push_back({joint.type == JointType::rotary, joint.direction, joint.point, joint.rate});
    scene->joints->rotary = machine.rotary;
    scene->joints->rest = machine.rest;
    scene->joints->tool_length_mm = kToolLength_mm;
    scene->joints->feeds = scene->joints->rapids = run;
    for (const MoveVerdict& verdict : result.verdicts) claims.push_back(claim_of(verdict, scene->largest_clean_mm()));
  }

  static const ToolVariants& tool_of(std::size_t k) {
    static const std::vector<ToolVariants> kTools = tools::all();
    return kTools[k % kTools.size()];
  }
  static MoveClaim claim_of(const MoveVerdict& v, double largest_clean_mm) {
    MoveClaim claim;
    claim.depth_mm = v.depth_mm;
    claim.depth_upper_mm = v.depth_upper_mm;
    claim.state = v.state == MoveState::not_checked      ? ClaimedState::not_checked
                  : v.depth_upper_mm <= largest_clean_mm ? ClaimedState::near
                                                         : ClaimedState::gouge;
    if (v.witness)
      claim.witness = ClaimedWitness{v.witness->t,
                                     v.witness->point,
                                     v.witness->normal,
                                     v.witness->body,
                                     v.witness->against == Against::fixture,
                                     v.witness->mesh,
                                     v.witness->triangle};
    else if (claim.state == ClaimedState::near)
      claim.state = ClaimedState::clean;
    return claim;
  }

  [[nodiscard]] MadeCertificate certificate() const { return make_certificate(*scene, claims, kInputs, {}); }
  [[nodiscard]] Result<CertificateReading> verify(std::string_view bytes) const {
    return verify_certificate(*scene, SceneOrders(*scene), claims, kInputs, "proofs.gcp", bytes, {});
  }

  laws::SceneScatter scatter;
  const ToolVariants& tool;
  laws::RandomScene random;
  std::unique_ptr<ClaimedScene> scene;
  std::vector<MoveClaim> claims;
};

class MachineCertificate : public testing::TestWithParam<ClaimedRun> {};

TEST_P(MachineCertificate, IsAcceptedAndItsWitnessesAreReal) {
  std::size_t moves = 0, gouges = 0, open = 0, stream = 0;
  for (const Machine& machine : machines_with_rates()) {
    for (std::size_t k = 0; k < wanted_scenes(); ++k) {
      const MachineCase of(machine, GetParam(), stream++);
      const MadeCertificate made = of.certificate();
      const auto read = of.verify(made.bytes);
      ASSERT_TRUE(read.has_value()) << read.error().message;
      for (const ProofRefutation& r : read->refuted)
        ADD_FAILURE() << machine.name << ", scene " << k << ", move " << r.move << ": " << r.what;
      const ClaimedTools tools = claimed_tools(*of.scene);
      for (std::size_t i = 0; i < of.claims.size(); ++i) {
        const auto fault = find_witness_fault(*of.scene, tools, i, of.claims[i]);
        EXPECT_FALSE(fault.has_value()) << machine.name << ", scene " << k << ", move " << i;
        gouges += of.claims[i].state == ClaimedState::gouge ? 1U : 0U;
      }
      moves += of.claims.size();
      open += made.surfaces.not_proved.size();
    }
  }
  std::cout << moves << " moves, " << gouges << " of them gouges, " << open << " without a proof\n";
  EXPECT_GT(gouges, 0U);
  EXPECT_LE(open * 5, moves);
}

TEST_P(MachineCertificate, ProvesNothingOfTheMotionOfAnotherLaw) {
  const ClaimedRun run = GetParam(),
                   other = run == ClaimedRun::together ? ClaimedRun::independent : ClaimedRun::together;
  std::size_t refuted = 0, stream = 500;
  for (const Machine& machine : machines_with_rates()) {
    const MachineCase of(machine, run, stream++);
    const MadeCertificate made = of.certificate();
    // The names agree, so that only the motion tells them apart.
    of.scene->joints->feeds = of.scene->joints->rapids = other;
    const auto read = of.verify(made.bytes);
    if (!read || !read->refuted.empty()) ++refuted;
  }
  EXPECT_GT(refuted, 2U);
}

TEST_P(MachineCertificate, NoProofIsFoundForLessThanAWitnessShows) {
  std::size_t asked = 0, stream = 900;
  for (const Machine& machine : machines_with_rates()) {
    MachineCase of(machine, GetParam(), stream++);
    for (MoveClaim& claim : of.claims) {
      const bool is_deep = claim.witness && claim.depth_mm > 1e-4;
      claim.state = is_deep ? ClaimedState::gouge : ClaimedState::not_checked;
      claim.depth_upper_mm = claim.depth_mm - 3e-6;
      asked += is_deep ? 1U : 0U;
    }
    EXPECT_EQ(of.certificate().surfaces.proved, 0U) << machine.name;
  }
  EXPECT_GT(asked, 3U);
}

INSTANTIATE_TEST_SUITE_P(All, MachineCertificate,
                         testing::Values(ClaimedRun::rotary, ClaimedRun::together, ClaimedRun::independent),
                         [](const auto& tested) {
                           return std::string(tested.param == ClaimedRun::rotary     ? "axis"
                                              : tested.param == ClaimedRun::together ? "joint"
                                                                                     : "independent");
                         });

}  // namespace
}  // namespace gouge::machine_certificate_test
