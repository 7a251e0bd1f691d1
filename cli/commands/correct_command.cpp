#include "cli/commands/correct_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/commands/job_pipeline.h"
#include "cli/job/setup_notes.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/certify/placement.h"
#include "lib/correct/correct_path.h"
#include "lib/tilt/axes_outside.h"
#include "postproc/cldata/rewriting/list_written.h"
#include "postproc/formats/write_corrected.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// The bytes of each change in the file. Those of one statement are given only once, because a list of positions is
/// long.
class ChangeTexts {
 public:
  ChangeTexts(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after,
              const std::vector<WrittenStatement>& written)
      : texts_(before, changes, after, written), change_of_(before.moves.size(), nullptr) {
    for (const PathChange& change : changes) change_of_[change.move] = &change;
  }

  /// Fills in the bytes of a change. Requires calls in the order of the records.
  void put_into(CorrectedRecord& record, const ChangeRecord& of) {
    if (change_of_[of.move] == nullptr) return;
    if (of.move != move_) next_ = 0;
    move_ = of.move;
    const PathChange& change = *change_of_[of.move];
    std::optional<std::size_t> place = change.inserted_before.size();
    if (of.is_inserted) place = find(change, of.pose);
    if (change.has_arc()) place.reset();
    record.new_record = once(place ? texts_.after(of.move, *place) : texts_.after(of.move), last_new_);
    // An inserted position replaces nothing.
    if (!place || !of.is_inserted) record.old_record = once(texts_.before(of.move), last_old_);
  }

 private:
  std::optional<std::size_t> find(const PathChange& change, const Pose& pose) {
    for (std::size_t k = next_; k < change.inserted_before.size(); ++k) {
      const Pose& there = change.inserted_before[k];
      if (there.tip != pose.tip || there.axis != pose.axis) continue;
      next_ = k + 1;
      return k;
    }
    return std::nullopt;
  }

  static std::optional<std::string_view> once(const std::optional<std::string_view>& text, const char*& last) {
    if (!text || text->data() == last) return std::nullopt;
    last = text->data();
    return text;
  }

  RecordTexts texts_;
  std::vector<const PathChange*> change_of_;
  // the move of the last call, and the first of its positions that was not yet used
  std::size_t move_ = kNone, next_ = 0;
  const char *last_old_ = nullptr, *last_new_ = nullptr;
};

/// The path before a correction, its verdicts, and the names of its obstacles.
struct BeforeCorrection {
  const Toolpath& path;
  const CheckResult& result;
  const SceneFiles& files;
};

/// Returns the gouge of a move as the cause of a change. For a buried move it names no surface.
CauseRecord cause_of(std::size_t move, const BeforeCorrection& before) {
  const MoveVerdict& verdict = before.result.verdicts[move];
  CauseRecord cause;
  cause.move = move;
  cause.line = before.path.moves[move].line;
  cause.state = verdict.state;
  cause.depth_mm = verdict.depth_mm;
  cause.body = verdict.witness ? verdict.witness->body : verdict.reason.body;
  if (!verdict.witness) return cause;
  cause.against = verdict.witness->against;
  if (*cause.against == Against::stock) return cause;
  const SceneFiles& files = before.files;
  cause.mesh = (*cause.against == Against::part ? files.parts : files.fixtures).at(verdict.witness->mesh).name;
  return cause;
}

CorrectedRecord corrected_record(const ChangeRecord& r, const BeforeCorrection& before, ChangeTexts& texts) {
  CorrectedRecord record;
  record.move = r.move;
  record.line = before.path.moves[r.move].line;
  const bool is_between_shifts = r.is_inserted && r.strategy != Strategy::tilt && r.strategy != Strategy::trim;
  record.strategy = is_between_shifts ? "inserted" : strategy_name(r.strategy);
  record.is_inserted = r.is_inserted;
  record.shift_mm = r.shift_mm;
  record.shift_length_mm = r.shift_mm.norm();
  record.tilt_rad = r.tilt_rad;
  record.depth_before_mm = r.depth_before_mm;
  record.depth_after_mm = r.depth_after_mm;
  record.iterations = r.iterations;
  if (r.cause != kNone) record.cause = cause_of(r.cause, before);
  texts.put_into(record, r);
  return record;
}

