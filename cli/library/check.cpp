#include <algorithm>
#include <optional>
#include <utility>

#include <gougecheck/check.h>

#include "cli/library/checked_path.h"
#include "lib/base/units.h"
#include "lib/correct/correct_path.h"
#include "lib/machine/joint_reach.h"
#include "postproc/formats/write_corrected.h"

namespace gougecheck {
namespace {

Report run(CheckedPath checked) {
  gouge::CheckResult result = gouge::check(checked.path.content().path, checked.setup());
  return make_report(std::move(checked), std::move(result));
}

gouge::BodyStrategies to_strategies(const std::string& name) {
  using gouge::Strategy;
  if (name == "auto") return {};
  for (const Strategy strategy :
       {Strategy::weighted, Strategy::axis, Strategy::tilt, Strategy::normal, Strategy::trim}) {
    if (name != gouge::strategy_name(strategy)) continue;
    gouge::BodyStrategies all = gouge::BodyStrategies::all(strategy);
    // A cutter that gouges is inside the surface that it has to touch, so no tilt about the contact frees it.
    if (strategy == Strategy::tilt)
      all.of[static_cast<std::size_t>(gouge::Body::cutter)] = gouge::BodyStrategies::kOfCutter;
    return all;
  }
  raise(gouge::make_error("usage", "strategy '" + name + "': expected auto, weighted, normal, axis, tilt or trim"));
}

double above_zero(const char* name, double value, double most) {
  if (value > 0 && value <= most) return value;
  raise(gouge::make_error("usage", std::string(name) + ": expected a number above 0 and at most " +
                                       std::to_string(static_cast<int>(most))));
}

gouge::CorrectOptions to_correct_options(const CorrectOptions& how) {
  constexpr double kFarthest_mm = 100'000, kMaxTilt_deg = 89;
  gouge::CorrectOptions options;
  options.strategies = to_strategies(how.strategy);
  options.max_shift_mm = above_zero("max_shift", how.max_shift, kFarthest_mm);
  if (how.max_side_shift) options.max_side_shift_mm = above_zero("max_side_shift", *how.max_side_shift, kFarthest_mm);
  options.tilt.max_tilt_rad = above_zero("max_tilt", how.max_tilt, kMaxTilt_deg) * gouge::kDegree_rad;
  if (!(how.rapid_clearance >= 0 && how.rapid_clearance <= kFarthest_mm))
    raise(gouge::make_error("usage", "rapid_clearance: expected a length of at least 0"));
  options.rapid_clearance_mm = how.rapid_clearance;
  return options;
}

Correction run_correction(CheckedPath checked, const CorrectOptions& how) {
  if (checked.stock != nullptr)
    raise(gouge::make_error("usage", "stock: corrections do not cover remaining stock; expected options without it"));
  gouge::CorrectOptions options = to_correct_options(how);
  const gouge::Toolpath& path = checked.path.content().path;
  const gouge::RewritableMoves rewritable = gouge::rewritable_moves(path);
  options.rewritable = &rewritable;
  if (checked.machine != nullptr)
    options.tilt.reach = std::make_shared<const gouge::JointReach>(checked.machine->chosen.machine, path,
                                                                   checked.machine->chosen.tool_length_mm);
  const gouge::CheckSetup setup = checked.setup();
  gouge::CheckResult before = gouge::check(path, setup);
  const auto rewrite = [&](const std::vector<gouge::PathChange>& changes) -> gouge::Result<gouge::Toolpath> {
    gouge::Result<std::string> bytes = gouge::write_corrected(path, changes);
    if (!bytes) return bytes.error();
    gouge::ReadOptions as_before;
    as_before.dialect = gouge::dialect_called(path.dialect);
    const std::optional<ReadFacts>& facts = checked.path.content().facts;
    as_before.is_cutcom_centre = facts && !facts->cutcom.empty();
    as_before.harmless_words = path.harmless_words;
    as_before.retract_plane_mm = path.retract_plane_mm;
    if (!path.is_unit_stated) as_before.unit = path.unit;
    gouge::Toolpath again = PathAccess::from_bytes(path.file, std::move(*bytes), as_before).content().path;
    if (checked.machine != nullptr)
      static_cast<void>(gouge::choose_joints_of(checked.machine->chosen.machine, checked.machine->chosen.law,
                                                checked.machine->chosen.tool_length_mm,
                                                gouge::needs_turn(checked.machine->chosen.laws, false), again));
    for (const gouge::Subject fact : {gouge::Subject::dialect, gouge::Subject::path_unit})
      gouge::copy_facts(fact, path.assumptions, again.assumptions);
    return again;
  };
  gouge::LawfulCorrection corrected = value_or_raise(gouge::correct_lawfully(path, before, setup, options, rewrite));
  CheckedPath after = checked;
  after.path = PathAccess::rewritten(std::move(corrected.after.path));
  const Path written = after.path;
  Correction result{written,
                    make_report(std::move(checked), std::move(before)),
                    make_report(std::move(after), std::move(corrected.after.result)),
                    {},
                    {}};
  for (const gouge::ChangeRecord& r : corrected.correction.records) {
    result.changes.push_back({r.move, r.is_inserted, to_array(r.shift_mm), r.tilt_rad / gouge::kDegree_rad,
                              r.depth_before_mm, r.depth_after_mm});
  }
  for (const gouge::Uncorrected& u : corrected.correction.uncorrected)
    result.uncorrected.push_back({u.move, u.depth_mm, u.reason});
  return result;
}

/// Returns the path with statements. A correction rewrites the statements of a file, so a path from memory gets its
/// statements here.
Path with_statements(const Path& path) {
  if (!path.content().is_from_memory) return path;
  gouge::ReadOptions as_apt;
  as_apt.dialect = gouge::dialect_called("apt");
  return PathAccess::from_bytes(path.name(), path.text(), as_apt);
}

}  // namespace

Report check(const Path& path, const Scene& scene, const Tool& tool, const CheckOptions& options) {
  return run(prepare(path, scene, tool, options));
}

Report check(const Path& path, const Scene& scene, const ToolLibrary& tools, const CheckOptions& options) {
  return run(prepare(path, scene, tools, options));
}

Correction correct(const Path& path, const Scene& scene, const Tool& tool, const CheckOptions& options,
                   const CorrectOptions& how) {
  return run_correction(prepare(with_statements(path), scene, tool, options), how);
}

Correction correct(const Path& path, const Scene& scene, const ToolLibrary& tools, const CheckOptions& options,
                   const CorrectOptions& how) {
  return run_correction(prepare(with_statements(path), scene, tools, options), how);
}

}  // namespace gougecheck
