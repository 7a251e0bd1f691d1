#include "postproc/cldata/interpreting/misreading.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "lib/base/number_text.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/further_readings.h"
#include "postproc/cldata/language/text.h"

namespace gouge {

namespace {

bool is_sign(char c) { return c == '+' || c == '-' || c == '.'; }

bool begins_with_number(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '(' || text.front() == ',')) text.remove_prefix(1);
  return !text.empty() &&
         (is_digit(text.front()) || (text.size() > 1 && is_sign(text[0]) && (is_digit(text[1]) || is_sign(text[1]))));
}

// Returns the text after a `/` that marks a block skip, a sequence number or a label: "N10 X5", "20 FOO/1", "LAB1)
// -50."
std::string_view without_label(std::string_view text) {
  while (!text.empty() && (is_blank(text.front()) || text.front() == '/')) text.remove_prefix(1);
  std::size_t at = !text.empty() && (text[0] == 'N' || text[0] == 'n') ? 1 : 0;
  while (at < text.size() && is_digit(text[at])) ++at;
  if (at > 1 && at == text.size() && !is_digit(text[0])) return {};
  if (at < text.size() && at > 0 && is_digit(text[at - 1]) && (is_blank(text[at]) || is_letter(text[at])))
    return trim(text.substr(at));
  std::size_t word = 0;
  while (word < text.size() && is_word_character(text[word])) ++word;
  const std::string_view rest = trim(text.substr(word));
  return word > 0 && rest.size() > 1 && rest.front() == ')' ? trim(rest.substr(1)) : text;
}

// Returns the known word that the beginning of `text` was probably meant to be.
Word intended_word(std::string_view text) {
  constexpr std::size_t kLongest = 24;
  std::string_view word = text.substr(0, text.find_first_of(" \t,/"));
  if (const Word known = find_word(word); changes_motion(known)) return known;
  if (const Word intended = find_intended_word(word); intended != Word::unknown) return intended;
  std::string squeezed;
  for (const char c : text.substr(0, text.find('/'))) {
    if (!is_blank(c) && squeezed.size() < kLongest) squeezed += c;
  }
  return find_intended_word(squeezed);
}

// Returns whether a line of numbers after this word is a position, or part of one.
bool is_among_positions(Word word) {
  static constexpr WordSet kWords = {Word::go_to, Word::godlta, Word::from,    Word::circle, Word::movarc,
                                     Word::rapid, Word::fedrat, Word::unknown, Word::cntrl};
  return kWords.has(word);
}

// Returns whether a word has no meaning without an argument.
bool needs_arguments(Word word) {
  static constexpr WordSet kWords = {Word::cycle,  Word::load,  Word::loadtl, Word::mode,   Word::rotabl,
                                     Word::select, Word::setup, Word::tldata, Word::toolno, Word::trans};
  return kWords.has(word);
}

// Returns whether the statement is cut short. A comma at its end announces more text; but CAMWorks writes one after the
// seven numbers of a CUTTER.
bool is_cut_short(const Statement& statement, std::size_t arguments) {
  constexpr std::size_t kNumbersOfCutter = 7;
  if (statement.is_decoded || !changes_motion(statement.word) || statement.pieces.empty()) return false;
  if (arguments == 0 && needs_arguments(statement.word)) return true;
  if (statement.word != Word::cycle && has_blank_in_number(statement)) return true;
  if (statement.word == Word::cutter && arguments == kNumbersOfCutter) return false;
  return statement.pieces.back().ends_with(',');
}

bool moves_tool(Word word) {
  static constexpr WordSet kWords = {Word::go_to,  Word::godlta,     Word::from,    Word::gohome, Word::unread_motion,
                                     Word::circle, Word::movarc,     Word::curve,   Word::tlon,   Word::nurbs,
                                     Word::cntrl,  Word::knot,       Word::indirv,  Word::retrct, Word::repeat,
                                     Word::auxfun, Word::arc_record, Word::helical, Word::copy};
  return kWords.has(word);
}

void distrust_moves(States& s, std::size_t statement) {
  Moves& moves = s.in.path.moves;
  for (std::size_t i = moves.size(); i-- > 0 && moves[i].statement == statement;) {
    if (!is_unread(moves[i].not_checked_reason)) moves[i].not_checked_reason = Reasons::kCutShort;
  }
}

