#include "postproc/report/write_report.h"

#include <algorithm>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/paint.h"
#include "lib/base/printable_text.h"
#include "postproc/report/axis_text.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/excess_text.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_text.h"
#include "postproc/report/stickout_text.h"
#include "postproc/report/tightness.h"

namespace gouge {
namespace {

constexpr double kNoteworthy = 1.02;

// Returns the text as one line. Its names and reasons come from files, so they must not contain line ends or control
// the cursor.
std::string line(const std::string& text) { return printable(text) + "\n"; }

// Returns the text as lines of the summary; those behind the first are indented. columns 0: one line.
constexpr std::size_t kIndent = 2;  // of the further lines of a text that is wrapped

std::string summary_line(const std::string& text, std::size_t columns) {
  return columns == 0 ? line(text) : wrapped(printable(text), columns, kIndent) + "\n";
}

std::string bodies(const ReportModel& model) {
  std::string text;
  for (const std::vector<MeshFacts>* meshes : {&model.parts, &model.fixtures}) {
    for (const MeshFacts& mesh : *meshes) text += (text.empty() ? " against " : ", ") + mesh.name;
  }
  return text;
}

/// A result and its path.
struct Checked {
  const Toolpath& path;
  const CheckResult& result;
};

// Returns the words about the deepest of all gouges, accepted or not.
std::string deepest_words(const Checked& checked, const CheckOptions& limits) {
  const CheckResult& result = checked.result;
  if (result.worst_move >= result.verdicts.size()) return {};
  return ", the deepest " + depth_text(result.worst_depth_mm, checked.path.unit, limits) + " at line " +
         std::to_string(checked.path.moves[result.worst_move].line);
}

std::string overcut_words(const ReportModel& model) {
  // For shallow gouges depth and overcut agree. If the tool is deeper in the part than it is thick, only the overcut
  // shows it.
  const CheckResult& result = *model.result;
  const bool is_noteworthy = result.worst_overcut_mm > kNoteworthy * result.worst_depth_mm;
  return is_noteworthy ? ", overcut " + overcut_range_text(model) : std::string();
}

// Returns the moves and facts that prevent a clean verdict without gouges. `model` is null for a path before its
// correction.
std::string open_words(const CheckResult& result, const ReportModel* model) {
  const StateCounts& n = result.counts;
  const std::size_t moves = n.not_checked - n.skipped + n.not_certified;
  const auto open = static_cast<std::size_t>(std::ranges::count_if(result.assumptions, &Assumption::is_open));
  const std::size_t facts = model != nullptr ? open_facts(*model).size() : open;
  std::string text;
  if (moves > 0)
    text = std::to_string(moves) + " of " + count_text(result.verdicts.size(), "move") +
           " could not be checked or certified";
  if (facts > 0)
    text += (text.empty() ? "" : ", and ") + count_text(facts, "fact") + " that the verdict rests on " +
            (facts == 1 ? "is" : "are") + " not established";
  if (result.excess && result.excess->proved() < result.excess->places.size())
    text += (text.empty() ? "" : ", and ") + std::string("whether material is left is open in ") +
            count_text(result.excess->places.size() - result.excess->proved(), "place");
  return text;
}

// Returns the words about the moves that have no gouge, after "no" or "no other".
std::string without_gouge(const CheckResult& result) {
  const std::size_t rapids = result.counts.skipped, checked = result.verdicts.size() - rapids;
  if (rapids == 0) return " gouge in " + count_text(checked, "move");
  return " gouge in the " + count_text(checked, "move") + " checked; " + left_out_text(rapids);
}

// Returns the number of places where a correction cuts less than was programmed.
std::string places_left_uncut(const CorrectionFacts& correction) {
  const UncutTotal total = uncut_total(correction);
  std::string text;
  if (total.stretches > 0) text = count_text(total.stretches, "stretch", "stretches");
  if (total.holes > 0) text += (text.empty() ? "" : " and ") + count_text(total.holes, "hole");
  return text.empty() ? text : "; " + text + " left uncut";
}

// Returns the first line. `accepting` is the model whose baseline applies; null: none.
std::string headline(const Checked& checked, const CheckOptions& limits, const std::string& overcut,
                     const ReportModel* accepting) {
  const CheckResult& result = checked.result;
  const StateCounts& n = result.counts;
  const std::string of_moves = " of " + count_text(result.verdicts.size(), "move");
  switch (accepting != nullptr ? overall_verdict(*accepting) : overall_verdict(result)) {
    case OverallVerdict::accepted_gouges:
      return accepted_words(*accepting) + ": no other" + without_gouge(result) + deepest_words(checked, limits);
    case OverallVerdict::clean:
      return "clean: no" + without_gouge(result);
    case OverallVerdict::not_fully_checked:
      return std::string("not fully checked: no ") + (n.gouge > 0 ? "other " : "") + "gouge found, but " +
             open_words(result, accepting) + (n.gouge > 0 ? "; " + accepted_words(*accepting) : "");
    case OverallVerdict::material_left:
      return excess_headline(result, checked.path.unit);
    case OverallVerdict::gouges:
      break;
  }
  const std::size_t accepted = accepting != nullptr ? accepting->baseline.accepted_findings() : 0;
  if (n.gouge == 0) return "gouges: the tool is buried in " + std::to_string(n.buried) + of_moves;
  const auto gouges =
      std::ranges::count_if(result.events, [](const Event& event) { return event.state == MoveState::gouge; });
  std::string text = "gouges: " + count_text(static_cast<std::size_t>(gouges), "finding") + " in " +
                     std::to_string(n.gouge) + of_moves + deepest_words(checked, limits) + overcut;
  if (accepted > 0) text += "; " + std::to_string(accepted) + " of these findings accepted";
  if (n.buried > 0) text += "; the tool is buried in " + count_text(n.buried, "move");
  return text;
}

// Returns the line of the verdict. The word before the colon is the verdict, which a terminal shows in colour.
std::string verdict_line(const std::string& text, OverallVerdict verdict, bool is_coloured, std::size_t columns) {
  const Paint paint = verdict == OverallVerdict::clean      ? Paint::clean
                      : exit_status(verdict) == kExitGouges ? Paint::error
                                                            : Paint::warning;
  const std::string shown = summary_line(text, columns);
  const std::size_t end = shown.find(':') + 1;
  return painted(shown.substr(0, end), paint, is_coloured) + shown.substr(end);
}

std::string verdict_lines(const ReportModel& model, bool is_coloured, std::size_t columns) {
  const auto [now, before] = headlines(model);
  constexpr std::string_view kBefore = "before ", kAfter = "after  ";
  const std::size_t room = before.empty() || columns < kBefore.size() ? columns : columns - kBefore.size();
  const std::string line = verdict_line(now, overall_verdict(model), is_coloured, room);
  if (before.empty()) return line;
  return std::string(kBefore) +
         verdict_line(before, overall_verdict(*model.correction.result_before), is_coloured, room) +
         std::string(kAfter) + line;
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
  if (n.skipped > 0) text += " (" + left_out_text(n.skipped) + ")";
  return text;
}

std::string written_line(const CorrectionFacts& correction) {
  if (correction.written.empty()) return {};
  std::string text = "records:";
  for (const WrittenKind kind : {WrittenKind::changed, WrittenKind::added, WrittenKind::removed}) {
    const auto count = std::ranges::count(correction.written, kind, &WrittenStatement::kind);
    text += (text.back() == ':' ? " " : ", ") + std::to_string(count) + " " + written_name(kind);
  }
  return text + "; every other one is the same to the byte\n";
}

std::string correction_lines(const ReportModel& model) {
  const CorrectionFacts& correction = model.correction;
  const LengthUnit unit = model.toolpath->unit;
  const std::size_t inserted = inserted_positions(correction);
  double largest_mm = 0;
  for (const CorrectedRecord& change : correction.changes) {
    if (!change.is_inserted && !change.is_uncut()) largest_mm = std::max(largest_mm, change.shift_length_mm);
  }
  const std::size_t moved = moved_positions(correction);
  std::string text = "corrected: " + count_text(moved, "position") + " moved";
  if (moved > 0) text += " by up to " + depth_text(largest_mm, unit);
  text += ", " + std::to_string(inserted) + " inserted";
  if (correction.curves > 0) text += ", " + straightened_text(correction);
  if (!correction.uncut.empty()) text += ", " + uncut_text(correction, unit);
  const auto changed = static_cast<std::size_t>(
      std::ranges::count_if(correction.uncorrected, [](const Uncorrected& left) { return left.is_changed; }));
  const std::size_t left = correction.uncorrected.size() - changed;
  text += ", " + std::to_string(left) + (left == 1 ? " left as it was" : " left as they were");
  if (changed > 0) text += ", " + std::to_string(changed) + " changed but not freed";
  if (!correction.output_file.empty()) text += "; written to " + correction.output_file;
  return line(text) + written_line(correction) + (correction.axes ? axis_lines(model) : std::string());
}

/// A writer of the lines before the summary.
class FindingsWriter {
 public:
  FindingsWriter(const ReportModel& model, const FindingsView& view) : model_(model), view_(view) {}

