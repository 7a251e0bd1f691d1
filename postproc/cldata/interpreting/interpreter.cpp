#include "postproc/cldata/interpreting/interpreter.h"

#include <algorithm>
#include <string>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/known_arguments.h"

namespace gouge {
namespace {

constexpr std::size_t kLongestShownMajor = 24;  // of a word in messages

bool is_within_curve(Word word) { return word == Word::cntrl || word == Word::knot || word == Word::comment; }

// Returns whether a word needs the frame: it states the position of the tool, or nothing follows it.
bool needs_frame(Word word) {
  static constexpr WordSet kWords = {Word::go_to,  Word::from,       Word::godlta,  Word::gohome, Word::indirv,
                                     Word::circle, Word::movarc,     Word::nurbs,   Word::tlon,   Word::unread_motion,
                                     Word::fini,   Word::arc_record, Word::helical, Word::copy};
  return kWords.has(word);
}

bool has_arguments(Word word) {
  static constexpr WordSet kWithout = {Word::harmless, Word::free_text, Word::pprint,    Word::comment,
                                       Word::tprint,   Word::insert,    Word::operation, Word::tool_path};
  return !kWithout.has(word);
}

void fail_too_long(StatementContext& in) {
  in.arguments.clear();
  in.fail("path-count", std::string(in.statement().major.substr(0, kLongestShownMajor)) + " has " +
                            std::to_string(kMaxArguments) +
                            " arguments or more; expected a statement as CAM systems write it: divide it into several");
}

void fail_run_on(StatementContext& in, std::string_view hidden) {
  const Statement& statement = in.statement();
  if (statement.major.empty()) {
    return in.fail("path-statement",
                   quoted_text(hidden) +
                       " stands behind a slash that begins its line (block delete): the control may leave "
                       "it out; expected the statement without the slash, or not at all");
  }
  const std::string major(statement.word == Word::comment ? "$$->" : statement.major.substr(0, kLongestShownMajor));
  in.fail("path-statement",
          quoted_text(hidden) + " stands within " + quoted_text(major) +
              "; expected one statement a line: a line end is missing, or a $ continues a statement that has ended");
}

}  // namespace

// Handles text that is not a statement of CL data.
bool Interpreter::refuse() {
  StatementContext& in = states_.in;
  const Statement& statement = in.statement();
  if (std::max(in.arguments.size(), statement.pieces.size()) >= kMaxArguments) {
    fail_too_long(in);
  } else if (const std::string_view hidden = find_run_on(statement); !hidden.empty()) {
    fail_run_on(in, hidden);
  } else if (statement.hides_comment) {
    fail_run_on(in, "$$");
  } else {
    return false;
  }
  return true;
}

void Interpreter::take(const Statement& statement) {
  States& s = states_;
  s.in.begin(statement);
  if (statement.is_unterminated) return s.in.fail("path-unterminated", std::string(s.in.dialect.cut_statement));
  if (starts_with_ignoring_case(statement.major, "IF(")) return s.in.refuse_part_program(statement.major);
  if (take_control_nurbs(s) || s.program.take_assignment()) return;
  const bool is_comment = statement.word == Word::comment;
  if (!is_comment) s.matrix.pass_statement(needs_frame(statement.word));
  if (s.nurbs.is_open() && !is_within_curve(statement.word)) end_nurbs(s);
  if (has_arguments(statement.word)) split_arguments(statement, s.in.arguments);
  if (refuse()) return;
  apply_modal_states(s, acting_word(statement, s.in.dialect.comments));
  settle_insert(s, statement.word);
  handler_of(statement.word)(s);
  distrust_arguments(s);
  distrust_cut_short(s);
  distrust_last_line(s);
  if (is_comment) return;
  s.previous_word = statement.word;
  s.previous_statement = s.in.index();
}

// Decides the states that the file never ended, then reports the facts that are reported once.
void Interpreter::finish() {
  States& s = states_;
  settle_insert(s, Word::fini);
  s.program.refuse_assignments();
  distrust_last_axis(s);
  // The missing OPSKIP/OFF may have been anywhere.
  if (s.uncertainties.has(Uncertainty::skip)) {
    for (std::size_t i = s.skip_begin; i < s.in.moves(); ++i) s.in.path.moves[i].cover = Cover::none;
  }
  if (s.is_behind_skip) lose_way_behind_skip(s, s.in.moves());
  if (s.nurbs.is_open()) end_nurbs(s);
  if (s.curve.is_open()) drop_described_curve(s);
  if (s.cycle.is_left_open()) mark_cycle_uncertain(s);
  for (const auto& [begin, end] : s.blocks.without_frame(s.in.moves()))
    mark_moves_uncertain(s, begin, end, Reasons::kNoMsys);
  write_notes();
}

void Interpreter::write_notes() {
  States& s = states_;
  s.axes.write_length_note();
  s.cutcom.write_note();
  s.in.report(Severity::note, "path-harmless-words", s.in.declared(), "statement",
              " of words that were declared harmless: taken to move and change nothing");
  s.in.report(Severity::note, "path-machine-text", s.offsets_chosen, "text",
              " for the machine's control that choose a work offset: taken as the one that positions are meant for");
  s.setup.write_note();
  s.chain.write_note();
  s.cycle.write_notes();
  s.senses.close();
  s.senses.write_notes();
  s.axes.write_plain_note();
  s.frame.write_note();
  s.tool.write_note();
  gather_facts();
}

void Interpreter::gather_facts() {
  const States& s = states_;
  facts_.end_line = s.end_line;
  const bool is_ended = s.end_line > 0;
  const bool needs_end = s.in.dialect.has_end_word || s.has_begin;
  if (s.blocks.is_open()) {
    facts_.cut_short = "the last TOOL PATH has no END-OF-PATH, so the file may be cut short";
  } else if (s.blocks.unended_line() > 0) {
    facts_.cut_short = "the TOOL PATH in line " + std::to_string(s.blocks.unended_line()) +
                       " has no END-OF-PATH, so a part of the file may be missing";
  } else if (needs_end && !is_ended) {
    facts_.cut_short = "the file ends without " + std::string(s.in.dialect.end_name) + ", so it may be cut short";
  } else if (s.feed.is_rapid() && !is_ended) {
    facts_.cut_short = "the file ends with a RAPID that no motion follows, so it may be cut short";
  }
  facts_.frame_line = s.frame.line();
  facts_.has_turned_frame = s.frame.has_turned();
  facts_.offset_line = s.offsets_chosen.first_line;
  facts_.smoothing_line = s.smoothing_line;
  facts_.smoothing_mm = s.smoothing_mm;
  facts_.joint_law_line = s.joint_law_line;
}

std::shared_ptr<const MotionRecords> read_motion_records(const Toolpath& path, OpenStatements open) {
  if (auto kept = std::dynamic_pointer_cast<const MotionRecords>(path.origins)) return kept;
  Toolpath again;
  again.file = path.file;
  again.source = path.source;
  again.harmless_words = path.harmless_words;
  again.retract_plane_mm = path.retract_plane_mm;
  auto records = std::make_shared<MotionRecords>();
  records->of_move.reserve(path.moves.size());
  const Dialect dialect = dialect_or_apt(path.dialect);
  Interpreter interpreter(again, dialect, path.unit, records.get());
  const auto source = open(again.source, 0, 1);
  Statement statement;
  while (source->next(statement)) interpreter.take(statement);
  interpreter.finish();
  return records;
}

}  // namespace gouge
