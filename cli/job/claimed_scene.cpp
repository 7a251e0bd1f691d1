#include "cli/job/claimed_scene.h"

#include "lib/base/number_text.h"
#include "lib/base/sha256.h"

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

ClaimedScene claimed_scene(const Job& job) {
  const CheckOptions& options = job.options.check;
  ClaimedScene scene{job.toolpath, job.tools(), job.scene().parts, job.scene().fixtures, {}};
  for (const HeadBody& head : job.heads()) scene.heads.emplace_back(head.whole.mesh());
  scene.axis_law = options.law.name();
  if (job.machine) {
    const Machine& machine = *job.machine;
    scene.joints =
        ClaimedJoints{machine.joints[machine.rotary[0]].direction, machine.joints[machine.rotary[1]].direction,
                      options.law.is_by_axes(MoveKind::feed), options.law.is_by_axes(MoveKind::rapid)};
  }
  scene.is_dogleg = options.law.rapid() == RapidMode::dogleg;
  scene.tolerance_mm = options.tolerance_mm;
  scene.resolution_mm = options.resolution_mm;
  scene.threads = options.threads;
  for (const MeshLimit& limit : job.scene().limits)
    scene.limits.push_back({!rule_of(limit.against).is_workpiece, limit.mesh, limit.clearance_mm,
                            std::min(limit.tolerance_mm, options.tolerance_mm)});
  return scene;
}

std::vector<MoveClaim> claims_of(const CheckResult& result) {
  std::vector<MoveClaim> claims;
  claims.reserve(result.verdicts.size());
  for (const MoveVerdict& verdict : result.verdicts) {
    MoveClaim claim;
    claim.state = claimed_state(verdict.state);
    claim.depth_mm = verdict.depth_mm;
    if (std::isfinite(verdict.depth_upper_mm)) claim.depth_upper_mm = verdict.depth_upper_mm;
    claims.push_back(claim);
  }
  return claims;
}

std::string inputs_digest(const std::vector<InputFile>& inputs) {
  std::string all;
  for (const InputFile& input : inputs) all += input.role + " " + input.checksum + "\n";
  return sha256_of(all);
}

Diagnostic describe_unproved(const Job& job, const MadeCertificate& certificate) {
  const std::size_t move = certificate.not_proved.front();
  return make_warning("certificate-incomplete",
                      "no proof was found within its budget for " + count_text(certificate.not_proved.size(), "move") +
                          ", first for move " + std::to_string(move) + "; the certificate says so of them",
                      job.toolpath.file, job.toolpath.moves[move].line);
}

}  // namespace gouge