  std::string write() {
    const ListedFindings listed = list_events(model_, view_);
    for (const std::size_t k : listed.events) add(k);
    add_rest(listed);
    add_reasons();
    add_excess();
    if (model_.has_correction) add_uncorrected();
    return std::move(text_);
  }

 private:
  void add_reasons() {
    const std::vector<ReasonGroup> groups = group_reasons(*model_.result);
    const std::size_t most = std::min(groups.size(), view_.most);
    for (std::size_t k = 0; k < most; ++k) {
      add(*model_.toolpath, model_.toolpath->moves[groups[k].first_move].line, group_text(groups[k]), Paint::warning);
      add_statement(groups[k].first_move);
    }
    if (const std::size_t more = groups.size() - most; more > 0)
      text_ += summary_line("and " + grouped_text(more) + " more " + (more == 1 ? "reason" : "reasons") +
                                " why moves are open (--max-findings all lists them)",
                            view_.columns);
  }

  // Adds a line; the word before the first colon of `what` is its kind.
  void add(const Toolpath& path, std::size_t at, const std::string& what, Paint paint) {
    const std::string shown = printable(what);
    const std::size_t end = shown.find(':') + 1;
    const std::string whole =
        painted(printable(path.file) + ":" + std::to_string(at) + ":", Paint::place, view_.is_coloured) + " " +
        painted(shown.substr(0, end), paint, view_.is_coloured) + shown.substr(end);
    text_ += (view_.columns == 0 ? whole : wrapped(whole, view_.columns, kIndent)) + "\n";
  }

