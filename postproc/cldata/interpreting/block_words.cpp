#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/further_readings.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/post_words.h"
#include "postproc/cldata/language/text.h"

// Handlers for blocks, operations, the end of a program, and words with text.

namespace gouge {
namespace {

// Takes the text after $$-> or REMARK -> of Creo.
void take_creo_comment(States& s, std::string_view text) {
  const std::string_view rest = trim(text.substr(std::min(text.find('/'), text.size() - 1) + 1));
  if (starts_with_ignoring_case(text, "CSYS")) {
    Statement values = s.in.statement();
    values.pieces.front() = rest;
    split_arguments(values, s.in.arguments);
    note_creo_csys(s);
  } else if (starts_with_ignoring_case(text, "FEATNO")) {
    s.operation.name("FEATNO " + name_text(rest), s.in.line());
    break_motion(s);  // between sequences the machine moves to its home position
  } else if (starts_with_ignoring_case(text, "CUTCOM_GEOMETRY_TYPE")) {
    const bool is_on_centre = starts_with_ignoring_case(rest, "OUTPUT_ON_CENTER");
    const bool is_on_profile = starts_with_ignoring_case(rest, "OUTPUT_ON_PROFILE");
    const bool is_understood = is_on_centre || is_on_profile || rest.empty();
    s.uncertainties.set(Uncertainty::contour,
                        is_understood ? nullptr : s.in.named(Reasons::kContour, "CUTCOM_GEOMETRY_TYPE", s.in.line()));
    is_on_profile ? s.cutcom.begin_contour() : s.cutcom.end_contour();
    if (is_on_centre) s.cutcom.begin_centre();
  } else if (starts_with_ignoring_case(text, "CUTTER")) {
    s.tool.take_diameter(rest, s.frame.mm_per_unit());
  }
}

void take_catia_row(States& s, std::string_view text) {
  const std::optional<RigidTransform> frame = s.matrix.take_row(text);
  if (!frame) return;
  s.uncertainties.clear(Uncertainty::matrix);
  set_frame(s, *frame);
}

bool has_slash(const StatementContext& in) { return trim(in.text_behind_major()).starts_with('/'); }

bool is_creo_statement(const States& s, std::string_view text) {
  return s.in.dialect.comments == CommentForm::creo && text.starts_with("->");
}

// Returns whether a text names another point of the tool than its tip for positions: "BALL CENTER OUTPUT", "TOOL OUTPUT
// POINT : CENTER", "contact data".
bool names_other_point(std::string_view text) {
  constexpr std::array<std::string_view, 2> kCentre = {"CENTER", "CENTRE"};
  constexpr std::array<std::string_view, 2> kBall = {"BALL", "SPHERE"};
  constexpr std::array<std::string_view, 2> kPoint = {"OUTPUT", "REFERENCE"};
  constexpr std::array<std::string_view, 3> kContact = {"DATA", "POINT", "POINTS"};
  std::array<std::string_view, 3> last;  // the last three words, the latest at the end
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end == at) {
      ++at;
      continue;
    }
    last = {last[1], last[2], text.substr(at, end - at)};
    at = end;
    const bool is_centre = is_one_of(last[2], kCentre);
    if (is_centre && is_one_of(last[1], kBall)) return true;
    if ((is_centre || equals_ignoring_case(last[2], "CONTACT")) && equals_ignoring_case(last[1], "POINT") &&
        is_one_of(last[0], kPoint))
      return true;
    if (equals_ignoring_case(last[1], "CONTACT") && is_one_of(last[2], kContact)) return true;
  }
  return false;
}

void note_point(States& s, std::string_view text) {
  if (starts_with_ignoring_case(text, "centerline data")) {
    s.uncertainties.clear(Uncertainty::tip);
    if (s.blocks.is_open()) s.cutcom.begin_centre();
  }
  if (names_other_point(text))
    s.uncertainties.set(Uncertainty::tip, s.in.named(Reasons::kTipElsewhere, s.in.statement().major, s.in.line()));
}

}  // namespace

// Ends the program. Another program may follow, for which earlier statements need not hold.
void end_program(States& s) {
  break_motion(s);
  s.chain.forbid_link();
  if (!s.uncertainties.has(Uncertainty::ended))
    s.uncertainties.set(Uncertainty::ended, s.in.because(Reasons::kAfterEnd));
}

void take_comment(States& s) {
  const std::string_view text = trim(s.in.first_piece());
  const bool is_catia = s.in.dialect.comments == CommentForm::catia;
  if (is_creo_statement(s, text)) return take_creo_comment(s, trim(text.substr(2)));
  if (starts_with_ignoring_case(text, "*CATIA0")) {
    s.matrix.begin();
  } else if (s.matrix.expects_row()) {
    take_catia_row(s, text);
  } else if (is_catia && s.matrix.is_row(text)) {
    s.uncertainties.set(Uncertainty::matrix, s.in.named(Reasons::kMatrixRow, "$$", s.in.line()));
  } else if (is_catia && starts_with_ignoring_case(text, "OPERATION NAME")) {
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos) s.operation.name(name_text(text.substr(colon + 1)), s.in.line());
  } else {
    note_point(s, text);
  }
}

