#include "postproc/cldata/interpreting/tool_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

// The tools of a file, and which of them is loaded.

namespace gouge {

namespace {

constexpr std::size_t kCuttersReported = 20;
constexpr double kMaxRegister = 1e6;      // a control has thousands
constexpr std::size_t kMaxTools = 10000;  // a machine has hundreds
constexpr std::array<std::string_view, 5> kTurningTypes = {"TURN", "GROOVE", "THREAD", "WEDM", "WIRE"};

// Returns the diameter in TOOLNO/n,d or TOOLNO/n,MILL,..,..,d of CATIA; 0 if it has none.
double diameter_of_toolno(const std::vector<Argument>& arguments) {
  constexpr std::size_t kOfMill = 4;
  if (arguments.size() > 1 && arguments[1].number) return *arguments[1].number;
  const bool is_mill = arguments.size() > kOfMill && equals_ignoring_case(arguments[1].text, "MILL");
  return is_mill ? arguments[kOfMill].number.value_or(0) : 0;
}

// Returns the number that follows a word among arguments; nothing: there is none.
std::optional<double> number_behind(const std::vector<Argument>& arguments, std::string_view word) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (equals_ignoring_case(arguments[i - 1].text, word)) return arguments[i].number;
  }
  return std::nullopt;
}

// Returns whether TOOLNO has a number after number and diameter, whose meaning no known writer states.
bool has_number_after_diameter(const std::vector<Argument>& arguments) {
  return arguments.size() > 2 && arguments[1].number && arguments[2].number;
}

// Returns the first text in single quotes of a statement, which may contain commas; empty: there is none.
std::string name_in_quotes(const Statement& statement) {
  for (const std::string_view piece : statement.pieces) {
    const std::size_t begin = piece.find('\'');
    if (begin == std::string_view::npos) continue;
    const std::string_view behind = piece.substr(begin + 1);
    return name_text(behind.substr(0, behind.find('\'')));
  }
  return {};
}

// Returns whether a CUTTER/d,r repeats, in short form, a cutter that was given in full.
bool is_in_short(const CutterStatement& again, const CutterStatement& known) {
  constexpr int kDiameterAndCorner = 2;
  return again.given == kDiameterAndCorner && known.given > again.given && !(std::abs(again.d_mm - known.d_mm) > 0) &&
         !(std::abs(again.r_mm - known.r_mm) > 0);
}

std::array<double, 7> key_of(const CutterStatement& c) {
  return {c.d_mm, c.r_mm, c.e_mm, c.f_mm, c.alpha_deg, c.beta_deg, c.h_mm};
}

// Returns whether a diameter of TOOLNO is that of the cutter. For a taper it is the largest diameter, or that of the
// tip.
bool is_diameter_of(const CutterStatement& cutter, double stated_mm) {
  constexpr double kSameDiameter = 0.01;  // relative to the diameter, because files round it
  const double taper_mm = 2 * cutter.h_mm * std::tan(cutter.beta_deg * std::numbers::pi / 180);
  const auto is_near = [&](double mm) { return std::abs(mm / stated_mm - 1) <= kSameDiameter; };
  return is_near(cutter.d_mm) || (taper_mm > 0 && is_near(cutter.d_mm + taper_mm));
}

}  // namespace

void ToolState::forget_cutter() {
  tool_.cutter.reset();
  is_changed_ = true;
}

// Sets the cutter, or adds a note why the numbers define none.
void ToolState::set_cutter(const CutterOutcome& outcome) {
  if (!outcome.cutter) {
    forget_cutter();
    if (cutters_without_tool_++ >= kCuttersReported) return;
    in_.path.notes.push_back(make_warning("path-cutter", outcome.note, in_.path.file, in_.line()));
    return;
  }
  if (!tool_.cutter || !is_in_short(*outcome.cutter, *tool_.cutter)) tool_.cutter = outcome.cutter;
  tool_.flute_length_mm = outcome.flute_length_mm;
  tool_.stickout_mm = 0;
  tool_.line = in_.line();
  tool_.is_fresh = true;
  is_changed_ = true;
}

void ToolState::take_cutter(double mm_per_unit, bool is_behind_insert) {
  uncertainties_.clear(Uncertainty::cutter);
  const CutterOutcome outcome = make_cutter(in_.arguments, mm_per_unit, in_.dialect.has_tip_diameter);
  if (outcome.is_recomputed) recomputed_.add(in_.line());
  if (!outcome.error.empty()) {
    const Argument* word = find_word_argument(in_.arguments);
    if (word != nullptr && in_.path.moves.empty() && !word->text.empty() && word->text[0] >= 'A') {
      return in_.refuse_part_program(in_.major() + "/" + std::string(word->text));
    }
    return in_.fail("path-cutter", "CUTTER: " + outcome.error + "; expected d or d,r or d,r,e,f,alpha,beta,h");
  }
  if (is_behind_insert) set_name(last_insert_);
  set_cutter(outcome);
}