  void add(std::size_t index) {
    const Event& event = model_.result->events[index];
    const Toolpath& path = *model_.toolpath;
    const Move& move = path.moves[event.worst_move];
    add(path, move.line,
        (model_.baseline.is_accepted(index) ? "accepted " : "") + event_text(model_, event) + span_text(event) +
            setting_text(model_, event),
        event.state == MoveState::near_miss || model_.baseline.is_accepted(index) ? Paint::warning : Paint::error);
    add_statement(event.worst_move);
    const std::string pose = view_.has_statements ? pose_text(model_, event) : "";
    if (!pose.empty()) text_ += painted(line("         " + pose), Paint::faint, view_.is_coloured);
    for (const std::string& remark : acceptance_remarks(model_, index)) text_ += line("  " + remark);
    if (const FindingCures* cures = cures_of(model_, index)) text_ += line("  cured by " + cure_text(model_, *cures));
  }

  // Adds the statement in the format of compilers: the number of the line, a bar, the line.
  void add_statement(std::size_t move) {
    if (!view_.has_statements) return;
    constexpr std::size_t kDigits = 6;
    std::size_t number = model_.toolpath->moves[move].line;
    for (const std::string& quoted : statement_lines(*model_.toolpath, move)) {
      const std::string digits = std::to_string(number++);
      const std::string before = std::string(kDigits - std::min(kDigits, digits.size()), ' ') + digits + " | ";
      text_ += painted(before + printable(quoted), Paint::faint, view_.is_coloured) + "\n";
    }
  }

  void add_rest(const ListedFindings& listed) {
    const LengthUnit unit = model_.toolpath->unit;
    if (listed.more > 0) {
      const std::string deepest = listed.deepest_more_mm > 0
                                      ? ", the deepest " + depth_text(listed.deepest_more_mm, unit, model_.options)
                                      : std::string();
      text_ += summary_line("and " + grouped_text(listed.more) + " more" + deepest + " (--max-findings all lists them)",
                            view_.columns);
    }
    if (listed.shallower > 0)
      text_ += grouped_text(listed.shallower) + " not listed, less deep than --min-depth " +
               length_text(view_.min_depth_mm, unit) + "\n";
  }