// Handles a line whose beginning is missing, or that continues the previous statement without its `$`.
void distrust_beginning(States& s, bool is_position) {
  if (s.previous_statement != kNone) distrust_moves(s, s.previous_statement);
  distrust(s, s.previous_word);
  if (!is_position) s.uncertainties.set(Uncertainty::unread_frame, s.in.because(Reasons::kUnreadFrame));
}

bool has_numbers_alone(std::string_view text) {
  return text.find_first_not_of("0123456789+-.,()eEdD \t\r") == std::string_view::npos;
}

// Returns whether the last number of a position is complete. It is if it has the same number of decimals as the
// previous position's, at least two.
bool is_last_number_whole(const States& s) {
  constexpr std::size_t kFewest = 2;
  const auto& last = s.last_positions;
  const auto decimals = [](std::string_view text) {
    const std::size_t point = text.find('.');
    return point == std::string_view::npos ? 0 : text.size() - point - 1;
  };
  return last.statement == s.in.index() && last.numbers == last.numbers_before &&
         decimals(last.last_number) >= kFewest && decimals(last.last_number) == decimals(last.number_before);
}

// Distrusts the curve that is being read, or was read last.
void distrust_curve(Moves& moves) {
  if (!moves.empty() && !is_unread(moves.back().not_checked_reason)) moves.back().not_checked_reason = Reasons::kSpline;
}

}  // namespace

bool may_be_number(const Argument& argument) {
  return argument.number || argument.text.find_first_of("0123456789") != std::string_view::npos;
}

bool take_misread(States& s, std::string_view text) {
  text = without_label(text);
  if (begins_with_number(text)) {
    const bool is_position = is_among_positions(s.previous_word) && has_numbers_alone(text);
    distrust_beginning(s, is_position);
    if (is_position) emit_unread(s);
    return is_position;
  }
  const bool goes_on = is_minor_word(text.substr(0, text.find_first_of(" \t,"))) || s.in.statement().major.empty();
  goes_on ? distrust_beginning(s, false) : distrust(s, intended_word(text));
  return false;
}

void distrust(States& s, Word word) {
  const auto uncertainty = [&](Uncertainty which, const char* reason) {
    s.uncertainties.set(which, s.in.because(reason));
  };
  static constexpr WordSet kCutters = {Word::cutter, Word::tldata, Word::unread_tool};
  static constexpr WordSet kLoads = {Word::tool_path, Word::load, Word::loadtl, Word::toolno, Word::turret};
  static constexpr WordSet kFrames = {Word::tool_path, Word::csys,        Word::mcs,    Word::mcsys,  Word::msys,
                                      Word::mode,      Word::prefun,      Word::repeat, Word::rotabl, Word::select,
                                      Word::setup,     Word::syn,         Word::tlaxis, Word::trans,  Word::trntyp,
                                      Word::units,     Word::unread_frame};
  if (kCutters.has(word)) {
    s.tool.forget_cutter();
    uncertainty(Uncertainty::cutter, Reasons::kUnreadTool);
  }
  if (kLoads.has(word)) uncertainty(Uncertainty::loading, Reasons::kUnreadTool);
  if (kFrames.has(word)) uncertainty(Uncertainty::unread_frame, Reasons::kUnreadFrame);
  if (word == Word::multax) uncertainty(Uncertainty::multax, Reasons::kMultax);
  if (word == Word::cycle) s.cycle.begin_unknown();
  if (word == Word::cutcom) s.cutcom.begin();
  if (word == Word::cntrl || word == Word::knot) distrust_curve(s.in.path.moves);
  if (word == Word::rapid) s.chain.lose_start(Reasons::kAfterUnread);
}

void distrust_numbers_of_feed(States& s) {
  const NumberCount numbers = count_numbers(s.in.arguments);
  const std::size_t most = numbers.negative > 0 ? 2 : 3;
  if (s.in.statement().is_decoded || numbers.count <= most) return;
  s.in.count_unknown();
  emit_unread(s);
}

void distrust_last_line(States& s) {
  const std::string_view bytes = s.in.path.source;
  const Statement& statement = s.in.statement();
  if (statement.is_decoded || statement.last_byte != bytes.size() || bytes.ends_with('\n') || bytes.ends_with('\r'))
    return;
  if (!moves_tool(statement.word) || is_last_number_whole(s)) return;
  distrust_moves(s, s.in.index());
}