// Takes a diameter. Flat, ball and bull-nose cutters have the same statement, so it defines no tool. But a tool of a
// library can be compared with it.
void ToolState::take_diameter(std::string_view text, double mm_per_unit) {
  Statement values;
  values.pieces.push_back(text);
  split_arguments(values, in_.arguments);
  const bool is_number = in_.has_numbers_alone(1) && *in_.arguments.front().number > 0;
  tool_.diameter_mm = is_number ? *in_.arguments.front().number * mm_per_unit : 0;
  set_name("diameter " + name_text(text));
  tool_.line = in_.line();
  tool_.is_fresh = true;
  is_changed_ = true;
}

void ToolState::take_tldata(double mm_per_unit) {
  if (in_.arguments.empty()) return in_.count_unknown();
  uncertainties_.clear(Uncertainty::cutter);
  const std::string_view type = in_.arguments.front().text;
  const bool is_drill = equals_ignoring_case(type, "DRILL");
  forget_cutter();
  const bool is_turning = is_one_of(type, kTurningTypes);
  uncertainties_.set(Uncertainty::turning, is_turning ? in_.because(Reasons::kTurning) : nullptr);
  if (is_turning) return;
  CutterOutcome outcome;
  outcome.note = "TLDATA/" + name_text(type) + " is not understood: define the tool in the tool library";
  if (!is_drill && !equals_ignoring_case(type, "MILL")) return set_cutter(outcome);
  std::span<const Argument> numbers(in_.arguments);
  numbers = numbers.subspan(1);
  if (is_drill && !numbers.empty() && !numbers.front().number) numbers = numbers.subspan(1);
  outcome = make_tldata_cutter(numbers, is_drill, mm_per_unit);
  if (outcome.error.empty()) return set_cutter(outcome);
  in_.fail("path-cutter", "TLDATA: " + outcome.error +
                              (is_drill ? "; expected DRILL,MILL,diameter,radius,length,point angle,flute length"
                                        : "; expected MILL,diameter,radius,length,taper angle,tip angle"));
}

void ToolState::take_flute_length(double mm_per_unit) {
  if (!in_.has_numbers_alone(1) || *in_.arguments.front().number < 0) return in_.count_unknown();
  tool_.flute_length_mm = *in_.arguments.front().number * mm_per_unit;
  is_changed_ = true;
}

void ToolState::take_stickout(double mm_per_unit) {
  if (!in_.has_numbers_alone(1) || *in_.arguments.front().number < 0) return in_.count_unknown();
  tool_.stickout_mm = *in_.arguments.front().number * mm_per_unit;
  is_changed_ = true;
}

void ToolState::take_length_words(double mm_per_unit) {
  const std::optional<double> length = number_behind(in_.arguments, "LENGTH");
  if (length.value_or(0) > 0) {
    tool_.loaded_length_mm = *length * mm_per_unit;
    is_changed_ = true;
  }
  for (const char* const word : {"ADJUST", "OSETNO"}) {
    if (const std::optional<double> number = number_behind(in_.arguments, word)) take_length_register(*number);
  }
}

void ToolState::take_length_register(double number) {
  if (number < 1 || number > kMaxRegister || !tool_.number || static_cast<int>(number) == *tool_.number) return;
  tool_.other_register = static_cast<int>(number);
  is_changed_ = true;
}

void ToolState::take_diameter_of_toolno(double mm_per_unit) {
  tool_.toolno_diameter_mm = diameter_of_toolno(in_.arguments) * mm_per_unit;
  if (!tool_.cutter && tool_.toolno_diameter_mm > 0) tool_.diameter_mm = tool_.toolno_diameter_mm;
  tool_.toolno_line = in_.line();
  is_changed_ = true;
}

void ToolState::take_name(std::string_view text) {
  set_name(name_text(text));
  is_changed_ = true;
}

void ToolState::take_name_of_number(const std::string& name) {
  tool_.name = name;
  name_use_ = NameUse::none;
  is_changed_ = true;
}

void ToolState::set_name(std::string name) {
  tool_.name = std::move(name);
  name_use_ = NameUse::until_motion;
}

void ToolState::take_insert(std::string_view text) { last_insert_ = name_text(text); }