  // Lists places with material; they have no line of the toolpath, so the name of the part comes first.
  void add_excess() {
    if (!model_.result->excess) return;
    const std::vector<ExcessPlaceFacts>& places = model_.result->excess->places;
    for (std::size_t k = 0; k < std::min(places.size(), view_.most); ++k) {
      const std::string kind = excess_kind(places[k]) + ":";
      text_ += painted(printable(model_.parts[places[k].part].name) + ":", Paint::place, view_.is_coloured) + " " +
               painted(kind, places[k].is_proved() ? Paint::error : Paint::warning, view_.is_coloured) + " " +
               printable(excess_place_text(model_, places[k])) + "\n";
    }
    if (places.size() > view_.most)
      text_ += "and " + grouped_text(places.size() - view_.most) + " more places (--max-findings all lists them)\n";
  }

  void add_uncorrected() {
    const CorrectionFacts& correction = model_.correction;
    const Toolpath& before = correction.toolpath_before ? *correction.toolpath_before : *model_.toolpath;
    std::size_t count = 0;
    for (const Uncorrected& left : correction.uncorrected) {
      if (++count > view_.most) continue;
      add(before, left.line,
          (left.is_changed ? "not freed: " : "not corrected: ") +
              (left.depth_mm > 0 ? depth_text(left.depth_mm, model_.toolpath->unit, model_.options) + ", "
                                 : std::string()) +
              "move " + std::to_string(left.move) + ": " + left.reason,
          Paint::error);
    }
    if (count > view_.most)
      text_ += "and " + grouped_text(count - view_.most) + " more not corrected (--max-findings all lists them)\n";
  }

  const ReportModel& model_;
  const FindingsView& view_;
  std::string text_;
};

}  // namespace

Headlines headlines(const ReportModel& model) {
  Headlines lines;
  const CorrectionFacts& correction = model.correction;
  lines.now = headline({*model.toolpath, *model.result}, model.options, overcut_words(model), &model) +
              places_left_uncut(correction);
  if (model.has_correction && correction.result_before != nullptr && correction.toolpath_before != nullptr)
    lines.before = headline({*correction.toolpath_before, *correction.result_before}, model.options, {}, nullptr);
  return lines;
}

std::string summary_text(const ReportModel& model, bool is_coloured, std::size_t columns) {
  constexpr std::size_t kColumnsOfFacts = 100;
  const auto put = [&](const std::string& one) { return summary_line(one, columns); };
  std::string text = put(model.toolpath->file + bodies(model));
  text += verdict_lines(model, is_coloured, columns);
  for (const std::string& fact : open_facts(model)) text += put("not established: " + fact);
  for (const std::string& reservation : reservations(model)) text += put("note: " + reservation);
  text += put("moves: " + counts_line(model.result->counts));
  const std::string overcut = overcut_gaps_text(model);
  if (!overcut.empty()) text += put("overcut: " + overcut);
  text += baseline_lines(model);
  if (model.result->closest_approach) text += put("closest approach to the part: " + closest_approach_text(model));
  if (const std::string any = any_turn_text(model); !any.empty()) text += put("rotary joints: " + any);
  if (const std::string stock = stock_text(model); !stock.empty()) text += put("stock: " + stock);
  if (const std::string left = stock_left_text(model); !left.empty()) text += put("stock left: " + left);
  if (const std::string excess = excess_text(model); !excess.empty()) text += put("excess: " + excess);
  for (const LawRecord& law : model.laws) text += put(law_label(law) + ": " + law_text(model, law));
  text += stickout_lines(model);
  if (model.has_correction) text += correction_lines(model);
  const Guarantee guarantee = guarantee_of(model);
  text += put("guarantee: " + guarantee.text);
  return text + (guarantee.facts.empty()
                     ? ""
                     : summary_line("rests on: " + guarantee.facts, columns == 0 ? kColumnsOfFacts : columns));
}

std::string findings_text(const ReportModel& model, const FindingsView& view) {
  return FindingsWriter(model, view).write() + summary_text(model, view.is_coloured, view.columns);
}

}  // namespace gouge
