#include "postproc/cldata/interpreting/modal_states.h"

#include <array>
#include <string_view>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

// Words that begin something new: none of them is written while a cycle drills or before the end of an arc.
constexpr WordSet kBeginsAnew = {Word::operation, Word::from, Word::gohome, Word::rapid};
// The other words of that kind: what they say holds for more than the next motion.
constexpr WordSet kSetsUp = {Word::tool_path, Word::end_of_path, Word::units, Word::mode,   Word::multax,
                             Word::tlaxis,    Word::cutcom,      Word::csys,  Word::mcs,    Word::mcsys,
                             Word::msys,      Word::rotabl,      Word::trans, Word::trntyp, Word::unread_frame};
constexpr WordSet kTools = {Word::cutter, Word::tldata, Word::loadtl,       Word::load,       Word::toolno,
                            Word::turret, Word::tprint, Word::flute_length, Word::unread_tool};
constexpr WordSet kCurves = {Word::circle,  Word::movarc, Word::curve, Word::indirv, Word::arc_record,
                             Word::helical, Word::movnrb, Word::tlon,  Word::nurbs,  Word::cntrl};
constexpr WordSet kNoArcEnd = {Word::cycle, Word::retrct, Word::fini, Word::unread_motion, Word::godlta};
constexpr WordSet kNewRun = {Word::cutter, Word::tldata,    Word::loadtl,    Word::load,        Word::toolno,
                             Word::turret, Word::operation, Word::tool_path, Word::end_of_path, Word::from};
// What may hold for more than the next motion besides.
constexpr WordSet kMayLast = {Word::cycle,  Word::curve, Word::auxfun, Word::prefun,     Word::setup,
                              Word::select, Word::index, Word::copy,   Word::arc_record, Word::repeat};

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

// FEDRAT behind a hole: it says that the cycle has ended where CAM systems write none in their cycles.
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
      return s.feed.is_rapid();
    case ModalState::cutter_centre:
      return s.cutcom.is_centre();
    case ModalState::motion_run:
      return true;
    case ModalState::block_skip:
      return s.doubts.has(Doubt::skip);
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
      s.skips_more_than_motion = true;
      return;
    case ModalState::between_blocks:
      return s.blocks.note_frame_between();
    default:
      return;
  }
}

}  // namespace

Word acting_word(const Statement& statement, CommentForm comments) {
  if (equals_ignoring_case(statement.major, "OPFEATEND")) return Word::operation;
  if (statement.word != Word::comment || statement.pieces.empty()) return statement.word;
  const std::string_view text = trim(statement.pieces.front());
  if (comments == CommentForm::creo && text.starts_with("->")) return creo_word(trim(text.substr(2)));
  if (starts_with_ignoring_case(text, "*CATIA0")) return Word::mcs;
  if (comments == CommentForm::catia && starts_with_ignoring_case(text, "OPERATION NAME")) return Word::operation;
  return Word::comment;
}

ModalEffect effect_on(ModalState state, Word word, FeedInCycle feeds, bool is_used) {
  if (state == ModalState::start_tangent && word == Word::tlon) return ModalEffect::none;  // what it is for
  if (state == ModalState::cycle && word == Word::fedrat && ends_holes(feeds, is_used)) return contradicts;
  for (const ModalRule& rule : kRules) {
    if (rule.state == state && rule.words.has(word)) return rule.effect;
  }
  return ModalEffect::none;
}

void apply_modal_states(States& s, Word word) {
  if (word == Word::go_to && !s.curve.has_tangent()) return;  // most of a file; of all rows only INDIRV's names it
  const FeedInCycle feeds = s.in.dialect.feed_in_cycle;
  for (const ModalState state : kModalStates) {
    if (!is_open(s, state)) continue;
    const bool is_used = state == ModalState::cycle && s.cycle.has_holes();
    const ModalEffect effect = effect_on(state, word, feeds, is_used);
    if (effect == ModalEffect::ends) end_state(s, state);
    if (effect == ModalEffect::contradicts) contradict(s, state);
  }
  // No cycle holds this word.
  if (effect_on(ModalState::cycle, word, feeds, true) == ModalEffect::contradicts) s.cycle.bound_holes();
}

}  // namespace gouge