// Takes TOOL PATH/operation,TOOL,tool: a block with its own frame, axis and tool.
void take_tool_path(States& s) {
  s.blocks.begin(s.in.moves());
  const std::string_view text = s.in.first_piece();
  const std::size_t cut = text.find(",TOOL,");
  s.operation.name(name_text(text.substr(0, cut)), s.in.line());
  s.tool.begin_block(cut == std::string_view::npos ? std::string() : name_text(text.substr(cut + 6)));
  break_motion(s);
  s.axes.begin_block();
  s.cutcom.end_centre();
  s.frame.begin_block();
  s.uncertainties.clear(Uncertainty::skew);
  s.feed.begin_block();
  s.cycle.begin_block();
  s.blocks.open(s.in.line());
  s.is_unknown_in_block = false;
  s.uncertainties.clear(Uncertainty::tip);
  s.uncertainties.set(Uncertainty::block, s.blocks.take_frame_between() ? Reasons::kMsysOutside : nullptr);
}

void take_end_of_path(States& s) {
  if (s.blocks.number() == 0) mark_moves_uncertain(s, 0, s.in.moves(), Reasons::kNoToolPath);
  s.blocks.end();
  s.end_line = s.in.line();
  s.uncertainties.set(Uncertainty::block, Reasons::kBetweenBlocks);
  break_motion(s);
}

void take_operation(States& s) {
  if (s.in.dialect.operations_are_blocks) s.blocks.begin(s.in.moves());
  s.operation.name(name_text(s.in.first_piece()), s.in.line());
}

void take_fini(States& s) {
  s.end_line = s.in.line();
  s.cycle.leave_hole();
  end_program(s);
}

void take_free_text(States& s) {
  const std::string_view major = s.in.statement().major;
  if (equals_ignoring_case(major, "PARTNO")) {
    s.has_begin = true;
    if (s.in.moves() > 0) {
      end_program(s);
    } else {
      s.uncertainties.clear(Uncertainty::unknown);  // text before a program is not part of it
    }
  }
  if (equals_ignoring_case(major, "OPFEATEND")) {
    s.setup.end_feature();
    contradict_skip(s);
  }
  // this statement mills letters
  if (equals_ignoring_case(major, "LETTER") && has_slash(s.in)) return take_unknown_statement(s);
  // Creo 9 writes REMARK -> in place of the comment $$-> of older files.
  if (!starts_with_ignoring_case(major, "REMARK")) return;
  const std::string_view text = trim(s.in.first_piece());
  is_creo_statement(s, text) ? take_creo_comment(s, trim(text.substr(2))) : note_point(s, text);
}

void take_pprint(States& s) {
  if (s.in.dialect.pprint_includes_files && starts_with_ignoring_case(trim(s.in.first_piece()), "INCLUD")) {
    emit_unread(s);
    return s.in.count_unknown();
  }
  note_point(s, s.in.first_piece());
  if (!s.in.dialect.names_operations) s.operation.name(name_text(s.in.first_piece()), s.in.line());
}

// Takes PPWORD/word,code: a word of the post-processor and its number in the table of words. A word that this reader
// knows must keep its meaning. Numbers from 3150 are those of Creo's GPOST for its own words; others are those of IBM's
// table.
void take_ppword(States& s) {
  constexpr double kFirstOfGpost = 3150, kLastOfGpost = 3199;
  const std::vector<Argument>& arguments = s.in.arguments;
  const bool has_form = arguments.size() == 2 && !arguments[0].number && arguments[1].number;
  if (!has_form) return s.in.count_unknown();
  const Word word = find_word(arguments[0].text);
  if (word == Word::unknown || word == Word::harmless || word == Word::free_text) return;
  const double code = *arguments[1].number;
  if (code >= kFirstOfGpost && code <= kLastOfGpost) return;
  const bool is_code = code >= 1 && code <= 9999;
  if (is_code && equals_ignoring_case(major_of_code(static_cast<std::uint16_t>(code)), arguments[0].text)) return;
  s.in.fail("path-statement",
            "PPWORD gives " + quoted_text(arguments[0].text) +
                " another meaning; expected the words themselves: write them in place of their synonyms");
}

// Takes SYN of CAMplete. SYN/'TLAXIS','$$*TLAXIS' declares TLAXIS to be a comment. Other new names would have to be
// read as the words for which they stand.
void take_syn(States& s) {
  for (const Argument& argument : s.in.arguments) {
    std::string_view name = argument.text;
    while (!name.empty() && name.front() == '\'') name.remove_prefix(1);
    while (!name.empty() && name.back() == '\'') name.remove_suffix(1);
    if (equals_ignoring_case(argument.text, "'TLAXIS'")) {
      s.axes.ignore_tlaxis();
    } else if (find_word(name) != Word::unknown) {
      return s.in.fail("path-statement", "SYN: a synonym of " + quoted_text(argument.text) +
                                             "; expected the words themselves: write them in place of their synonyms");
    }
  }
}

}  // namespace gouge