CorrectionFacts facts_of(const CorrectArguments& arguments, const CorrectOptions& options, const Correction& correction,
                         const BeforeCorrection& before, const Toolpath& after) {
  CorrectionFacts facts;
  facts.output_file = arguments.reported_output();
  facts.strategy = strategies_text(arguments);
  facts.max_shift_mm = options.max_shift_mm;
  facts.max_side_shift_mm = options.max_side_shift_mm;
  facts.rapid_clearance_mm = options.rapid_clearance_mm;
  facts.written = list_written(before.path, correction.changes, after);
  for (const PathChange& change : correction.changes) {
    if (!change.is_straightened && change.inserted_arcs.empty()) continue;
    const auto arcs = std::ranges::count_if(change.inserted_arcs, [](const auto& arc) { return arc.has_value(); });
    const std::size_t straight =
        change.inserted_before.size() + (change.is_straightened ? 1 : 0) - static_cast<std::size_t>(arcs);
    facts.curves += straight > 0 ? 1 : 0;
    facts.straight_moves += straight;
  }
  facts.toolpath_before = &before.path;
  facts.result_before = &before.result;
  ChangeTexts texts(before.path, correction.changes, after, facts.written);
  for (const ChangeRecord& r : correction.records) facts.changes.push_back(corrected_record(r, before, texts));
  facts.uncut = correction.uncut;
  facts.stock = correction.stock;
  facts.low_rapids = correction.low_rapids;
  facts.uncorrected = correction.uncorrected;
  return facts;
}

/// Adds notes of axes outside the cone. Tilts stay inside it, but programmed axes stay as they are.
void add_axes_outside(const Toolpath& path, const std::optional<AxisCone>& cone, Diagnostics& notes) {
  if (!cone) return;
  const AxesOutside outside = find_axes_outside(path, *cone);
  if (outside.positions == 0) return;
  notes.push_back(make_warning(
      "axis-outside-cone",
      count_text(outside.positions, "programmed position") + " " + (outside.positions == 1 ? "has" : "have") +
          " a tool axis outside --axis-cone, up to " + angle_text(outside.max_rad, DegreeSign::word) +
          " from its direction; no correction brings these inside",
      path.file, path.moves[outside.first_move].line));
}

/// Returns how the moves of a run that is not tilted were changed instead.
const char* done_instead(const NotTilted& run, const std::vector<ChangeRecord>& records) {
  bool is_lifted = false, is_shifted = false;
  for (const ChangeRecord& r : records) {
    if (r.move < run.first || r.move > run.last) continue;
    (r.strategy == Strategy::axis ? is_lifted : is_shifted) = true;
  }
  return !is_shifted ? "lifted" : is_lifted ? "shifted with the cutter or lifted" : "shifted with the cutter";
}

/// Adds a note for each run that is not tilted. The first one is a warning, because the correction is not the one
/// requested.
void add_not_tilted(const Toolpath& path, const Correction& correction, Diagnostics& notes) {
  const std::vector<NotTilted>& runs = correction.not_tilted;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::size_t first = path.moves[runs[k].first].line, last = path.moves[runs[k].last].line;
    std::string message = std::string(done_instead(runs[k], correction.records)) +
                          " where that helps, not tilted, down to line " + std::to_string(last) + ": " + runs[k].reason;
    if (k == 0 && runs.size() > 1) message += "; and " + count_text(runs.size() - 1, "more run") + " (-v)";
    notes.push_back((k == 0 ? make_warning : make_note)("not-tilted", message, path.file, first));
  }
}

/// Adds a warning of stock that a lift leaves. Such stock is not a gouge, so no finding reports it.
void add_left_stock(const Toolpath& path, const CorrectionFacts& facts, Diagnostics& notes) {
  if (facts.stock.empty()) return;
  notes.push_back(make_warning("stock-left", stock_text(facts, path.unit), path.file, facts.stock.front().first_line));
}

/// Returns the error if the part lies elsewhere than the path, or is of another size. Then a correction that moves
/// thousands of positions is useless, and a file without changes only seems to be corrected.
std::optional<Diagnostic> find_misfit(const Toolpath& path, const CheckResult& result) {
  const auto refuse = [&](const std::string& why) {
    return make_error("path-misfit", why + "; nothing was written; --force corrects all the same", path.file);
  };
  const std::optional<std::string> misfit = describe_misfit(path, result.fit);
  if (misfit && is_beyond_correction(result.fit)) return refuse(*misfit);
  for (const Assumption& fact : result.assumptions) {
    const bool is_of_place = fact.subject == Subject::mesh_unit || fact.subject == Subject::placement;
    if (is_of_place && fact.basis == Basis::contradicted) return refuse(fact.evidence + "; " + fact.remedy);
  }
  return std::nullopt;
}