std::optional<double> ToolState::countersink_depth(double diameter_mm) const {
  if (!tool_.cutter || !(tool_.cutter->alpha_deg > 0) || tool_.cutter->r_mm > 0 ||
      diameter_mm > tool_.cutter->d_mm + Tolerance::kFilePoint_mm)
    return std::nullopt;
  return diameter_mm / 2 * std::tan(tool_.cutter->alpha_deg * std::numbers::pi / 180);
}

void ToolState::change_number(int number) {
  uncertainties_.clear(Uncertainty::loading);
  if (tool_.number == number) return;
  is_changed_ = true;
  tool_.loaded_length_mm = 0;
  tool_.other_register.reset();
  tool_.number = number;
  // A name that the file states before the number belongs to it. Any other name is that of the tool before.
  if (std::exchange(name_use_, NameUse::none) == NameUse::none) tool_.name.clear();
  if (tool_.is_fresh) return;
  tool_.cutter.reset();
  tool_.flute_length_mm = 0;
  tool_.stickout_mm = 0;
  tool_.diameter_mm = 0;
  tool_.line = in_.line();
  auto known = index_of_number_.find({number, tool_.name});
  if (known == index_of_number_.end()) known = index_of_number_.find({number, {}});
  if (known == index_of_number_.end()) return;
  const PathTool& tool = in_.path.tools[known->second];
  const bool is_other = !tool_.name.empty() && !tool.name.empty() && tool_.name != tool.name;
  if (is_other && in_.dialect.has_named_tools) return;  // a cutter of another tool is not that of this one
  tool_.cutter = tool.cutter;
  if (tool_.name.empty()) tool_.name = tool.name;
  tool_.flute_length_mm = tool.flute_length_mm;
  tool_.diameter_mm = tool.stated_diameter_mm;
}

void ToolState::begin_block(const std::string& name) {
  if (name != tool_.name || name.empty()) {
    tool_ = {};
    tool_.name = name;
    tool_.line = in_.line();
  }
  name_use_ = name.empty() ? NameUse::none : NameUse::in_block;
  is_changed_ = true;
  is_used_ = false;
  is_loaded_ = true;
  uncertainties_.clear(Uncertainty::cutter);
  uncertainties_.clear(Uncertainty::loading);
}

// Returns whether the loaded tool's number has another cutter, which may be in the spindle or be meant for the next
// loading.
bool ToolState::is_cutter_unloaded() const {
  if (!is_loaded_ || index_ == kNone || !tool_.cutter) return false;
  const PathTool& last = in_.path.tools[index_];
  if (!last.cutter || last.number != tool_.number) return false;
  return key_of(*last.cutter) != key_of(*tool_.cutter);
}

// Adds what the file states about lengths. Of two values it keeps the smaller one, at which the holder is lower.
void ToolState::add_lengths(PathTool& tool) const {
  const auto add = [&](double& known_mm, double stated_mm) {
    const bool are_both_stated = known_mm > 0 && stated_mm > 0;
    if (are_both_stated && std::abs(known_mm - stated_mm) > Tolerance::kFilePoint_mm) tool.has_other_length = true;
    if (stated_mm > 0 && !(known_mm > 0 && known_mm < stated_mm)) known_mm = stated_mm;
  };
  add(tool.stickout_mm, tool_.stickout_mm);
  add(tool.loaded_length_mm, tool_.loaded_length_mm);
  if (tool_.other_register) tool.other_register = tool_.other_register;
}

std::size_t ToolState::find_or_add() {
  Key key;
  key.number = tool_.number;
  if (in_.dialect.has_named_tools) key.name = tool_.name;
  if (tool_.cutter) key.cutter = key_of(*tool_.cutter);
  key.diameter_mm = tool_.diameter_mm;
  std::vector<PathTool>& tools = in_.path.tools;
  const auto [it, is_new] = index_of_key_.try_emplace(std::move(key), tools.size());
  if (is_new) {
    if (tools.size() == kMaxTools) {
      in_.fail("path-tools", "more than " + std::to_string(kMaxTools) +
                                 " different tools; expected those of a machine: divide the file by operations");
      in_.give_up();
    }
    tools.push_back({tool_.number, tool_.name, tool_.cutter, tool_.flute_length_mm, tool_.line, tool_.diameter_mm});
    if (tool_.number)
      index_of_number_[{*tool_.number, {}}] = index_of_number_[{*tool_.number, tool_.name}] = it->second;
  } else {
    PathTool& tool = tools[it->second];
    if (tool.flute_length_mm <= 0) tool.flute_length_mm = tool_.flute_length_mm;
    if (!tool_.name.empty() && tool_.name != tool.name) tool.other_names.insert(tool_.name);
  }
  add_lengths(tools[it->second]);
  return it->second;
}