void distrust_last_axis(States& s) {
  const auto& last = s.last_positions;
  const bool is_at_end = last.statement != kNone && last.statement + 1 == s.in.path.statements.size();
  const bool lacks_axis = last.numbers == 3 && last.numbers_before == 6 && !last.has_plain;
  const bool is_usual = s.in.dialect.is_axis_modal || s.in.dialect.has_known_plain_axis;
  if (is_at_end && lacks_axis && !is_usual) distrust_moves(s, last.statement);
}

void distrust_cut_short(States& s) {
  if (!is_cut_short(s.in.statement(), s.in.arguments.size())) return;
  const Word word = s.in.statement().word;
  distrust_moves(s, s.in.index());
  distrust(s, word);
  if (moves_tool(word)) s.chain.lose_start(Reasons::kAfterUnread);
}

namespace {

// Words that begin something new. None of them occurs while a cycle drills or before the end of an arc.
constexpr WordSet kBeginsAnew = {Word::operation, Word::from, Word::gohome, Word::rapid};
// Further words of that kind, whose states hold for more than the next motion.
constexpr WordSet kSetsUp = {Word::tool_path, Word::end_of_path, Word::units, Word::mode,   Word::multax,
                             Word::tlaxis,    Word::cutcom,      Word::csys,  Word::mcs,    Word::mcsys,
                             Word::msys,      Word::rotabl,      Word::trans, Word::trntyp, Word::unread_frame};
constexpr WordSet kTools = {Word::cutter,           Word::tldata,     Word::loadtl, Word::load,
                            Word::toolno,           Word::turret,     Word::tprint, Word::flute_length,
                            Word::extension_length, Word::unread_tool};
constexpr WordSet kCurves = {Word::circle,  Word::movarc, Word::curve, Word::indirv, Word::arc_record,
                             Word::helical, Word::movnrb, Word::tlon,  Word::nurbs,  Word::cntrl};
constexpr WordSet kNoArcEnd = {Word::cycle, Word::retrct, Word::fini, Word::unread_motion, Word::godlta, Word::opskip};
constexpr WordSet kNewRun = {Word::cutter, Word::tldata,    Word::loadtl,    Word::load,        Word::toolno,
                             Word::turret, Word::operation, Word::tool_path, Word::end_of_path, Word::from};
// Other words whose states may hold for more than the next motion.
constexpr WordSet kMayLast = {Word::cycle, Word::curve, Word::auxfun,     Word::prefun, Word::setup, Word::select,
                              Word::index, Word::copy,  Word::arc_record, Word::repeat, Word::movnrb};

struct ModalRule {
  ModalState state;
  ModalEffect effect;
  WordSet words;
};

using enum ModalEffect;
constexpr auto kRules = std::to_array<ModalRule>({
    {ModalState::cycle, contradicts, kTools},
    {ModalState::cycle, contradicts, kBeginsAnew},
    {ModalState::cycle, contradicts, kSetsUp},
    {ModalState::cycle, contradicts, kCurves},
    {ModalState::described_arc, contradicts, kBeginsAnew},
    {ModalState::described_arc, contradicts, kSetsUp},
    {ModalState::described_arc, contradicts, kCurves},
    {ModalState::described_arc, contradicts, kNoArcEnd},
    {ModalState::start_tangent, contradicts, kBeginsAnew},
    {ModalState::start_tangent, contradicts, kSetsUp},
    {ModalState::start_tangent, contradicts, kCurves},
    {ModalState::start_tangent, contradicts, kNoArcEnd},
    {ModalState::start_tangent, contradicts, {Word::go_to, Word::godlta}},
    {ModalState::rapid, ends, {Word::fedrat, Word::tool_path}},
    {ModalState::cutter_centre, ends, {Word::operation}},
    {ModalState::motion_run, ends, kNewRun},
    {ModalState::block_skip, contradicts, kTools},
    {ModalState::block_skip, contradicts, kSetsUp},
    {ModalState::block_skip, contradicts, kMayLast},
    {ModalState::between_blocks, contradicts, {Word::msys}},
    {ModalState::between_blocks, ends, {Word::tool_path}},
});

// Returns whether a FEDRAT after a hole shows that the cycle has ended. It does if the CAM systems write none in their
// cycles.
bool ends_holes(FeedInCycle feeds, bool is_used) {
  return feeds == FeedInCycle::nowhere || (feeds == FeedInCycle::before_first_hole && is_used);
}

Word creo_word(std::string_view text) {
  if (starts_with_ignoring_case(text, "FEATNO")) return Word::operation;
  if (starts_with_ignoring_case(text, "CSYS")) return Word::csys;
  if (starts_with_ignoring_case(text, "CUTTER")) return Word::cutter;
  return Word::comment;
}

bool is_open(const States& s, ModalState state) {
  switch (state) {
    case ModalState::cycle:
      return s.cycle.is_on();
    case ModalState::described_arc:
      return s.curve.arc().has_value();
    case ModalState::start_tangent:
      return s.curve.has_tangent();
    case ModalState::rapid:
      return s.feed.is_rapid_pending() || s.feed.is_kind_doubtful();
    case ModalState::cutter_centre:
      return s.cutcom.is_centre();
    case ModalState::motion_run:
      return !s.uncertainties.has(Uncertainty::skip);
    case ModalState::block_skip:
      return s.uncertainties.has(Uncertainty::skip);
    case ModalState::between_blocks:
      return s.blocks.is_between();
  }
  return false;
}

void end_state(States& s, ModalState state) {
  switch (state) {
    case ModalState::rapid:
      return s.feed.end_rapid();
    case ModalState::cutter_centre:
      return s.cutcom.end_centre();
    case ModalState::motion_run:
      s.run_begin = s.in.moves();
      return;
    case ModalState::between_blocks:
      return s.blocks.leave_between();
    default:
      return;
  }
}

void contradict(States& s, ModalState state) {
  switch (state) {
    case ModalState::cycle:
      return s.cycle.contradict();
    case ModalState::described_arc:
    case ModalState::start_tangent:
      return drop_described_curve(s);
    case ModalState::block_skip:
      return contradict_skip(s);
    case ModalState::between_blocks:
      return s.blocks.note_frame_between();
    default:
      return;
  }
}

}  // namespace

