#include <cmath>
#include <limits>
#include <string>

#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

// Tools, and which of them is loaded.

namespace gouge {
namespace {

std::optional<int> whole_number(const Argument& argument) {
  if (!argument.number) return std::nullopt;
  const double value = *argument.number;
  if (std::abs(value - std::floor(value)) > 0 || std::abs(value) > std::numeric_limits<int>::max()) return std::nullopt;
  return static_cast<int>(value);
}

void change_number(States& s, int number) {
  s.tool.change_number(number);
  s.chain.note_loading();
}

}  // namespace

void take_tool_number(States& s) {
  const bool is_turning = s.in.has("TURN");
  if (is_turning) s.doubts.set(Doubt::turning, s.in.because(Reasons::kTurning));
  if (s.in.arguments.empty()) {
    s.doubts.set(Doubt::loading, s.in.because(Reasons::kUnreadTool));
    return s.in.count_unknown();
  }
  const std::optional<int> number = whole_number(s.in.arguments.front());
  if (!number) {
    return s.in.fail("path-statement", s.in.major() + ": " + quoted_text(s.in.arguments.front().text) +
                                           " is not a tool number; expected a whole number");
  }
  if (!is_turning && s.tool.number() != *number) s.doubts.clear(Doubt::turning);
  const bool is_loading = s.in.statement().word != Word::toolno;
  const bool may_be_ready_only = !is_loading && s.tool.may_be_ready_only(*number);
  change_number(s, *number);
  if (is_loading) s.tool.note_load();
  if (may_be_ready_only) s.doubts.set(Doubt::loading, s.in.because(Reasons::kReadyTool));
  // Behind LOADTL/n stands a register.
  if (s.in.statement().word == Word::toolno) s.tool.take_diameter_of_toolno(s.frame.mm_per_unit());
}

void take_load(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  if (arguments.empty() || !equals_ignoring_case(arguments.front().text, "TOOL")) {
    if (count_numbers(arguments).count > 0) distrust(s, Word::load);
    const std::string_view what = arguments.empty() ? std::string_view() : arguments.front().text;
    if (s.in.has("WIRE")) s.doubts.set(Doubt::turning, s.in.because(Reasons::kTurning));
    if (starts_with_ignoring_case("TOOL", what) || is_one_letter_off("TOOL", what))
      s.doubts.set(Doubt::loading, s.in.because(Reasons::kUnreadTool));
    return s.in.count_unknown();
  }
  const std::optional<int> number = arguments.size() > 1 ? whole_number(arguments[1]) : std::nullopt;
  if (!number) return s.in.fail("path-statement", "LOAD/TOOL without a tool number; expected LOAD/TOOL,number");
  change_number(s, *number);
  s.tool.note_load();
}

}  // namespace gouge
