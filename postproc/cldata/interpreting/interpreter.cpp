#include "postproc/cldata/interpreting/interpreter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "postproc/cldata/language/text.h"
#include "postproc/cldata/lexing/statement_reader.h"
#include "postproc/cldata/parsing/run_on.h"

namespace gouge {
namespace {

constexpr std::size_t kErrorsListed = 20;
constexpr std::size_t kUnknownWordsListed = 200;
constexpr double kShareThatTells = 0.02;  // of a file, to expect the same of its rest
constexpr double kFirstGrowth = 4, kLeastGrowth = 1.125, kMargin = 1.01;
constexpr std::size_t kLongestMajor = 24;    // of a word that is told
constexpr const char* kOtherWords = "(other words)";

std::string cut_short_text(FileForm form) {
  if (form == FileForm::nccs_records)
    return "the file ends within this record, or the record has no length: it is cut short or damaged";
  if (form == FileForm::nci_lines)
    return "the file ends after a code; expected the line of its parameters: the file is cut short";
  return "the file ends within a statement that a $ continues; expected its next line: the file is cut short";
}

bool is_within_curve(Word word) {
  return word == Word::cntrl || word == Word::knot || word == Word::comment;
}

// Of words that say where the tool is, or that nothing follows.
bool needs_frame(Word word) {
  switch (word) {
    case Word::go_to:
    case Word::from:
    case Word::godlta:
    case Word::gohome:
    case Word::indirv:
    case Word::circle:
    case Word::movarc:
    case Word::nurbs:
    case Word::tlon:
    case Word::unread_motion:
    case Word::fini:
      return true;
    default:
      return false;
  }
}

bool has_arguments(Word word) {
  switch (word) {
    case Word::harmless:
    case Word::free_text:
    case Word::pprint:
    case Word::comment:
    case Word::tprint:
    case Word::insert:
    case Word::operation:
    case Word::tool_path:
      return false;
    default:
      return true;
  }
}

}  // namespace

Interpreter::Interpreter(Toolpath& path, const Dialect& dialect, LengthUnit unit,
                         MotionRecords* records)
    : path_(path), dialect_(dialect), records_(records), mm_per_unit_(mm_per(unit)) {}

std::size_t Interpreter::expected_count(std::size_t until_here) const {
  const double share = static_cast<double>(statement_->last_byte) / static_cast<double>(path_.source.size());
  const double growth = share < kShareThatTells ? kFirstGrowth : std::max(kMargin / share, kLeastGrowth);
  return static_cast<std::size_t>(std::ceil(static_cast<double>(until_here) * growth));
}

void Interpreter::fail(std::string code, std::string message) {
  if (errors_.size() >= kErrorsListed) {
    ++errors_not_listed_;
    return;
  }
  errors_.push_back(make_error(std::move(code), std::move(message), path_.file, statement_->line));
}

void Interpreter::fail_too_long() {
  arguments_.clear();
  fail("path-count", std::string(statement_->major.substr(0, kLongestMajor)) + " has " +
                         std::to_string(kMostArguments) + " arguments or more; expected a statement as CAM systems "
                         "write it: divide it into several");
}

void Interpreter::fail_run_on(std::string_view hidden) {
  const std::string major(statement_->word == Word::comment ? "$$->" : statement_->major.substr(0, kLongestMajor));
  fail("path-statement", quoted_text(hidden) + " stands within " + quoted_text(major) +
                             "; expected one statement a line: a line end is missing, or a $ continues a statement "
                             "that has ended");
}

Diagnostics Interpreter::take_errors() {
  if (errors_not_listed_ > 0) {
    errors_.push_back(make_error("path-more-errors",
                                 "and " + std::to_string(errors_not_listed_) + " more errors", path_.file));
  }
  return std::exchange(errors_, {});
}

void Interpreter::count_unknown() {
  std::string word = word_as_told(statement_->major);
  auto& words = path_.words_not_understood;
  if (words.size() >= kUnknownWordsListed && !words.contains(word)) word = kOtherWords;
  ++words[word];
}

const char* Interpreter::because(const char* reason) {
  return reasons_.name(reason, statement_->major, statement_->line);
}

void Interpreter::take(const Statement& statement) {
  statement_ = &statement;
  make_room(path_.statements);
  path_.statements.push_back({statement.line, statement.first_byte, statement.last_byte});
  if (statement.is_unterminated) return fail("path-unterminated", cut_short_text(dialect_.form));
  if (starts_with_ignoring_case(statement.major, "IF(")) return refuse_part_program(statement.major);
  if (take_assignment()) return;
  if (catia_row_ >= 0 && needs_frame(statement.word)) fail_catia_rows();
  if (statement.word != Word::comment) is_catia_nameless_ = is_catia_nameless_ && catia_row_ >= 0;
  if (curve_statement_ != kNone && !is_within_curve(statement.word)) flush_curve();
  if (has_arguments(statement.word)) split_arguments(statement, arguments_);
  if (std::max(arguments_.size(), statement.pieces.size()) >= kMostArguments) return fail_too_long();
  if (const std::string_view hidden = find_run_on(statement); !hidden.empty()) return fail_run_on(hidden);
  if (statement.hides_comment) return fail_run_on("$$");
  apply_modal_states(acting_word(statement, dialect_.comments));
  if (!take_motion_word() && !take_tool_word() && !take_frame_word() && !take_text_word() &&
      !take_unread_word()) {
    take_unknown();
  }
  distrust_cut_short();
  if (statement.word == Word::comment) return;
  previous_word_ = statement.word;
  previous_statement_ = path_.statements.size() - 1;
}

bool Interpreter::take_motion_word() {
  switch (statement_->word) {
    case Word::go_to:
      take_positions(PositionForm::go_to);
      return true;
    case Word::from:
      take_positions(PositionForm::from);
      return true;
    case Word::rapid:
      take_rapid();
      return true;
    case Word::fedrat:
      take_fedrat();
      return true;
    case Word::circle:
    case Word::movarc:
      take_arc();
      return true;
    case Word::curve:
      take_unread_curve();
      return true;
    case Word::indirv:
      take_indirv();
      return true;
    case Word::cntrl:
      take_control_point();
      return true;
    case Word::nurbs:
      begin_curve();
      return true;
    case Word::knot:
      take_knots();
      return true;
    case Word::godlta:
      take_godlta();
      return true;
    case Word::gohome:
      take_gohome();
      return true;
    case Word::tlon:
      if (!has_argument(arguments_, "GOFWD")) return false;
      take_tlon();
      return true;
    case Word::cycle:
      take_cycle();
      return true;
    case Word::multax:
      take_multax();
      return true;
    case Word::retrct:
      unknown_start_ = Reasons::kAfterRetract;
      return true;
    case Word::cutcom:
      take_cutcom();
      return true;
    default:
      return false;
  }
}

bool Interpreter::take_tool_word() {
  switch (statement_->word) {
    case Word::cutter:
      take_cutter();
      return true;
    case Word::tldata:
      take_tldata();
      return true;
    case Word::loadtl:
    case Word::toolno:
      take_tool_number();
      return true;
    case Word::load:
      take_load();
      return true;
    case Word::flute_length:
      take_flute_length();
      return true;
    case Word::turret:
      turning_reason_ = because(Reasons::kTurning);
      return true;
    case Word::tprint:
      take_tool_name(statement_->pieces.front());
      return true;
    case Word::insert:
      take_insert();
      return true;
    case Word::prefun:
      take_codes('G');
      return true;
    case Word::auxfun:
      take_codes('M');
      return true;
    default:
      return false;
  }
}

bool Interpreter::take_frame_word() {
  switch (statement_->word) {
    case Word::csys:
      if (!dialect_.is_in_world) take_csys();
      return true;
    case Word::camera:
      take_camera();
      return true;
    case Word::mcs:
      take_mcs();
      return true;
    case Word::mcsys:
      take_mcsys();
      return true;
    case Word::msys:
      take_msys();
      return true;
    case Word::rotabl:
      take_rotabl();
      return true;
    case Word::trntyp:
      take_trntyp();
      return true;
    case Word::trans:
      take_trans();
      return true;
    case Word::mode:
      take_mode();
      return true;
    case Word::setup:
      take_setup();
      return true;
    case Word::select:
      take_select();
      return true;
    case Word::tlaxis:
      take_tlaxis();
      return true;
    case Word::syn:
      take_syn();
      return true;
    case Word::units:
      take_units();
      return true;
    case Word::tool_path:
      take_tool_path();
      return true;
    case Word::end_of_path:
      if (block_ == 0) doubt_moves(0, path_.moves.size(), Reasons::kNoToolPath);
      is_block_open_ = false;
      is_between_blocks_ = true;
      block_reason_ = Reasons::kBetweenBlocks;
      break_motion();
      return true;
    case Word::fini:
      has_end_ = true;
      last_hole_.reset();
      if (last_pose_) unknown_start_ = Reasons::kAfterEnd;  // another program's tool or name breaks the motion
      return true;
    default:
      return false;
  }
}

// Words that are text, move nothing or are refused; false for unknown ones.
bool Interpreter::take_text_word() {
  switch (statement_->word) {
    case Word::comment:
      take_comment();
      return true;
    case Word::harmless:
      take_harmless();
      return true;
    case Word::free_text:
      if (has_end_ && starts_with_ignoring_case(statement_->major, "PARTNO")) {  // another program
        break_motion();
        can_link_ = false;
      }
      if (equals_ignoring_case(statement_->major, "OPFEATEND")) end_clt_feature();
      // Creo 9 writes REMARK -> where older files have the comment $$->.
      if (dialect_.comments == CommentForm::creo && starts_with_ignoring_case(statement_->major, "REMARK") &&
          trim(statement_->pieces.front()).starts_with("->"))
        take_creo_comment();
      return true;
    case Word::ppword:
      take_ppword();
      return true;
    case Word::pprint:
      if (dialect_.pprint_includes_files && starts_with_ignoring_case(trim(statement_->pieces.front()), "INCLUD")) {
        emit_unread();  // the motion of another file stands here
        count_unknown();
        return true;
      }
      if (!dialect_.names_operations) name_operation(name_text(statement_->pieces.front()));
      return true;
    case Word::operation:
      if (dialect_.operations_are_blocks) begin_block();
      name_operation(name_text(statement_->pieces.front()));
      return true;
    case Word::part_program:
      if (!is_statement()) return false;
      refuse_part_program(statement_->major);
      return true;
    default:
      return false;
  }
}

// Words known to matter, in a way that is not read.
bool Interpreter::take_unread_word() {
  switch (statement_->word) {
    case Word::unread_motion:
    case Word::tlon:
      emit_unread();
      break;
    case Word::repeat:
      emit_unread();
      unread_frame_reason_ = because(Reasons::kUnreadFrame);
      break;
    case Word::unread_frame:
      unread_frame_reason_ = because(Reasons::kUnreadFrame);
      break;
    case Word::unread_tool:
      tool_.cutter.reset();
      is_tool_changed_ = true;
      break;
    default:
      return false;
  }
  count_unknown();
  return true;
}

// A word of the source language makes a statement alone or before a slash or comma; else it only begins a
// sentence.
bool Interpreter::is_statement() const {
  const std::string_view all = path_.source;
  const auto after =
      static_cast<std::size_t>(statement_->major.data() - all.data()) + statement_->major.size();
  const std::string_view rest = trim(all.substr(after, all.find('\n', after) - after));
  return rest.empty() || rest.front() == '/' || rest.front() == '(' || rest.front() == ',' || rest.front() == '$';
}

void Interpreter::finish() {
  refuse_assignments();
  if (curve_statement_ != kNone) flush_curve();
  if (arc_ || has_indirv_) drop_described_curve();
  if (cycle_.is_on && cycle_.certain_moves < path_.moves.size()) doubt_cycle();
  doubt_blocks_without_msys();
  write_notes();
}

MotionRecords read_motion_records(const Toolpath& path) {
  Toolpath again;
  again.file = path.file;
  again.source = path.source;
  MotionRecords records;
  records.of_move.reserve(path.moves.size());
  const Dialect dialect = dialect_called(path.dialect).value_or(Dialect{});
  Interpreter interpreter(again, dialect, path.unit, &records);
  StatementReader reader(again.source, dialect.form);
  Statement statement;
  while (reader.next(statement)) interpreter.take(statement);
  interpreter.finish();
  return records;
}

}  // namespace gouge
