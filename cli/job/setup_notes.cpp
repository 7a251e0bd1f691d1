#include "cli/job/setup_notes.h"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

#include "cli/terminal/length_text.h"
#include "lib/base/number_text.h"
#include "lib/clash/clash.h"
#include "lib/correct/laws.h"
#include "lib/path/axis_quality.h"
#include "lib/path/axis_tilt.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_text.h"
#include "toolmodels/compile_tool.h"

namespace gouge {

namespace {

constexpr double kGap_mm = 0.01;  // allowed gap of the bounds of a depth that is a warning

std::string overlap_text(const Clash& clash, const std::string& part, const std::string& fixture, LengthUnit unit) {
  const std::string advice = "; check the set-up, or allow it with --allow-overlap " + fixture;
  if (clash.containment == Containment::b_in_a) return "the fixture is wholly inside the part " + part + advice;
  if (clash.containment == Containment::a_in_b) return "the part " + part + " is wholly inside the fixture" + advice;
  const std::string at = clash.deepest.empty() ? std::string() : " at " + point_text(clash.deepest.front().point, unit);
  return "the fixture and the part " + part + " penetrate each other, " + depth_text(clash.depth_mm, unit) + " deep" +
         at + advice;
}

/// Returns the largest radius of the cutter of a tool; 0 if it has no profile.
double cutter_radius_mm(const ToolAssembly& tool) {
  const Result<BodyProfiles> bodies = make_body_profiles(tool);
  if (!bodies) return 0;
  double radius_mm = 0;
  for (const ProfileElement& one : (*bodies)[static_cast<std::size_t>(Body::cutter)].elements)
    radius_mm = std::max({radius_mm, one.a.x(), one.b.x()});
  return radius_mm;
}

/// Returns a note about options that say nothing about this toolpath.
Diagnostics describe_unused_options(const Job& job, const JobArguments& arguments) {
  const bool is_program = job.toolpath.dialect == gcode_dialect().id;
  std::vector<std::string> unused = options_without_effect(arguments.reading, is_program);
  Diagnostics notes;
  const auto add = [&](const std::string& why) {
    notes.push_back(make_note(kOptionUnused,
                              listed(unused, " and ") + (unused.size() == 1 ? " has" : " have") + " no effect: " + why,
                              arguments.path));
  };
  if (!unused.empty()) add(is_program ? "the toolpath is a program of a control" : "the toolpath is CL data");
  unused.clear();
  if (!is_program && !job.machine) {
    if (!arguments.tool_length.empty()) unused.emplace_back("--tool-length");
    if (!arguments.joint_rapid_law.empty()) unused.emplace_back("--joint-rapid-law");
  }
  if (!unused.empty()) add("no --machine is given");
  return notes;
}

/// Returns the warning about a tolerance that hides gouges as deep as a cutter is wide.
Diagnostics doubts_about_tolerance(const Job& job, const std::string& file) {
  const ToolAssembly* thinnest = nullptr;
  double radius_mm = job.options.check.tolerance_mm;
  for (const auto& tool : job.assemblies) {
    const double its_mm = tool ? cutter_radius_mm(*tool) : radius_mm;
    if (!(its_mm < radius_mm)) continue;
    radius_mm = its_mm;
    thinnest = &*tool;
  }
  if (thinnest == nullptr) return {};
  const LengthUnit unit = job.toolpath.unit;
  return {make_warning("tolerance-large",
                       "the tolerance of " + length_text(job.options.check.tolerance_mm, unit) +
                           " is more than the cutter radius of tool " + label(*thinnest) + ", " +
                           length_text(radius_mm, unit) + ": gouges up to this tolerance count as clean",
                       file)};
}

/// Returns the warning about a resolution that is coarser than the tolerance and than the default.
Diagnostics doubts_about_resolution(const CheckOptions& check, LengthUnit unit, const std::string& file) {
  if (check.resolution_mm <= std::max(check.tolerance_mm, CheckOptions().resolution_mm)) return {};
  return {make_warning("resolution-large",
                       "the resolution of " + length_text(check.resolution_mm, unit) +
                           " is more than the tolerance of " + length_text(check.tolerance_mm, unit) +
                           ": gouges up to " + length_text(check.tolerance_mm + check.resolution_mm, unit) +
                           " deep may stay unseen; give a finer --resolution",
                       file)};
}

}  // namespace

Diagnostics setup_notes(const Job& job, const JobArguments& arguments, const PreparedScene& scene) {
  Diagnostics notes = doubts_about_tolerance(job, arguments.path);
  std::ranges::move(doubts_about_resolution(job.options.check, job.toolpath.unit, arguments.path),
                    std::back_inserter(notes));
  std::ranges::move(describe_unused_options(job, arguments), std::back_inserter(notes));
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
      notes.push_back(
          make_warning(kFixtureOverlap, overlap_text(overlap.clash, part, fixture, job.toolpath.unit), fixture));
    } else {
      notes.push_back(make_warning(
          kFixtureUndecided,
          "whether the fixture penetrates the part " + part + " is not certified: " + overlap.clash.reason, fixture));
    }
  }
  return notes;
}