Word acting_word(const Statement& statement, CommentForm comments) {
  if (equals_ignoring_case(statement.major, "OPFEATEND")) return Word::operation;
  const bool is_remark = statement.word == Word::free_text && starts_with_ignoring_case(statement.major, "REMARK");
  if ((statement.word != Word::comment && !is_remark) || statement.pieces.empty()) return statement.word;
  const std::string_view text = trim(statement.pieces.front());
  if (comments == CommentForm::creo && text.starts_with("->")) return creo_word(trim(text.substr(2)));
  if (is_remark) return statement.word;
  if (starts_with_ignoring_case(text, "*CATIA0")) return Word::mcs;
  if (comments == CommentForm::catia && starts_with_ignoring_case(text, "OPERATION NAME")) return Word::operation;
  return Word::comment;
}

ModalEffect effect_on(ModalState state, Word word, FeedInCycle feeds, bool is_used) {
  // an INDIRV is meant for this TLON
  if (state == ModalState::start_tangent && word == Word::tlon) return ModalEffect::none;
  if (state == ModalState::cycle && word == Word::fedrat && ends_holes(feeds, is_used)) return contradicts;
  for (const ModalRule& rule : kRules) {
    if (rule.state == state && rule.words.has(word)) return rule.effect;
  }
  return ModalEffect::none;
}

void apply_modal_states(States& s, Word word) {
  // most statements of a file; only the rows of INDIRV name it
  if (word == Word::go_to && !s.curve.has_tangent()) return;
  const FeedInCycle feeds = s.in.dialect.feed_in_cycle;
  for (const ModalState state : kModalStates) {
    if (!is_open(s, state)) continue;
    const bool is_used = state == ModalState::cycle && s.cycle.has_holes();
    const ModalEffect effect = effect_on(state, word, feeds, is_used);
    if (effect == ModalEffect::ends) end_state(s, state);
    if (effect == ModalEffect::contradicts) contradict(s, state);
  }
  // This word does not occur in cycles. Within a block skip it may be left out.
  if (!s.uncertainties.has(Uncertainty::skip) &&
      effect_on(ModalState::cycle, word, feeds, true) == ModalEffect::contradicts)
    s.cycle.bound_holes();
}

}  // namespace gouge