// Resolves the tool. Its number and cutter (in NX also the name) identify it. The same ones again are the same tool,
// and do not break the motion.
bool ToolState::resolve() {
  tool_.is_fresh = false;
  if (name_use_ == NameUse::until_motion) name_use_ = NameUse::none;
  const bool was_used = std::exchange(is_used_, true);
  if (!is_changed_) return false;
  is_changed_ = false;
  if (was_used && is_cutter_unloaded())
    uncertainties_.set(Uncertainty::loading, in_.named(Reasons::kUnloadedCutter, "CUTTER", tool_.line));
  if (tool_.cutter && tool_.toolno_diameter_mm > 0 && !is_diameter_of(*tool_.cutter, tool_.toolno_diameter_mm))
    uncertainties_.set(Uncertainty::loading, in_.named(Reasons::kUnreadTool, "TOOLNO", tool_.toolno_line));
  const bool is_known = tool_.number || tool_.cutter || (in_.dialect.has_named_tools && !tool_.name.empty());
  const std::size_t index = is_known ? find_or_add() : kNone;
  return std::exchange(index_, index) != index;
}

void ToolState::write_note() const {
  in_.report(
      Severity::note, "path-cutter-recomputed", recomputed_, "CUTTER statement",
      " with e and f other than d, r, alpha and beta give: these are taken, as CAM systems disagree about e and f");
}

namespace {

std::optional<int> whole_number(const Argument& argument) {
  if (!argument.number) return std::nullopt;
  const double value = *argument.number;
  if (std::abs(value - std::floor(value)) > 0 || std::abs(value) > std::numeric_limits<int>::max()) return std::nullopt;
  return static_cast<int>(value);
}

void change_number(States& s, int number) {
  s.tool.change_number(number);
  if (const std::string name = name_in_quotes(s.in.statement()); !name.empty()) s.tool.take_name_of_number(name);
}

}  // namespace

void take_tool_number(States& s) {
  const bool is_turning = s.in.has("TURN");
  if (is_turning) s.uncertainties.set(Uncertainty::turning, s.in.because(Reasons::kTurning));
  if (s.in.arguments.empty()) {
    s.uncertainties.set(Uncertainty::loading, s.in.because(Reasons::kUnreadTool));
    return s.in.count_unknown();
  }
  const std::optional<int> number = whole_number(s.in.arguments.front());
  if (!number) {
    return s.in.fail("path-statement", s.in.major() + ": " + quoted_text(s.in.arguments.front().text) +
                                           " is not a tool number; expected a whole number");
  }
  if (!is_turning && s.tool.number() != *number) s.uncertainties.clear(Uncertainty::turning);
  const bool is_loading = s.in.statement().word != Word::toolno;
  const bool may_be_ready_only = !is_loading && s.tool.may_be_ready_only(*number);
  change_number(s, *number);
  s.tool.take_length_words(s.frame.mm_per_unit());
  if (is_loading) s.tool.note_load();
  if (may_be_ready_only) s.uncertainties.set(Uncertainty::loading, s.in.because(Reasons::kReadyTool));
  // The number after that in LOADTL/n is a register.
  if (s.in.statement().word == Word::toolno) s.tool.take_diameter_of_toolno(s.frame.mm_per_unit());
  if (!is_loading && has_number_after_diameter(s.in.arguments)) {
    s.uncertainties.set(Uncertainty::loading, s.in.because(Reasons::kUnreadTool));
    s.in.count_unknown();
  }
}

void take_load(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  if (arguments.empty() || !equals_ignoring_case(arguments.front().text, "TOOL")) {
    if (count_numbers(arguments).count > 0) distrust(s, Word::load);
    const std::string_view what = arguments.empty() ? std::string_view() : arguments.front().text;
    if (s.in.has("WIRE")) s.uncertainties.set(Uncertainty::turning, s.in.because(Reasons::kTurning));
    if (starts_with_ignoring_case("TOOL", what) || is_one_letter_off("TOOL", what))
      s.uncertainties.set(Uncertainty::loading, s.in.because(Reasons::kUnreadTool));
    return s.in.count_unknown();
  }
  const std::optional<int> number = arguments.size() > 1 ? whole_number(arguments[1]) : std::nullopt;
  if (!number) return s.in.fail("path-statement", "LOAD/TOOL without a tool number; expected LOAD/TOOL,number");
  change_number(s, *number);
  s.tool.take_length_words(s.frame.mm_per_unit());
  s.tool.note_load();
}

}  // namespace gouge
