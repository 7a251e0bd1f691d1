#include "postproc/gcode/heidenhain/klartext_run.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/stage.h"
#include "postproc/gcode/heidenhain/plain_statements.h"

namespace gouge {
namespace {

constexpr int kMaxRepeats = 65'534;  // input range of REP

/// Returns the name of a label at the start of a text, and shortens the text: "5" or "\"NAME\"". Empty: there is none.
std::string take_label(std::string_view& text) {
  text = trim_blanks(text);
  if (text.starts_with('"')) {
    const std::size_t close = text.find('"', 1);
    if (close == std::string_view::npos) return {};
    std::string name(text.substr(0, close + 1));
    text = trim_blanks(text.substr(close + 1));
    return name;
  }
  std::size_t length = 0;
  while (length < text.size() && is_digit(text[length])) ++length;
  const auto number = parse_integer(text.substr(0, length));
  if (!number) return {};
  text = trim_blanks(text.substr(length));
  return std::to_string(*number);
}

/// Returns whether a line certainly is a straight line and a whole block: most lines are, and need not be read to know it.
bool is_plain_line(std::string_view line) {
  while (!line.empty() && (line[0] == ' ' || line[0] == '\t' || is_digit(line[0]))) line.remove_prefix(1);
  return line.starts_with("L ") && !line.ends_with('~');
}

/// Returns whether a statement is a straight line with a coordinate: "L X+10", "L IZ-5".
bool is_line_to_place(std::string_view text) {
  if (!text.starts_with("L ")) return false;
  for (std::size_t at = text.find(' '); at != std::string_view::npos; at = text.find(' ', at + 1)) {
    std::string_view word = text.substr(at + 1);
    if (word.starts_with('I')) word.remove_prefix(1);
    const bool is_axis = !word.empty() && std::string_view("XYZABC").find(word[0]) != std::string_view::npos;
    if (is_axis && word.size() > 1 &&
        (is_digit(word[1]) || std::string_view("+-Q").find(word[1]) != std::string_view::npos))
      return true;
  }
  return false;
}

/// Compares two values. Unknown where they are so close that rounding on the control decides.
std::optional<bool> compare(int function, double a, double b) {
  constexpr double kRounding = 1e-6;
  const double apart = std::abs(a - b);
  if (!is_known(apart) || (apart > 0 && apart < kRounding)) return std::nullopt;
  switch (function) {
    case 9:
      return apart <= 0;
    case 10:
      return apart > 0;
    case 11:
      return a > b;
    default:
      return a < b;
  }
}

}  // namespace

KlartextRun::KlartextRun(const ProgramInput& input, const ProgramText& text, KlartextRunner& runner,
                         QParameters& parameters)
    : input_(input), text_(text), runner_(runner), motion_(input.motion), parameters_(parameters) {}

void KlartextRun::run_start(std::string_view blocks) {
  while (!blocks.empty()) {
    const std::size_t end = std::min(blocks.find('\n'), blocks.size());
    motion_.begin_block(0, 0);
    const KlartextBlock block = read_klartext_line(blocks.substr(0, end));
    if (!block.text.empty()) runner_.run(block, 0, false);
    blocks.remove_prefix(std::min(end + 1, blocks.size()));
  }
}

void KlartextRun::find_labels() {
  for (std::size_t i = text_.begin(); i < text_.end();) {
    if (is_plain_line(text_.line(i))) {
      ++i;
      continue;
    }
    const KlartextBlock block = read_klartext_block(text_, i);
    std::string_view text = block.text;
    if (take_keywords(text, "END PGM")) return motion_.note_run(i, i + 1);
    if (take_keywords(text, "LBL"))
      if (std::string name = take_label(text); !name.empty() && name != "0") labels_[name].push_back(i);
    i = std::max(block.next_index, i + 1);
  }
}

void KlartextRun::run() {
  find_labels();
  Stage stage(input_.progress, "reading " + input_.path.file, text_.size());
  const std::size_t most = text_.size() + kMaxRepeatedBlocks;
  next_ = text_.begin();
  for (std::size_t steps = 0; next_ < text_.end() && !runner_.has_ended() && !runner_.facts().error; ++steps) {
    stage.pass(steps);
    at_ = next_;
    motion_.begin_block(at_, text_.number(at_));
    if (steps > most) {
      runner_.lose_rest("the program runs more than " + std::to_string(kMaxRepeatedBlocks) +
                        " blocks again: a loop may have no end");
      break;
    }
    const KlartextBlock block = read_klartext_block(text_, at_);
    motion_.note_run(at_, block.next_index);
    next_ = std::max(block.next_index, at_ + 1);
    run_block(block);
  }
  if (runner_.has_ended()) read_behind_end();
}

// Another program is refused. Lines behind a label may run by a call or jump; nothing leads to those before the first one.
void KlartextRun::read_behind_end() {
  bool has_label = false;
  for (; next_ < text_.end(); ++next_) {
    const KlartextBlock block = read_klartext_block(text_, next_);
    std::string_view rest = block.text;
    has_label = has_label || take_keywords(rest, "LBL");
    if (!has_label && is_line_to_place(block.text)) runner_.note_other_program({kBlocksBehindEnd, text_.number(next_)});
    if (!take_keywords(rest, "BEGIN PGM")) continue;
    motion_.begin_block(next_, text_.number(next_));
    return runner_.run(block, text_.number(next_), false);
  }
}

void KlartextRun::run_block(const KlartextBlock& block) {
  const std::size_t line = text_.number(at_);
  if (block.is_skippable && !motion_.is_rest_unknown()) {
    const auto& is_on = input_.options.setup.is_block_delete_on;
    if (is_on == true) return;
    runner_.begin_line(line);
    if (!is_on)
      return runner_.lose_rest("a block that a switch of the control leaves out; expected --block-delete on or off");
  }
  runner_.begin_line(line);
  if (!block.error.empty()) runner_.lose_rest(block.error);
  if (!motion_.is_rest_unknown() && run_flow(block.text)) return;
  std::string_view text = block.text;
  if (!calls_.empty() && take_keywords(text, "END PGM")) lose_open_call();
  runner_.run(block, line, is_corner_next());
}

bool KlartextRun::is_corner_next() const {
  if (next_ < text_.end() && is_plain_line(text_.line(next_))) return false;
  for (std::size_t at = next_; at < text_.end();) {
    const KlartextBlock next = read_klartext_block(text_, at);
    at = std::max(next.next_index, at + 1);
    if (next.text.empty()) continue;  // a comment
    std::string_view rest = next.text;
    return take_keywords(rest, "RND") || take_keywords(rest, "CHF");
  }
  return false;
}

bool KlartextRun::run_flow(std::string_view text) {
  if (take_keywords(text, "LBL")) {
    meet_label(text);
  } else if (take_keywords(text, "CALL LBL")) {
    call_label(text);
  } else if (take_keywords(text, "FN")) {
    static constexpr std::array<std::string_view, 5> kWithoutValue = {"14", "15", "16", "20", "38"};
    std::string_view rest = text;
    for (const std::string_view number : kWithoutValue)
      if (take_keywords(rest, number)) return false;
    run_function(text);
  } else if (std::string_view rest = text; !take_parameter_name(rest).empty() && trim_blanks(rest).starts_with('=')) {
    assign(text);
  } else {
    return false;
  }
  return true;
}

void KlartextRun::meet_label(std::string_view text) {
  const std::string name = take_label(text);
  if (name.empty() || !text.empty()) return runner_.lose_rest("LBL states no label that is understood");
  if (name != "0" || calls_.empty()) return;
  next_ = calls_.back().back;
  calls_.pop_back();
  std::erase_if(repeats_, [&](const Repeat& one) { return one.depth > calls_.size(); });
}

void KlartextRun::lose_open_call() {
  runner_.lose_rest("the program ends within the subprogram of label " + calls_.back().label + "; expected LBL 0");
}

std::optional<std::size_t> KlartextRun::place_of(const std::string& label) {
  const auto found = labels_.find(label);
  if (found != labels_.end() && found->second.size() == 1) return found->second.front();
  runner_.lose_rest("no block, or more than one, has the label " + label);
  return std::nullopt;
}

void KlartextRun::call_label(std::string_view text) {
  const std::string name = take_label(text);
  if (name.empty() || name == "0") return runner_.lose_rest("CALL LBL states no label that is understood");
  const auto place = place_of(name);
  if (!place) return;
  if (text.starts_with("REP")) {
    text.remove_prefix(3);
    std::string_view rest = text;
    const std::string times = take_label(rest);
    const auto number = parse_integer(times);
    const bool is_same = rest.empty() || trim_blanks(rest) == "/" + times;
    if (!number || *number < 1 || *number > kMaxRepeats || !is_same)
      return runner_.lose_rest("the number of repeats of CALL LBL is not understood");
    return repeat(name, static_cast<int>(*number));
  }
  if (!text.empty()) return runner_.lose_rest("'" + std::string(text.substr(0, 20)) + "' has no place in CALL LBL");
  if (calls_.size() >= kMaxCalls) return runner_.lose_rest("subprograms call each other without an end");
  calls_.push_back({next_, name});
  next_ = *place;
}

// The section from the label to this block runs again so many times.
void KlartextRun::repeat(const std::string& label, int times) {
  const auto place = place_of(label);
  if (!place) return;
  if (*place > at_) return runner_.lose_rest("CALL LBL with REP stands before its label");
  auto known =
      std::ranges::find_if(repeats_, [&](const Repeat& one) { return one.at == at_ && one.depth == calls_.size(); });
  if (known == repeats_.end()) {
    repeats_.push_back({at_, calls_.size(), times});
    known = std::prev(repeats_.end());
  }
  if (known->left == 0) {
    repeats_.erase(known);
    return;
  }
  --known->left;
  next_ = *place;
}

void KlartextRun::assign(std::string_view text) {
  const std::string name = take_parameter_name(text);
  text = trim_blanks(text);
  const FormulaValue value = read_formula(text.substr(1), parameters_);
  if (!value.error.empty()) return runner_.lose_rest(value.error);
  parameters_.set(name, value.value);
}

// Source: iTNC 530 60642x-04, Q parameters: FN 0 to FN 8, FN 13, FN 18; FN 9 to FN 12 jump.
void KlartextRun::run_function(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto number = parse_integer(trim_blanks(text.substr(0, std::min(colon, text.size()))));
  constexpr long long kLastRead = 18;
  if (colon == std::string_view::npos || !number || *number > kLastRead || *number < 0)
    return runner_.lose_rest("FN of this number is not read");
  std::string_view rest = trim_blanks(text.substr(colon + 1));
  if (*number >= 9 && *number <= 12) return jump_if(static_cast<int>(*number), rest);
  if (*number == 18 && !take_keywords(rest, "SYSREAD")) return runner_.lose_rest("FN 18 has no SYSREAD");
  const std::string name = take_parameter_name(rest);
  rest = trim_blanks(rest);
  const bool is_assignment = !name.empty() && rest.starts_with('=');
  if (*number == 17 || !is_assignment) return runner_.lose_rest("FN " + std::to_string(*number) + " is not read");
  std::string formula(trim_blanks(rest.substr(1)));
  // No manual at hand states the result of these in full: values of the control, angles and lengths.
  if (*number == 18 || *number == 13 || *number == 8) {
    const bool is_read = *number == 18 ? is_value_of_control(formula, parameters_)
                                       : is_pair_of_operands(formula, *number == 13 ? "ANG" : "LEN", parameters_);
    if (!is_read) return runner_.lose_rest("FN " + std::to_string(*number) + " has words that are not read");
    return parameters_.set(name, kUnknownValue);
  }
  if (*number == 4) {
    const std::size_t divide = formula.find("DIV");
    if (divide == std::string::npos) return runner_.lose_rest("FN 4 has no DIV");
    formula.replace(divide, 3, "/");
  }
  const FormulaValue value = read_formula(formula, parameters_);
  if (!value.error.empty()) return runner_.lose_rest(value.error);
  parameters_.set(name, value.value);
}

// IF +Q1 EQU +5 GOTO LBL 3
void KlartextRun::jump_if(int number, std::string_view text) {
  static constexpr std::array<std::string_view, 4> kComparisons = {" EQU ", " NE ", " GT ", " LT "};
  const std::string_view word = kComparisons.at(static_cast<std::size_t>(number - 9));
  const std::string name = "FN " + std::to_string(number);
  if (!take_keywords(text, "IF")) return runner_.lose_rest(name + " has no IF");
  const std::size_t middle = text.find(word), jump = text.find(" GOTO LBL");
  if (middle == std::string_view::npos || jump == std::string_view::npos || jump < middle)
    return runner_.lose_rest(name + " has no comparison or no label that is understood");
  const FormulaValue a = read_operand(text.substr(0, middle), parameters_);
  const std::size_t second = middle + word.size();
  const FormulaValue b = read_operand(text.substr(second, jump - std::min(jump, second)), parameters_);
  std::string_view rest = text.substr(jump + std::string_view(" GOTO LBL").size());
  const std::string label = take_label(rest);
  if (!a.error.empty() || !b.error.empty() || label.empty() || label == "0" || !rest.empty())
    return runner_.lose_rest(name + " has a value or a label that is not understood");
  const auto holds = compare(number, a.value, b.value);
  if (!holds) return runner_.lose_rest(name + " compares values that are not known, or that rounding decides");
  if (!*holds) return;
  if (const auto place = place_of(label)) next_ = *place;
}

}  // namespace gouge