Result<std::vector<StickoutFacts>> find_stickouts_of(const Job& job, const PreparedScene& scene,
                                                     const CheckResult& result, bool is_extended_up,
                                                     const StickoutOptions& options, const ProgressCall& progress) {
  const CheckOptions& check = job.options.check;
  const MakeLongerTool make = [&](std::size_t tool, double longer_mm) -> Result<LongerTool> {
    const ToolAssembly longer = with_longer_stickout(*job.assemblies[tool], longer_mm);
    Result<ToolVariants> bodies =
        make_non_cutting_variants(is_extended_up ? job.without_end(longer) : longer, check.shank_clearance_mm,
                                  check.holder_clearance_mm, check.tube);
    if (!bodies) return bodies.error();
    Result<std::vector<HeadBody>> heads = moved_up(job.heads(), longer_mm);
    if (!heads) return heads.error();
    return LongerTool{std::move(*bodies), std::move(*heads)};
  };
  std::vector<std::optional<double>> now_mm;
  for (const auto& tool : job.assemblies) now_mm.push_back(tool ? std::optional(stickout_mm(*tool)) : std::nullopt);
  Result<std::vector<ToolStickout>> found =
      find_stickouts(job.toolpath, result, job.setup(scene), now_mm, make, options, progress);
  if (!found) return found.error();
  std::vector<StickoutFacts> facts;
  for (ToolStickout& one : *found) {
    const ToolAssembly& tool = *job.assemblies[one.tool];
    const bool is_stated = tool.stickout_mm > 0;
    facts.push_back({std::move(one), is_stated ? std::optional(shank_end_mm(tool)) : std::nullopt});
  }
  return facts;
}

namespace {

constexpr double kSlowest = 0.001;                             // in degrees a minute: half a turn takes 120 days
constexpr double kRadPerSecond = std::numbers::pi / 180 / 60;  // one degree a minute

std::vector<std::size_t> origins_of(const Toolpath& before, const std::vector<PathChange>& changes) {
  const std::vector<MovesAfter> spans = moves_after(before.moves.size(), changes);
  std::vector<std::size_t> origins(spans.empty() ? 0 : spans.back().last);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    std::fill(origins.begin() + static_cast<std::ptrdiff_t>(spans[i].first),
              origins.begin() + static_cast<std::ptrdiff_t>(spans[i].last), i);
  }
  return origins;
}

}  // namespace

Result<RotaryLimit> understand_rotary_limit(const std::string& typed) {
  if (typed.empty()) return RotaryLimit();
  const std::optional<double> speed = parse_number(typed);
  if (speed && *speed >= kSlowest) return RotaryLimit(speed);
  return usage_error("--max-rotary-speed", typed, "degrees a minute, at least 0.001");
}

AxisFacts measure_axes(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after,
                       const RotaryLimit& limit) {
  const std::optional<double> rad_per_s = limit ? std::optional(*limit * kRadPerSecond) : std::nullopt;
  AxisFacts facts;
  facts.before = measure_axis_quality(before, rad_per_s);
  facts.after = measure_axis_quality(after, rad_per_s);
  facts.tilts = find_axis_tilts(before, after, origins_of(before, changes));
  facts.max_rotary_deg_per_min = limit;
  return facts;
}

}  // namespace gouge
