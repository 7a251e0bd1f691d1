#include "postproc/report/write_report.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/cure_text.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

constexpr double kNoteworthy = 1.02;

// Names and reasons in a line are from outside: none may end it, begin another one or move the cursor.
std::string line(const std::string& text) { return printable(text) + "\n"; }

std::string line_prefix(const ReportModel& model, std::size_t move) {
  return model.toolpath->file + ":" + std::to_string(model.toolpath->moves[move].line) + ": ";
}

std::string bodies(const ReportModel& model) {
  std::string text;
  for (const std::vector<MeshFacts>* meshes : {&model.parts, &model.fixtures}) {
    for (const MeshFacts& mesh : *meshes) text += (text.empty() ? " against " : ", ") + mesh.name;
  }
  return text;
}

std::string headline(const ReportModel& model) {
  const CheckResult& result = *model.result;
  const StateCounts& n = result.counts;
  const std::string of_moves = " of " + count_text(result.verdicts.size(), "move");
  switch (overall_verdict(result)) {
    case OverallVerdict::clean:
      return "clean: no gouge in " + count_text(result.verdicts.size(), "move");
    case OverallVerdict::not_fully_checked:
      return "not fully checked: no gouge found, but " + std::to_string(n.not_checked - n.skipped + n.not_certified) +
             of_moves + " could not be checked or certified";
    case OverallVerdict::gouges:
      break;
  }
  if (n.gouge == 0) return "gouges: the tool is buried in " + std::to_string(n.buried) + of_moves;
  const auto gouges =
      std::ranges::count_if(result.events, [](const Event& event) { return event.state == MoveState::gouge; });
  std::string text = "gouges: " + count_text(static_cast<std::size_t>(gouges), "finding") + " in " +
                     std::to_string(n.gouge) + of_moves;
  if (result.worst_move < result.verdicts.size()) {
    text += ", the deepest " + depth_text(result.worst_depth_mm, model.toolpath->unit) + " at line " +
            std::to_string(model.toolpath->moves[result.worst_move].line);
  }
  // On shallow gouges both measures agree; where the tool is deeper in than it is thick, only overcut shows it.
  if (result.worst_overcut_mm > kNoteworthy * result.worst_depth_mm) text += ", overcut " + overcut_range_text(model);
  if (n.buried > 0) text += "; the tool is buried in " + count_text(n.buried, "move");
  return text;
}

std::string counts_line(const StateCounts& n) {
  std::string text = std::to_string(n.clean) + " clean";
  const auto add = [&](std::size_t count, const char* word) {
    if (count > 0) text += ", " + std::to_string(count) + " " + word;
  };
  add(n.near_miss, "near");
  add(n.gouge, "gouge");
  add(n.buried, "buried");
  add(n.not_certified, "not certified");
  add(n.not_checked, "not checked");
  if (n.skipped > 0) text += " (" + count_text(n.skipped, "rapid") + " left out as asked)";
  return text;
}

std::string written_line(const CorrectionFacts& correction) {
  if (correction.written.empty()) return {};
  std::string text = "records:";
  for (const char* kind : {"changed", "added", "removed"}) {
    const auto count =
        std::ranges::count_if(correction.written, [&](const WrittenRecord& record) { return record.kind == kind; });
    text += (text.back() == ':' ? " " : ", ") + std::to_string(count) + " " + kind;
  }
  return text + "; every other one is the same to the byte\n";
}

std::string correction_lines(const ReportModel& model) {
  const CorrectionFacts& correction = model.correction;
  const LengthUnit unit = model.toolpath->unit;
  const std::size_t inserted = inserted_positions(correction);
  double largest_mm = 0;
  for (const CorrectedRecord& change : correction.changes) {
    if (!change.is_inserted && !change.is_uncut) largest_mm = std::max(largest_mm, change.shift_length_mm);
  }
  const std::size_t moved = moved_positions(correction);
  std::string text = "corrected: " + count_text(moved, "position") + " moved";
  if (moved > 0) text += " by up to " + depth_text(largest_mm, unit);
  text += ", " + std::to_string(inserted) + " inserted";
  if (correction.curves > 0) text += ", " + straightened_text(correction);
  if (!correction.uncut.empty()) text += ", " + uncut_text(correction, unit);
  const auto changed = static_cast<std::size_t>(
      std::ranges::count_if(correction.uncorrected, [](const UncorrectedRecord& left) { return left.is_changed; }));
  const std::size_t left = correction.uncorrected.size() - changed;
  text += ", " + std::to_string(left) + (left == 1 ? " left as it was" : " left as they were");
  if (changed > 0) text += ", " + std::to_string(changed) + " changed but not freed";
  if (!correction.output_file.empty()) text += "; written to " + correction.output_file;
  const std::string stock = stock_text(correction, unit);
  return line(text) + (stock.empty() ? stock : line("stock: " + stock)) + written_line(correction) +
         (correction.axes ? axis_lines(model) : std::string());
}

}  // namespace

std::string summary_text(const ReportModel& model) {
  std::string text = line(model.toolpath->file + bodies(model));
  text += line(headline(model));
  for (const std::string& reservation : reservations(model)) text += line("note: " + reservation);
  text += line("moves: " + counts_line(model.result->counts));
  const std::string overcut = overcut_gaps_text(model);
  if (!overcut.empty()) text += line("overcut: " + overcut);
  if (model.closeness) text += line("closest approach to the part: " + closeness_text(model));
  text += stickout_lines(model);
  if (model.has_correction) text += correction_lines(model);
  return text + line("guarantee: " + guarantee_text(model));
}

std::string findings_text(const ReportModel& model) {
  std::string text;
  for (std::size_t k = 0; k < model.result->events.size(); ++k) {
    const Event& event = model.result->events[k];
    if (event.state != MoveState::gouge && event.state != MoveState::buried && event.state != MoveState::near_miss) {
      continue;
    }
    text += line(line_prefix(model, event.worst_move) + event_text(model, event) + span_text(event));
    if (const FindingCures* cures = cures_of(model, k)) text += line("  cured by " + cure_text(model, *cures));
  }
  for (const ReasonGroup& group : group_reasons(*model.result)) {
    text += line(line_prefix(model, group.first_move) + group_text(group));
  }
  if (model.has_correction) {
    for (const UncorrectedRecord& left : model.correction.uncorrected) {
      const Toolpath& before = model.correction.toolpath_before ? *model.correction.toolpath_before : *model.toolpath;
      text += line(before.file + ":" + std::to_string(left.line) +
                   (left.is_changed ? ": not freed: " : ": not corrected: ") +
                   (left.depth_mm > 0 ? depth_text(left.depth_mm, model.toolpath->unit) + ", " : std::string()) +
                   "move " + std::to_string(left.move) + ": " + left.reason);
    }
  }
  return text + summary_text(model);
}

}  // namespace gouge
