#include <algorithm>
#include <cmath>

#include "tests/laws/expander_statements.h"
#include "tests/laws/expander_words.h"

// Modal states of the mutation law's own reader: unit, MULTAX, cycle, compensation, tool, frame.

namespace gouge::laws {

void StatementExpander::unit(const Arguments& arguments) {
  double mm = 0;
  for (const LooseArgument& argument : arguments) {
    const std::string& text = argument.text;
    const double stated = text == "MM" ? 1 : (text == "INCHES" || text == "INCH") ? 25.4 : 0;
    if (stated <= 0) continue;
    if (mm > 0 && std::abs(mm - stated) > 0.5) return uncertainty("units that contradict each other");
    mm = stated;
  }
  if (mm <= 0) return uncertainty("a unit that is not MM, INCH or INCHES");
  if (std::abs(mm - now_.mm) > 0.5) interrupt("another unit");
  if (now_.has_moved && !now_.is_unit_said && (mm > 1 || std::abs(mm - now_.mm) > 0.5))
    return uncertainty("a unit after positions");
  now_.mm = mm;
  now_.is_unit_said = true;
}

void StatementExpander::multax(const Arguments& arguments) {
  const std::string text = arguments.size() == 1 ? arguments.front().text : arguments.empty() ? "ON" : "?";
  if (text == "ON")
    now_.multax = Multax::on;
  else if (text == "OFF")
    now_.multax = Multax::off;
  else
    uncertainty("MULTAX of another word than ON and OFF");
}

void StatementExpander::cycle(const Arguments& arguments) {
  if (arguments.empty()) {
    now_.has_had_cycle = true;
    now_.cycle = OpenCycle{line_, std::nullopt, std::nullopt, "CYCLE without a word", 0};
    return;
  }
  const std::string& first = arguments.front().text;
  if (arguments.size() == 1 && (first == "OFF" || first == "NOMORE")) {
    if (!now_.cycle && now_.has_had_cycle && now_.positions_without_cycle > 0)
      return uncertainty("CYCLE/OFF of a cycle that never began");
    now_.is_behind_cycle = now_.cycle.has_value();
    now_.cycle.reset();
    now_.positions_without_cycle = 0;
    return;
  }
  if (arguments.size() == 1 && (first == "INIT" || first == "CLEAR")) return contradict_cycle("CYCLE/" + first);
  std::string why;
  OpenCycle open;
  open.line = line_;
  open.stated = stated_cycle(arguments, dialect_, why);
  if (!open.stated) open.contradicted = why;  // CYCLE/ON, which needs one that states what it is, among them
  now_.has_had_cycle = true;
  if (now_.cycle) open.last_hole = now_.cycle->last_hole;
  now_.cycle = open;
}

void StatementExpander::cutcom(const Arguments& arguments) {
  contradict_cycle("CUTCOM");
  bool has_side = false, is_off = false, is_length = false, is_strange = arguments.empty();
  for (const LooseArgument& argument : arguments) {
    if (argument.number) continue;
    if (argument.text == "LEFT" || argument.text == "RIGHT" || argument.text == "ON")
      has_side = true;
    else if (argument.text == "OFF")
      is_off = true;
    else if (argument.text == "LENGTH")
      is_length = true;
    else if (argument.text != "XYPLAN")
      is_strange = true;
  }
  if (now_.is_cutter_centre || (is_length && !is_off)) return;
  if (is_strange || has_side == is_off) return uncertainty("a compensation that is not understood");
  if (is_off && !now_.is_compensated && now_.was_compensated && now_.positions_without_cutcom > 0 &&
      !now_.is_cutter_centre)
    return uncertainty("CUTCOM/OFF of a compensation that never began");
  now_.is_compensated = has_side;
  now_.was_compensated = now_.was_compensated || has_side;
  now_.positions_without_cutcom = 0;
}

void StatementExpander::tool_number(std::string_view word, const Arguments& arguments) {
  const std::size_t place = word == "LOAD" ? 1 : 0;
  if (place == 1 && (arguments.empty() || arguments.front().text != "TOOL")) {
    const std::string text = arguments.empty() ? "" : arguments.front().text;
    if (text.empty() || std::string_view("TOOL").starts_with(text) || is_one_letter_away(text, "TOOL"))
      now_.tool_uncertainty = "LOAD of something like a tool";
    return;
  }
  if (arguments.size() <= place || !arguments[place].number) {
    now_.tool_uncertainty = "a tool without its number";
    return;
  }
  for (const LooseArgument& argument : arguments) {
    if (argument.text == "TURN") return uncertainty("a turning tool");
  }
  now_.tool_uncertainty.clear();
  const int number = static_cast<int>(std::lround(*arguments[place].number));
  if (now_.tool == number) return;
  interrupt(word);
  contradict_cycle("another tool");
  if (now_.at) now_.step_from = now_.at;
  if (now_.tool) now_.at.reset();
  now_.tool = number;
  now_.positions_without_cycle = now_.positions_without_cutcom = 0;
  // Its cutter may stand before the load or behind it; one that has cut already is another tool's.
  const auto known = now_.known_tools.find(number);
  if (!now_.is_cutter_new && known != now_.known_tools.end())
    now_.diameter_mm = known->second;
  else if (!now_.is_cutter_new && now_.library_tools.contains(number))
    now_.diameter_mm.reset();
  else if (!now_.is_cutter_new && now_.diameter_mm && now_.has_moved)
    now_.diameter_mm = -1;
}

void StatementExpander::cutter(const std::vector<double>& values, double diameter) {
  if (values.empty() || values.size() > 7) return uncertainty("a cutter without its numbers");
  const bool is_new = !now_.diameter_mm || std::abs(*now_.diameter_mm - diameter) > 1e-9;
  if (is_new && now_.diameter_mm && *now_.diameter_mm > 0) {
    contradict_cycle("another cutter");
    if (now_.at) now_.step_from = now_.at;
    now_.at.reset();
    now_.positions_without_cycle = now_.positions_without_cutcom = 0;
  }
  now_.diameter_mm = diameter;
  now_.is_cutter_new = true;
}

void StatementExpander::tool_data(const LooseStatement& s) {
  Arguments arguments = s.arguments;
  std::vector<double> v;
  if (s.word == "CUTTER") {
    if (is("camworks-clt") && !arguments.empty() && arguments.back().text.empty()) arguments.pop_back();
    now_.cutter_uncertainty =
        arguments.empty() || !is_all_numbers(arguments) ? "a cutter with an argument that is no number" : "";
    if (now_.cutter_uncertainty.empty() && numbers(arguments, v)) cutter(v, v.front() * now_.mm);
    return;
  }
  if (!is("nx-clsf")) return uncertainty("TLDATA");
  std::size_t words = 0;
  while (words < arguments.size() && !arguments[words].number) ++words;
  const bool is_mill = words == 1 && arguments[0].text == "MILL";
  const bool is_drill = words >= 1 && words <= 2 && arguments[0].text == "DRILL";
  arguments.erase(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(words));
  if (!is_mill && !is_drill) return uncertainty("a tool of another kind");
  if (!numbers(arguments, v)) return;
  if (v.size() < 5) return uncertainty("a tool without its numbers");
  if (now_.has_block_moved && (!now_.diameter_mm || std::abs(*now_.diameter_mm - v[0] * now_.mm) > 1e-9))
    return uncertainty("another tool within a block");
  now_.diameter_mm = v[0] * now_.mm;
  now_.is_cutter_new = true;
}

/// origin, X, Y and, where it is stated, Z.
void StatementExpander::set_frame(const std::vector<double>& v, bool is_third_said) {
  LooseFrame frame;
  frame.origin_mm = now_.mm * Vec3(v[0], v[1], v[2]);
  frame.x = Vec3(v[3], v[4], v[5]);
  frame.y = Vec3(v[6], v[7], v[8]);
  frame.z = frame.x.cross(frame.y);
  if (is_third_said && (Vec3(v[9], v[10], v[11]) - frame.z).norm() > 1e-3)
    return uncertainty("a frame that is no rotation");
  if (std::abs(frame.z.norm() - 1) > 1e-3) return uncertainty("a frame that is no rotation");
  const bool is_same = frame == now_.frame;
  if ((is("nx-clsf") || is("apt-camplete")) && now_.has_block_moved && !is_same)
    return uncertainty("a frame after positions of its block");
  if (!is_same) {
    contradict_cycle("a frame");
    now_.at.reset();
  }
  now_.frame = frame;
  if (!now_.has_block_moved) now_.axis = frame.z;
  now_.is_frame_said = true;
}

void StatementExpander::mori_frame(const Arguments& arguments) {
  // NUM,n,POINT,o,VECTOR,x,VECTOR,y
  std::vector<double> v;
  std::string words;
  for (const LooseArgument& argument : arguments) {
    if (argument.number) v.push_back(*argument.number);
    words += argument.number ? "#" : argument.text + ",";
  }
  if (words != "NUM,#POINT,###VECTOR,###VECTOR,###") return uncertainty("a frame that is not understood");
  set_frame({v.begin() + 1, v.end()}, false);
}

void StatementExpander::zeros(const Arguments& arguments, std::size_t words) {
  if (words == 0 && arguments.empty()) return uncertainty("a shift without its numbers");
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_word = words > 0 && i > 0 && !arguments[i].number;
    if (!is_word && !arguments[i].text.empty() && (!arguments[i].number || std::abs(*arguments[i].number) > 0))
      return uncertainty("a shift or a turn");
  }
}

}  // namespace gouge::laws
