#include "cli/job/claimed_scene.h"

#include <array>

#include "cli/values/parse_stock.h"
#include "lib/base/number_text.h"
#include "lib/base/sha256.h"
#include "lib/base/units.h"
#include "lib/path/motion_key.h"

namespace gouge {

ClaimedState claimed_state(MoveState state) {
  switch (state) {
    case MoveState::clean:
      return ClaimedState::clean;
    case MoveState::near_miss:
      return ClaimedState::near;
    case MoveState::gouge:
      return ClaimedState::gouge;
    case MoveState::buried:
      return ClaimedState::buried;
    case MoveState::not_certified:
      return ClaimedState::not_certified;
    case MoveState::not_checked:
      break;
  }
  return ClaimedState::not_checked;
}

namespace {

ClaimedRun claimed_run(TurnLaw law) {
  switch (law) {
    case TurnLaw::vector:
      break;
    case TurnLaw::axis:
      return ClaimedRun::rotary;
    case TurnLaw::documented:
      return ClaimedRun::documented;
    case TurnLaw::any:
      return ClaimedRun::any;
    case TurnLaw::joint:
      return ClaimedRun::together;
    case TurnLaw::independent:
      return ClaimedRun::independent;
  }
  return ClaimedRun::on_circle;
}

ClaimedJoints claimed_joints(const Machine& machine, const Job& job) {
  ClaimedJoints joints;
  for (const Joint& joint : machine.joints)
    joints.chain.push_back({joint.type == JointType::rotary, joint.direction, joint.point, joint.rate});
  joints.rotary = machine.rotary;
  joints.rest = machine.rest;
  joints.tool_length_mm = job.options.tool_length_mm.value_or(0);
  joints.feeds = claimed_run(job.laws.feeds);
  joints.rapids = claimed_run(job.laws.rapids);
  if (job.laws.joint_rapids) joints.joint_rapids = claimed_run(*job.laws.joint_rapids);
  return joints;
}

/// Adds the joints of a machine, with the length of each tool that has its own.
void add_joints(const ClaimedJoints& joints, ClaimedScene& scene) {
  scene.joints = joints;
  scene.joints_of_tool.clear();
  for (const PathTool& tool : scene.path.tools) {
    scene.joints_of_tool.push_back(joints);
    if (tool.gauge_length_mm) scene.joints_of_tool.back().tool_length_mm = *tool.gauge_length_mm;
  }
}

}  // namespace

ClaimedScene claimed_scene(const Job& job) {
  const CheckOptions& options = job.options.check;
  ClaimedScene scene{job.toolpath, job.tools(), job.scene().parts, job.scene().fixtures, {}};
  for (const HeadBody& head : job.heads()) scene.heads.emplace_back(head.whole.mesh());
  scene.axis_law = options.law.name();
  if (job.machine) add_joints(claimed_joints(*job.machine, job), scene);
  scene.is_dogleg = options.law.rapid() == RapidMode::dogleg;
  scene.tolerance_mm = options.tolerance_mm;
  scene.resolution_mm = options.resolution_mm;
  scene.threads = options.threads;
  for (const MeshLimit& limit : job.scene().limits)
    scene.limits.push_back({!rule_of(limit.against).is_workpiece, limit.mesh, limit.clearance_mm,
                            std::min(limit.tolerance_mm, options.tolerance_mm)});
  return scene;
}

namespace {

/// Returns a program whose motion follows the law of the scene.
ClaimedProgram program_of(const ClaimedScene& of_path, const Toolpath& path, const std::vector<StockTool>& tools) {
  ClaimedProgram program{ClaimedScene{path, {}, {}, {}, {}}, {}, {}};
  program.scene.axis_law = of_path.axis_law;
  program.scene.is_dogleg = of_path.is_dogleg;
  if (of_path.joints) add_joints(*of_path.joints, program.scene);
  for (const StockTool& tool : tools) {
    program.scene.tools.push_back(tool.tool);
    program.bare.push_back(tool.tool);
    program.cuts.push_back(tool.cuts);
  }
  return program;
}

}  // namespace

ClaimedStock claimed_stock(const Job& job, const JobArguments& arguments, const LoadedStock& stock) {
  const StockShape shape = parse_stock_shape(arguments.stock).value_or(StockShape{});
  ClaimedStock claimed;
  claimed.tolerance_mm = stock.setup->options.tolerance_mm;
  claimed.resolution_mm = stock.setup->options.resolution_mm;
  const auto is_open = [](TurnLaw law) { return law == TurnLaw::documented || law == TurnLaw::any; };
  claimed.is_motion_open =
      !job.options.check.tube.is_empty() || (job.machine && (is_open(job.laws.feeds) || is_open(job.laws.rapids)));
  const std::vector<IndexedMesh>& parts = job.scene().parts;
  if (shape.kind == StockShape::Kind::box) {
    Box3 box;
    for (const IndexedMesh& part : parts)
      for (const Vec3& vertex : part.vertices) box.extend(vertex);
    claimed.low = box.min() - Vec3::Constant(shape.allowance_mm);
    claimed.high = box.max() + Vec3::Constant(shape.allowance_mm);
  } else {
    claimed.allowance_mm = shape.allowance_mm;
    if (shape.kind == StockShape::Kind::part)
      for (const IndexedMesh& part : parts) claimed.solids.emplace_back(part);
    else
      for (const IndexedMesh& mesh : stock.meshes) claimed.solids.emplace_back(mesh);
  }
  const ClaimedScene scene = claimed_scene(job);
  for (const EarlierProgram& earlier : stock.setup->before)
    claimed.programs.push_back(program_of(scene, earlier.path, earlier.tools));
  claimed.programs.push_back(program_of(scene, job.toolpath, stock.setup->tools));
  claimed.heads = scene.heads;
  return claimed;
}

std::vector<MoveClaim> claims_of(const CheckResult& result) {
  std::vector<MoveClaim> claims;
  claims.reserve(result.verdicts.size());
  for (const MoveVerdict& verdict : result.verdicts) {
    MoveClaim& claim = claims.emplace_back();
    if (verdict.is_in_stock()) continue;
    claim.state = claimed_state(verdict.state);
    claim.depth_mm = verdict.depth_mm;
    if (std::isfinite(verdict.depth_upper_mm)) claim.depth_upper_mm = verdict.depth_upper_mm;
  }
  return claims;
}

StockDepths stock_depths_of(const CheckResult& result, const ClaimedStock& stock) {
  StockDepths depths;
  depths.reserve(result.verdicts.size());
  for (const MoveVerdict& verdict : result.verdicts) {
    std::optional<double>& depth = depths.emplace_back();
    const ClaimedState state = claimed_state(verdict.state);
    if (verdict.is_in_stock() && std::isfinite(verdict.depth_upper_mm)) depth = verdict.depth_upper_mm;
    if (state == ClaimedState::clean || state == ClaimedState::near) depth = stock.largest_clear_mm();
  }
  return depths;
}

namespace {

/// Returns the hash of all motions, as a result lists them, and of the identities of all tools.
std::string motions_digest(const Job& job) {
  Sha256 hash;
  const MotionLaw& law = job.options.check.law;
  for (std::size_t i = 0; i < job.toolpath.moves.size(); ++i)
    hash.add(motion_key(job.toolpath, i, law.is_by_axes(job.toolpath.moves[i])).substr(0, kListedMotionDigits));
  for (const ToolFacts& tool : job.tool_facts) hash.add(tool.identity);
  return hash.finish();
}

}  // namespace

std::string inputs_digest(const std::vector<InputFile>& inputs, const Job& job, const JobArguments& arguments) {
  std::string all;
  for (const InputFile& input : inputs) all += input.role + " " + input.checksum + "\n";
  constexpr int kDecimals = 9;  // a result has lengths in the unit of its toolpath, so their last bits may differ
  const CheckOptions& options = job.options.check;
  const RigidTransform& place = job.options.place;
  const auto add = [&](const char* name, const auto& numbers) {
    all += name;
    for (const double number : numbers) all += " " + fixed_text(number, kDecimals);
    all += "\n";
  };
  all += "unit " + std::string(facts_of(job.stl_unit(arguments)).option) + "\n";
  add("shift", place.shift);
  add("rotation", place.rotation.reshaped<Eigen::RowMajor>());
  add("offsets", std::array{options.stock_to_leave_mm, options.shank_clearance_mm, options.holder_clearance_mm});
  all += "motions " + motions_digest(job) + "\n";
  all += "rapids " + std::string(rapid_word(options.law.rapid())) + "\n";
  const auto stock = arguments.stock.empty() ? std::nullopt : parse_stock_shape(arguments.stock);
  if (stock && stock->kind != StockShape::Kind::file)
    add(stock->kind == StockShape::Kind::box ? "stock box" : "stock part", std::array{stock->allowance_mm});
  return sha256_of(all);
}

Diagnostics describe_unproved(const Job& job, const MadeCertificate& certificate) {
  Diagnostics warnings;
  const auto add = [&](const SectionProofs& proofs, const std::string& what) {
    if (proofs.not_proved.empty()) return;
    const std::size_t move = proofs.not_proved.front();
    warnings.push_back(make_warning("certificate-incomplete",
                                    "no proof" + what + " was found within its budget for " +
                                        count_text(proofs.not_proved.size(), "move") + ", first for move " +
                                        std::to_string(move) + "; the certificate says so of them",
                                    job.toolpath.file, job.toolpath.moves[move].line));
  };
  add(certificate.surfaces, "");
  add(certificate.stock, " about the stock");
  return warnings;
}

}  // namespace gouge
