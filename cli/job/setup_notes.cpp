#include "cli/job/setup_notes.h"

#include <algorithm>

#include "lib/clash/setup_overlaps.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr double kGap_mm = 0.01;  // of a depth that is a warning

std::string overlap_text(const Clash& clash, const std::string& part, const std::string& fixture, LengthUnit unit) {
  const std::string advice = "; check the set-up, or allow it with --allow-overlap " + fixture;
  if (clash.containment == Containment::b_in_a) return "the fixture is wholly inside the part " + part + advice;
  if (clash.containment == Containment::a_in_b) return "the part " + part + " is wholly inside the fixture" + advice;
  const std::string at = clash.deepest.empty() ? std::string() : " at " + point_text(clash.deepest.front().point, unit);
  return "the fixture and the part " + part + " penetrate each other, " + depth_text(clash.depth_mm, unit) + " deep" +
         at + advice;
}

}  // namespace

void note_setup(Job& job, const JobArguments& arguments, const PreparedScene& scene) {
  std::vector<bool> is_allowed;
  for (const MeshFacts& fixture : job.files->fixtures) {
    const auto& allowed = arguments.allowed_overlaps;
    is_allowed.push_back(std::find(allowed.begin(), allowed.end(), fixture.name) != allowed.end());
  }
  ClashOptions options;
  options.tolerance_mm = job.options.check.tolerance_mm;
  options.resolution_mm = job.options.check.resolution_mm;
  options.gap_mm = std::max(kGap_mm, options.resolution_mm);
  for (const SetupOverlap& overlap : find_setup_overlaps(scene, is_allowed, options)) {
    const std::string &part = job.files->parts[overlap.part].name, &fixture = job.files->fixtures[overlap.fixture].name;
    if (overlap.clash.state == ClashState::penetrating) {
      job.notes.push_back(
          make_warning(kFixtureOverlap, overlap_text(overlap.clash, part, fixture, job.toolpath.unit), fixture));
    } else {
      job.notes.push_back(make_warning(
          kFixtureUndecided,
          "whether the fixture penetrates the part " + part + " is not certified: " + overlap.clash.reason, fixture));
    }
  }
}

}  // namespace gouge