/// Returns the content that `correct` adds to its report.
ReportParts parts_of(const CorrectArguments& arguments, const CorrectOptions& options, const RotaryLimit& limit,
                     const LawfulCorrection& corrected, const BeforeCorrection& before, std::string_view text) {
  const Correction& correction = corrected.correction;
  ReportParts parts;
  parts.correction = facts_of(arguments, options, correction, before, corrected.after.path);
  parts.correction->output_bytes = text;
  parts.correction->axes = measure_axes(before.path, correction.changes, corrected.after.path, limit);
  parts.more_options = recorded_options(arguments, correct_options());
  add_axes_outside(before.path, options.tilt.cone, parts.notes);
  add_not_tilted(before.path, correction, parts.notes);
  add_left_stock(before.path, *parts.correction, parts.notes);
  return parts;
}

}  // namespace

std::optional<Diagnostic> find_wrong_value(const CorrectArguments& arguments) {
  if (const Result<JobOptions> options = understand(arguments.job); !options) return options.error();
  if (const Result<CorrectOptions> correct = understand_correction(arguments); !correct) return correct.error();
  if (const Result<RotaryLimit> limit = understand_rotary_limit(arguments.max_rotary_speed); !limit)
    return limit.error();
  return find_wrong_stock(arguments.job);
}

namespace {

/// Returns whether a file is a program of a machine's control. Such a program needs facts to be read, and they would be
/// asked for in vain. A file that cannot be read is none; a pipe and standard input can be read only once.
bool is_program(const std::string& file, const ReadOptions& reading, std::uint64_t max_bytes) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  const Result<FileView> view = view_file(file, max_bytes);
  return view && dialect_of(view->bytes, reading).id == gcode_dialect().id;
}

}  // namespace

int run_correct(const CorrectArguments& arguments, const JobContext& context) {
  Result<JobOptions> options = understand(arguments.job);
  Result<CorrectOptions> correct = understand_correction(arguments);
  if (!options || !correct) return fail(context.err, {!options ? options.error() : correct.error()});
  const Result<RotaryLimit> limit = understand_rotary_limit(arguments.max_rotary_speed);
  if (!limit) return fail(context.err, {limit.error()});
  if (const auto wrong = find_wrong_stock(arguments.job)) return fail(context.err, {*wrong});
  options->reading.keeps_origins = true;
  JobPipeline run(arguments.job, *options, arguments.output, context);
  const Diagnostic refused =
      make_error("write-gcode",
                 "a program of a machine's control is not corrected; correct the CL data it was made from, and run the "
                 "post-processor again",
                 arguments.job.path);
  if (is_program(arguments.job.path, options->reading, arguments.job.input.max_bytes))
    return run.fail_with({refused}, kExitInput);
  if (const auto status = run.load()) return *status;
  if (run.job().toolpath.dialect == gcode_dialect().id) return run.fail_with({refused}, kExitInput);
  if (!arguments.job.stock.empty()) {
    if (const auto status = run.load_stock(correct->rapid_clearance_mm)) return *status;
  }
  const Toolpath& path = run.job().toolpath;
  const CheckResult before = run.check_without_stock();
  if (const auto misfit = find_misfit(path, before); misfit && !arguments.job.is_forced)
    return run.fail_with({*misfit}, kExitGouges);
  const RewritableMoves rewritable = rewritable_moves(path);
  correct->rewritable = &rewritable;
  correct->tilt.reach = run.job().reach();
  std::string text;
  const auto rewrite = [&](const std::vector<PathChange>& changes) -> Result<Toolpath> {
    Result<std::string> written = write_corrected(path, changes);
    if (!written) return written.error();
    text = std::move(*written);
    run.progress().begin("reading the corrected path");
    return read_again(run.job(), arguments.reported_output(), text);
  };
  CheckSetup setup = run.setup();
  setup.stock = run.stock();
  const Result<LawfulCorrection> corrected =
      correct_lawfully(path, before, setup, *correct, rewrite, run.progress().call());
  if (!corrected) return run.fail_with({corrected.error()}, kExitInternal);
  run.progress().begin("summing up the result");
  const CheckResult& known = corrected->before ? *corrected->before : before;
  ReportParts parts = parts_of(arguments, *correct, *limit, *corrected, {path, known, *run.job().files}, text);
  return run.write(run.report(corrected->after.path, corrected->after.result, std::move(parts)));
}

}  // namespace gouge
