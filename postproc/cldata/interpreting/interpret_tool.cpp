#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/cutter_statement.h"

namespace gouge {
namespace {

constexpr std::size_t kCuttersTold = 20;
constexpr std::size_t kMostTools = 10000;  // a machine has hundreds
constexpr std::array<std::string_view, 5> kTurningTypes = {"TURN", "GROOVE", "THREAD", "WEDM", "WIRE"};

bool equal(double a, double b) {
  return !(a < b) && !(b < a);
}

std::optional<int> whole_number(const Argument& argument) {
  if (!argument.number) return std::nullopt;
  const double value = *argument.number;
  if (!equal(value, std::floor(value)) || std::abs(value) > std::numeric_limits<int>::max())
    return std::nullopt;
  return static_cast<int>(value);
}

// TOOLNO/n,d and TOOLNO/n,MILL,..,..,d of CATIA; 0 where no diameter stands there.
double diameter_of_toolno(const std::vector<Argument>& arguments) {
  constexpr std::size_t kOfMill = 4;
  if (arguments.size() == 2) return arguments[1].number.value_or(0);
  const bool is_mill = arguments.size() > kOfMill && equals_ignoring_case(arguments[1].text, "MILL");
  return is_mill ? arguments[kOfMill].number.value_or(0) : 0;
}

}  // namespace

void Interpreter::set_cutter(const CutterStatement& cutter, double flute_length_mm) {
  tool_.cutter = cutter;
  tool_.flute_length_mm = flute_length_mm;
  tool_.line = statement_->line;
  tool_.is_fresh = true;
  is_tool_changed_ = true;
}

void Interpreter::take_cutter() {
  cutter_reason_ = nullptr;
  CutterOutcome outcome = make_cutter(arguments_, mm_per_unit_, dialect_.has_tip_diameter);
  if (outcome.is_recomputed) cutters_recomputed_.add(statement_->line);
  if (!outcome.error.empty()) {
    const Argument* word = find_word_argument(arguments_);
    if (word != nullptr && path_.moves.empty() && !word->text.empty() && word->text[0] >= 'A') {
      return refuse_part_program(std::string(statement_->major) + "/" + std::string(word->text));
    }
    return fail("path-cutter", "CUTTER: " + outcome.error + "; expected d or d,r or d,r,e,f,alpha,beta,h");
  }
  if (previous_word_ == Word::insert) tool_.name = last_insert_;
  if (outcome.cutter) return set_cutter(*outcome.cutter, outcome.flute_length_mm);
  tool_.cutter.reset();
  is_tool_changed_ = true;
  note_no_cutter(outcome.note);
}

// Only the diameter is written: a flat, a ball and a bull-nose cutter look the same, so it defines no tool, but a
// library's tool can be held against it.
void Interpreter::take_creo_cutter(std::string_view text) {
  Statement values;
  values.pieces.push_back(text);
  split_arguments(values, arguments_);
  const bool is_number = arguments_.size() == 1 && arguments_.front().number && *arguments_.front().number > 0;
  tool_.diameter_mm = is_number ? *arguments_.front().number * mm_per_unit_ : 0;
  tool_.name = "diameter " + name_text(text);
  tool_.line = statement_->line;
  tool_.is_fresh = true;
  is_tool_changed_ = true;
}

void Interpreter::note_no_cutter(const std::string& note) {
  if (cutters_without_tool_++ >= kCuttersTold) return;
  path_.notes.push_back(make_warning("path-cutter", note, path_.file, statement_->line));
}

void Interpreter::take_tldata() {
  if (arguments_.empty()) return count_unknown();
  cutter_reason_ = nullptr;
  const std::string_view type = arguments_.front().text;
  const bool is_drill = equals_ignoring_case(type, "DRILL");
  tool_.cutter.reset();
  is_tool_changed_ = true;
  const bool is_turning = std::any_of(kTurningTypes.begin(), kTurningTypes.end(),
                                      [&](std::string_view t) { return equals_ignoring_case(type, t); });
  if (is_turning) {
    turning_reason_ = because(Reasons::kTurning);
    return;
  }
  turning_reason_ = nullptr;
  if (!is_drill && !equals_ignoring_case(type, "MILL"))
    return note_no_cutter("TLDATA/" + name_text(type) +
                          " is not understood: define the tool in the tool library");
  std::span<const Argument> numbers(arguments_);
  numbers = numbers.subspan(1);
  if (is_drill && !numbers.empty() && !numbers.front().number) numbers = numbers.subspan(1);
  const CutterOutcome outcome = make_tldata_cutter(numbers, is_drill, mm_per_unit_);
  if (!outcome.error.empty()) {
    return fail("path-cutter",
                "TLDATA: " + outcome.error +
                    (is_drill ? "; expected DRILL,MILL,diameter,radius,length,point angle,flute length"
                              : "; expected MILL,diameter,radius,length,taper angle,tip angle"));
  }
  if (outcome.cutter) return set_cutter(*outcome.cutter, outcome.flute_length_mm);
  note_no_cutter(outcome.note);
}

void Interpreter::take_tool_number() {
  const bool is_turning = has_argument(arguments_, "TURN");
  if (is_turning) turning_reason_ = because(Reasons::kTurning);
  if (arguments_.empty()) {
    loading_reason_ = because(Reasons::kUnreadTool);
    return count_unknown();
  }
  const std::optional<int> number = whole_number(arguments_.front());
  if (!number) {
    return fail("path-statement", std::string(statement_->major) + ": " +
                                      quoted_text(arguments_.front().text) +
                                      " is not a tool number; expected a whole number");
  }
  if (!is_turning && tool_.number != *number) turning_reason_ = nullptr;
  change_number(*number);
  if (statement_->word != Word::toolno) return;  // behind LOADTL/n stands a register
  tool_.toolno_diameter_mm = diameter_of_toolno(arguments_) * mm_per_unit_;
  tool_.toolno_line = statement_->line;
  is_tool_changed_ = true;
}

void Interpreter::take_load() {
  if (arguments_.empty() || !equals_ignoring_case(arguments_.front().text, "TOOL")) {
    if (count_numbers(arguments_).count > 0) distrust(Word::load);
    const std::string_view what = arguments_.empty() ? std::string_view() : arguments_.front().text;
    if (has_argument(arguments_, "WIRE")) turning_reason_ = because(Reasons::kTurning);
    if (starts_with_ignoring_case("TOOL", what) || is_one_letter_off("TOOL", what))
      loading_reason_ = because(Reasons::kUnreadTool);
    return count_unknown();
  }
  const std::optional<int> number = arguments_.size() > 1 ? whole_number(arguments_[1]) : std::nullopt;
  if (!number) return fail("path-statement", "LOAD/TOOL without a tool number; expected LOAD/TOOL,number");
  change_number(*number);
}

// A tool that was not described since the last motion is the one last seen under that number, or one the file
// says nothing about: never the one before it.
void Interpreter::change_number(int number) {
  loading_reason_ = nullptr;
  was_loaded_ = true;
  if (tool_.number == number) return;
  is_tool_changed_ = true;
  tool_.number = number;
  if (tool_.is_fresh) return;
  tool_.cutter.reset();
  tool_.name.clear();
  tool_.flute_length_mm = 0;
  tool_.diameter_mm = 0;
  tool_.line = statement_->line;
  const auto known = tool_of_number_.find(number);
  if (known == tool_of_number_.end()) return;
  const PathTool& tool = path_.tools[known->second];
  tool_.cutter = tool.cutter;
  tool_.name = tool.name;
  tool_.flute_length_mm = tool.flute_length_mm;
  tool_.diameter_mm = tool.stated_diameter_mm;
}

void Interpreter::take_flute_length() {
  if (arguments_.size() != 1 || !arguments_.front().number || *arguments_.front().number < 0)
    return count_unknown();
  tool_.flute_length_mm = *arguments_.front().number * mm_per_unit_;
  is_tool_changed_ = true;
}

void Interpreter::take_tool_name(std::string_view text) {
  tool_.name = name_text(text);
  is_tool_changed_ = true;
}

std::size_t Interpreter::find_or_add_tool() {
  ToolKey key;
  key.number = tool_.number;
  if (dialect_.has_named_tools) key.name = tool_.name;
  if (tool_.cutter) {
    const CutterStatement& c = *tool_.cutter;
    key.cutter = {c.d_mm, c.r_mm, c.e_mm, c.f_mm, c.alpha_deg, c.beta_deg, c.h_mm};
  }
  key.diameter_mm = tool_.diameter_mm;
  const auto [it, is_new] = tool_of_key_.try_emplace(std::move(key), path_.tools.size());
  if (is_new) {
    if (path_.tools.size() == kMostTools) {
      fail("path-tools", "more than " + std::to_string(kMostTools) +
                             " different tools; expected those of a machine: divide the file by operations");
      is_hopeless_ = true;
    }
    path_.tools.push_back({tool_.number, tool_.name, tool_.cutter, tool_.flute_length_mm, tool_.line, tool_.diameter_mm});
    if (tool_.number) tool_of_number_[*tool_.number] = it->second;
  } else if (path_.tools[it->second].flute_length_mm <= 0) {
    path_.tools[it->second].flute_length_mm = tool_.flute_length_mm;
  }
  return it->second;
}

// Number and cutter (NX: and name) make a tool; the same ones again are the same tool and no break of the
// motion.
void Interpreter::resolve_tool() {
  tool_.is_fresh = false;
  if (!is_tool_changed_) return;
  is_tool_changed_ = false;
  constexpr double kSameDiameter = 0.01;  // of it: files round them
  if (tool_.cutter && tool_.toolno_diameter_mm > 0 &&
      std::abs(tool_.cutter->d_mm / tool_.toolno_diameter_mm - 1) > kSameDiameter)
    loading_reason_ = reasons_.name(Reasons::kUnreadTool, "TOOLNO", tool_.toolno_line);
  const bool is_known =
      tool_.number || tool_.cutter || (dialect_.has_named_tools && !tool_.name.empty());
  const std::size_t index = is_known ? find_or_add_tool() : kNone;
  if (index == tool_index_) return;
  if (tool_index_ == kNone && was_from_) {
    path_.moves.back().tool = index;  // FROM says where the first tool stands
  } else {
    const std::optional<ArcStatement> arc = arc_;
    break_motion();
    arc_ = arc;
  }
  tool_index_ = index;
  if (!cycle_.is_on) cycle_.drill.reset();  // CYCLE/ON takes up no cycle of another tool
}

void Interpreter::name_operation(std::string name) {
  operation_name_ = std::move(name);
  operation_line_ = statement_->line;
  is_operation_new_ = true;
}

void Interpreter::resolve_operation() {
  if (!is_operation_new_) return;
  is_operation_new_ = false;
  operation_index_ = path_.operations.size();
  make_room(path_.operations);
  path_.operations.push_back({operation_name_, operation_line_});
}

}  // namespace gouge
