#include "postproc/gcode/heidenhain/klartext_runner.h"

#include <algorithm>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/gcode/heidenhain/plain_statements.h"

namespace gouge {
namespace {

std::string first_word(std::string_view text) {
  return std::string(text.substr(0, std::min(text.find(' '), text.size())));
}

/// Returns whether a block states another axis of a datum shift.
bool goes_on_shifting(std::string_view text) {
  const bool is_cycle = take_keywords(text, "CYCL DEF") || take_keywords(text, "CYCLE DEF");
  return is_cycle && text.starts_with("7.") && !text.starts_with("7.0");
}

/// Returns whether a statement may change the frame.
bool may_state_frame(std::string_view text) {
  return take_keywords(text, "PLANE") || take_keywords(text, "CYCL DEF") || take_keywords(text, "CYCLE DEF");
}

/// Returns the length of --tool-lengths that a length in the program contradicts; none: it does not.
std::optional<double> contradicted_length(const std::map<int, double>& lengths, int tool, double stated_mm) {
  constexpr double kSameLength_mm = 1e-6;
  const auto found = lengths.find(tool);
  if (found == lengths.end() || std::abs(found->second - stated_mm) <= kSameLength_mm) return std::nullopt;
  return found->second;
}

/// Returns the number of a tool, or its name in quotes.
std::string name_of_tool(const PathTool& tool) {
  return tool.number ? std::to_string(*tool.number) : "\"" + tool.name + "\"";
}

}  // namespace

KlartextRunner::KlartextRunner(const ProgramInput& input, QParameters& parameters)
    : input_(input), setup_(input.options.setup), motion_(input.motion), parameters_(parameters) {
  unit_ = input.options.unit.value_or(LengthUnit::mm);
  facts_.unit_word = "BEGIN PGM";
  motion_.apply_length(std::nullopt);  // of the tool in the spindle, always
}

void KlartextRunner::lose_rest(const std::string& reason) { lose_program(reason, line_, input_); }

void KlartextRunner::run(const KlartextBlock& block, std::size_t line, bool is_cut) {
  line_ = line;
  is_cut_ = is_cut;
  if (motion_.is_rest_unknown()) {
    if (!block.text.empty()) motion_.go_unchecked(MoveKind::feed, AxisPlace{}, {});
    return;
  }
  if (block.text.empty()) {
    if (!block.comment.empty()) motion_.name_operation(block.comment);
    return;
  }
  const bool is_step = block.text.starts_with("CYCL");
  if (needs_step_ && !is_step)
    return lose_rest("CYCL DEF " + std::to_string(step_[0]) + ".0 has no values in the next block");
  if (!is_step) step_ = {};
  if (!goes_on_shifting(block.text)) end_shift();
  has_several_lines_ = block.has_several_lines;
  const bool may_change_frame = may_state_frame(block.text);
  const Vec3 before = may_change_frame ? place() : Vec3::Zero();
  run_statement(block.text);
  if (may_change_frame) note_moved_axes(before);
}

// No manual at hand states whether the first step begins at the place of the tool, or at its coordinates before the frame
// changed.
void KlartextRunner::note_moved_axes(const Vec3& before) {
  const Vec3 after = place();
  for (std::size_t i = 0; i < 3; ++i) {
    const double apart = std::abs(after[static_cast<int>(i)] - before[static_cast<int>(i)]);
    if (!(apart <= Tolerance::kSamePoint_mm)) is_moved_.at(i) = true;
  }
}

void KlartextRunner::run_statement(std::string_view text) {
  const bool is_line = text.starts_with("L ") && has_begun_ && !has_ended_;
  if (is_line && run_path_statement(text)) return;
  if (take_keywords(text, "BEGIN PGM")) return begin_program(text);
  if (has_ended_) return lose_rest("a block behind the end of the program");
  if (take_keywords(text, "END PGM")) return end_program(text);
  if (!has_begun_ && line_ > 0) return lose_rest(first_word(text) + " stands before BEGIN PGM");
  if (line_ == 0 && take_start_fact(text)) return;
  if (take_keywords(text, "TOOL CALL")) return call_tool(text);
  if (take_keywords(text, "TOOL DEF")) return define_tool(text);
  if (take_keywords(text, "CYCL DEF") || take_keywords(text, "CYCLE DEF")) return define_cycle(text);
  if (take_keywords(text, "CYCL CALL")) return call_cycle(text);
  if (take_keywords(text, "PLANE")) return define_plane(text);
  if (take_keywords(text, "FUNCTION")) return control_tip(text);
  if (const auto wrong = read_plain_statement(text, parameters_)) {
    if (!wrong->empty()) return lose_rest(*wrong);
    if (has_several_lines_) lose_rest("'~' behind " + first_word(text) + ", whose block is read in one line alone");
    return;
  }
  std::string_view rest = text;
  if (take_keywords(rest, "STOP")) return run_functions(rest);
  if (text[0] == 'M' && text.size() > 1 && is_digit(text[1])) return run_functions(text);
  if (!run_path_statement(text)) lose_rest(first_word(text) + " begins a statement that is not read");
}

// Facts of the machine that no program states. The user states them among the blocks at the start.
bool KlartextRunner::take_start_fact(std::string_view text) {
  const bool is_point = text == "REFPNT TIP-TIP", is_plane = text == "CYCL DEF 19 SPATIAL";
  are_points_of_tip_ = are_points_of_tip_ || is_point;
  are_cycle_angles_spatial_ = are_cycle_angles_spatial_ || is_plane;
  return is_point || is_plane;
}

bool KlartextRunner::run_path_statement(std::string_view text) {
  using Go = void (KlartextRunner::*)(const PathWords&);
  struct Statement {
    std::string_view keyword;
    PathForm form;
    Go go;
  };
  static constexpr std::array<Statement, 6> kStatements = {{
      {"L", {.has_coordinates = true, .has_compensation = true}, &KlartextRunner::go_line},
      {"LP", {.has_coordinates = true, .has_compensation = true, .has_polar = true}, &KlartextRunner::go_polar_line},
      {"CC", {.has_coordinates = true}, &KlartextRunner::set_pole},
      {"C", {.has_coordinates = true, .has_compensation = true, .has_direction = true}, &KlartextRunner::go_about_pole},
      {"CP",
       {.has_coordinates = true, .has_compensation = true, .has_polar = true, .has_direction = true},
       &KlartextRunner::go_polar_arc},
      {"CR",
       {.has_coordinates = true, .has_compensation = true, .has_radius = true, .has_direction = true},
       &KlartextRunner::go_by_radius},
  }};
  std::string_view rest = text;
  PathWords words;
  for (const Statement& one : kStatements) {
    if (!take_keywords(rest, one.keyword)) continue;
    if (take_words(rest, one.form, words)) (this->*one.go)(words);
    return true;
  }
  const bool is_polar = take_keywords(rest, "CTP");
  if (is_polar || take_keywords(rest, "CT")) {
    if (take_words(rest, {.has_coordinates = true, .has_compensation = true, .has_polar = is_polar}, words))
      go_tangentially(words, is_polar);
    return true;
  }
  if (take_keywords(rest, "RND") || take_keywords(rest, "CHF")) {
    cut_corner(rest);
    return true;
  }
  if (!take_keywords(rest, "LN")) return false;
  // Compensation in space and vectors of the tool: where the tool goes is not known.
  run_unchecked(MoveKind::feed, {}, "LN moves the tool by a vector with compensation in space");
  return true;
}

bool KlartextRunner::read_words(std::string_view text, Words& words) {
  const std::string wrong = read_klartext_words(text, parameters_, words);
  if (!wrong.empty()) lose_rest(wrong);
  return wrong.empty();
}

bool KlartextRunner::take_words(std::string_view text, const PathForm& form, PathWords& taken) {
  if (!read_words(text, path_words_)) return false;
  const std::string wrong = take_path_words(path_words_, form, input_.options.harmless_words, taken);
  if (!wrong.empty()) lose_rest(wrong);
  return wrong.empty();
}

void KlartextRunner::begin_program(std::string_view text) {
  if (has_begun_) return lose_rest("BEGIN PGM stands within a program");
  const bool is_mm = text.ends_with(" MM"), is_inch = text.ends_with(" INCH");
  if (!is_mm && !is_inch) return lose_rest("BEGIN PGM states no name, or neither MM nor INCH");
  has_begun_ = true;
  head_ = text;
  unit_ = is_mm ? LengthUnit::mm : LengthUnit::inch;
  facts_.unit_line = line_;
  input_.path.unit = unit_;
  input_.path.is_unit_stated = true;
}

// The control writes the same name and unit into the first and the last block.
void KlartextRunner::end_program(std::string_view text) {
  if (!text.empty() && text != head_)
    return lose_rest("END PGM " + std::string(text) + " does not end BEGIN PGM " + head_ +
                     ", so a part of the file may be missing");
  has_ended_ = true;
  facts_.end_line = line_;
}

// Source: iTNC 530 60642x-04, TOOL CALL: number or name, tool axis, S, F, DL, DR, DR2.
void KlartextRunner::call_tool(std::string_view text) {
  const std::string with_name = "T" + std::string(text);  // the number or name stands without an address
  Words words;
  if (!read_words(with_name, words)) return;
  const KlartextWord tool = words.front();
  const bool has_number = whole_number(tool) && tool.name == "T", has_name = tool.kind == KlartextWord::Kind::text;
  std::string axis;
  std::map<std::string, double> values;
  for (std::size_t i = has_number || has_name ? 1 : 0; i < words.size(); ++i) {
    KlartextWord word = words[i];
    if (i == 0) word.name = word.name.substr(1);
    if (i == 0 && word.name.empty() && word.kind == KlartextWord::Kind::name) continue;
    const bool is_axis =
        word.kind == KlartextWord::Kind::name && (word.name == "Z" || word.name == "X" || word.name == "Y");
    const bool is_value =
        word.kind == KlartextWord::Kind::number &&
        (word.name == "S" || word.name == "F" || word.name == "DL" || word.name == "DR" || word.name == "DR2");
    if (is_axis ? !axis.empty() : !is_value || !values.emplace(word.name, word.value).second)
      return lose_rest("'" + word_text(word) + "' has no place in TOOL CALL");
    if (is_axis) axis = word.name;
  }
  if (!axis.empty() && axis != "Z") return lose_rest("TOOL CALL with tool axis " + axis + "; only Z is read");
  if (values.contains("F")) feed_ = length(values["F"]);
  if (values.contains("S")) motion_.set_spindle(values["S"]);
  set_feed();
  const bool has_tool = has_number || has_name;
  const double oversize = values.contains("DL") ? values["DL"] : 0;
  if (has_tool || values.contains("DL"))
    length_open_ = std::abs(oversize) <= 0 ? "" : "TOOL CALL" + in_line(line_) + " has an oversize DL of its length";
  if (!has_tool) return settle_length();  // the spindle speed, and an oversize
  if (axis.empty()) return lose_rest("TOOL CALL states no tool axis");
  PathTool loaded;
  if (has_number) loaded.number = whole_number(tool);
  loaded.name = tool.text;
  loaded.line = line_;
  if (const auto found = diameters_mm_.find(name_of_tool(loaded)); found != diameters_mm_.end())
    loaded.stated_diameter_mm = found->second;
  // L+0, and a length from the tip of another tool, are none of the whole tool.
  if (const auto found = lengths_mm_.find(name_of_tool(loaded)); found != lengths_mm_.end() && found->second > 0)
    loaded.loaded_length_mm = found->second;
  if (motion_.tip_control() == TipControl::on) motion_.set_tip_control(TipControl::unknown);
  motion_.change_tool(loaded);
  motion_.apply_length(std::nullopt);  // TOOL CALL applies the length of its tool
  tangent_.reset();
  settle_length();
}

// A tool of the library is compared with the radius, also where the program loads it before it states the radius.
void KlartextRunner::define_radius(const PathTool& tool, double radius) {
  const double diameter_mm = 2 * length(radius);
  const std::string name = name_of_tool(tool);
  if (!(diameter_mm >= 0))
    return lose_rest("TOOL DEF states a negative radius of tool " + name + "; expected 0 or more");
  if (!(diameter_mm > 0)) return;  // the program does not use the radius
  const auto in_table = tool.number ? setup_.diameters_mm.find(*tool.number) : setup_.diameters_mm.end();
  if (in_table != setup_.diameters_mm.end() && std::abs(in_table->second - diameter_mm) > Tolerance::kFilePoint_mm)
    return lose_rest("TOOL DEF states another radius of tool " + name + " than the tool table; expected one");
  const auto [known, is_new] = diameters_mm_.emplace(name, diameter_mm);
  if (!is_new && std::abs(known->second - diameter_mm) > Tolerance::kFilePoint_mm)
    return lose_rest("TOOL DEF states two different radii of tool " + name + "; expected one");
  for (PathTool& loaded : input_.path.tools) {
    if (loaded.number != tool.number || loaded.name != tool.name) continue;
    loaded.stated_diameter_mm = diameter_mm;
    loaded.in_table.has_diameter = false;
  }
}

// Source: iTNC 530 60642x-04, TOOL DEF: length L and radius R; without them the tool is only made ready.
void KlartextRunner::define_tool(std::string_view text) {
  const std::string with_name = "T" + std::string(text);
  Words words;
  if (!read_words(with_name, words)) return;
  const auto number = whole_number(words.front());
  const bool is_named = words.front().kind == KlartextWord::Kind::text;
  if (words.front().name != "T" || (!number && !is_named)) return lose_rest("TOOL DEF states no tool");
  PathTool defined;
  if (!is_named) defined.number = number;
  defined.name = words.front().text;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const KlartextWord& word = words[i];
    const bool is_length = word.has_number("L");
    if (!is_length && !word.has_number("R")) return lose_rest("'" + word_text(word) + "' has no place in TOOL DEF");
    if (!is_length) define_radius(defined, word.value);
    if (is_length) lengths_mm_[name_of_tool(defined)] = length(word.value);
    if (!is_length || !number || facts_.error) continue;
    const double stated_mm = length(word.value);
    if (const auto other_mm = contradicted_length(setup_.lengths_mm, *number, stated_mm))
      facts_.error = make_error("tool-lengths",
                                "TOOL DEF states a length of " + display_text(stated_mm, 6) + " mm for tool " +
                                    std::to_string(*number) + ", and --tool-lengths " + display_text(*other_mm, 6) +
                                    " mm; correct one of them",
                                input_.path.file, line_);
  }
}

void KlartextRunner::run_functions(std::string_view text) {
  PathWords words;
  if (!take_words(text, {}, words)) return;
  begin_motion(words);
  end_motion(words);
}

void KlartextRunner::end_shift() {
  if (!frame_.is_shifting()) return;
  frame_.end_shift();
  settle_frame();
}

void KlartextRunner::settle_length() {
  const std::string& open = !length_open_.empty() ? length_open_ : tip_open_;
  if (open.empty())
    motion_.end_doubt(ProgramDoubt::length);
  else
    motion_.doubt(ProgramDoubt::length, open);
}

void KlartextRunner::settle_path() {
  const std::string& open = !path_open_.empty() ? path_open_ : tolerance_open_;
  if (open.empty())
    motion_.end_doubt(ProgramDoubt::path_control);
  else
    motion_.doubt(ProgramDoubt::path_control, open);
}

}  // namespace gouge
