#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/gcode/heidenhain/klartext_runner.h"

// Cycles: those that act where they are defined, and drilling as the motions that the control makes.

namespace gouge {
namespace {

constexpr int kDatumShift = 7, kMirror = 8, kDwell = 9, kRotation = 10, kScale = 11, kOrientation = 13,
              kWorkingPlane = 19, kTolerance = 32, kPreset = 247;

/// Returns whether a text may be the title of a cycle, in any language: letters and marks, no digits.
bool is_title(std::string_view text) {
  return std::ranges::all_of(text, [](char c) {
    const bool is_letter = is_capital(c) || static_cast<unsigned char>(c) >= 0x80;
    return is_letter || c == ' ' || c == '-' || c == '.' || c == '/';
  });
}

/// Returns whether a text is a value, or a name in any language and its value: "V.ZEIT 0.5", "ANGLE +90". An address is
/// shorter.
bool is_named_value(std::string_view text, const QParameters& parameters) {
  constexpr std::size_t kMinName = 3;
  std::size_t name = 0, shortest = text.size(), length = 0;
  for (; name < text.size() && !is_digit(text[name]) && text[name] != '+' && text[name] != '-'; ++name) {
    const bool is_parameter = text[name] == 'Q' && name + 1 < text.size() && is_digit(text[name + 1]);
    if (is_parameter) break;
    const bool ends = text[name] == ' ';
    if (ends && length > 0) shortest = std::min(shortest, length);
    length = ends ? 0 : length + 1;
  }
  if (length > 0) shortest = std::min(shortest, length);
  return (name == 0 || (name >= kMinName && shortest >= kMinName)) && is_title(text.substr(0, name)) &&
         read_operand(text.substr(name), parameters).error.empty();
}

std::optional<int> take_integer(std::string_view& text) {
  const auto length = static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  const auto number = parse_integer(text.substr(0, length));
  constexpr long long kMax = 100'000;
  if (!number || *number > kMax) return std::nullopt;
  text.remove_prefix(length);
  return static_cast<int>(*number);
}

}  // namespace

void KlartextRunner::define_cycle(std::string_view text) {
  const auto cycle = take_integer(text);
  if (!cycle) return lose_rest("CYCL DEF states no cycle");
  tangent_.reset();
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const auto step = take_integer(text);
    return step ? define_step(*cycle, *step, trim_blanks(text)) : lose_rest("CYCL DEF states no step of its cycle");
  }
  if (needs_step_) return lose_rest("CYCL DEF " + std::to_string(step_[0]) + ".0 has no values in the next block");
  step_ = {};
  define_parameters(*cycle, text);
}

// The old form: a block with .0 names the cycle, and blocks with .1 and so on have its values.
void KlartextRunner::define_step(int cycle, int step, std::string_view text) {
  const std::string name = "CYCL DEF " + std::to_string(cycle) + "." + std::to_string(step);
  static constexpr std::array<int, 8> kRead = {kDatumShift, kMirror,      kDwell,        kRotation,
                                               kScale,      kOrientation, kWorkingPlane, kTolerance};
  if (std::ranges::find(kRead, cycle) == kRead.end()) return lose_rest(name + " is a cycle that is not read");
  const bool follows = step_[0] == cycle && step_[1] + 1 == step;
  if (step > 0 && !follows) return lose_rest(name + " does not follow the step before it");
  if (step == 0 && needs_step_) return lose_rest(name + " begins where the cycle before it has no values");
  step_ = {cycle, step};
  needs_step_ = step == 0;
  if (step == 0) {
    if (!is_title(text)) return lose_rest("'" + std::string(text.substr(0, 20)) + "' is no title of a cycle");
    if (cycle == kDatumShift) frame_.begin_shift();
    return;
  }
  if (cycle == kDwell || cycle == kOrientation) {
    if (has_several_lines_ || !is_named_value(text, parameters_)) lose_rest(name + " is read with one value alone");
    return;
  }
  Words words;
  if (!read_words(text, words)) return;
  pole_.reset();
  polar_.reset();
  if (cycle == kTolerance) return define_tolerance(step, words);
  if (cycle == kDatumShift) return define_shift(words);
  if (step != 1) return lose_rest(name + " is not read");
  if (cycle == kWorkingPlane) return define_working_plane(words);
  if (cycle == kMirror)
    define_mirror(words);
  else
    define_value(cycle, words);
  settle_frame();
}

void KlartextRunner::define_value(int cycle, const Words& words) {
  const bool is_rotation = cycle == kRotation,
             is_number = words.size() == 1 && words[0].kind == KlartextWord::Kind::number;
  const std::string_view value = is_rotation ? "ROT" : "SCL";
  const bool is_step = is_number && is_rotation && words[0].name == "IROT";
  if (!is_number || (words[0].name != value && !is_step))
    return lose_rest("CYCL DEF " + std::to_string(cycle) + ".1 needs " + std::string(value));
  if (!is_rotation) return frame_.scale(words[0].value);
  if (!is_step && frame_.is_rotated_by(words[0].value)) return;  // a reset where nothing is turned
  frame_.rotate(words[0].value, is_step);
  rotation_line_ = line_;
}

void KlartextRunner::define_mirror(const Words& words) {
  std::array<bool, 2> axes{};
  for (const KlartextWord& word : words) {
    const bool is_read = word.is("X") || word.is("Y");
    if (!is_read || std::exchange(axes.at(word.name == "X" ? 0 : 1), true))
      return lose_rest("CYCL DEF 8.1 is read with X and Y alone, each once");
  }
  frame_.mirror(axes[0], axes[1]);
}

// Source: TNC 320 340 55x-04, p. 258: spatial angles, or positions of the rotary axes, as the machine states.
void KlartextRunner::define_working_plane(const Words& words) {
  std::array<std::optional<double>, 3> stated;
  for (const KlartextWord& word : words) {
    const std::size_t axis =
        word.name.size() == 1 ? std::string_view("ABC").find(word.name[0]) : std::string_view::npos;
    const bool is_angle = word.kind == KlartextWord::Kind::number && axis != std::string_view::npos;
    if (!is_angle || std::exchange(stated.at(axis), word.value))
      return lose_rest("CYCL DEF 19.1 is read with A, B and C alone, each once");
  }
  const bool is_zero = std::ranges::all_of(stated, [](const auto& angle) { return std::abs(angle.value_or(0)) <= 0; });
  if (is_zero) return end_tilt("STAY");
  const bool is_whole = std::ranges::all_of(stated, [](const auto& angle) { return angle && is_known(*angle); });
  const std::string open = !is_whole ? "cycle 19 does not state A, B and C"
                           : !are_cycle_angles_spatial_
                               ? "the machine states whether the angles of cycle 19 are spatial or of the rotary axes; "
                                 "expected PLANE SPATIAL, or --start \"CYCL DEF 19 SPATIAL\""
                               : "";
  tilt(open, Vec3(stated[0].value_or(0), stated[1].value_or(0), stated[2].value_or(0)), "STAY");
}

// Source: TNC 407 280 580, Cycle 7: absolute values refer to the datum, steps to the shift in force.
void KlartextRunner::define_shift(const Words& words) {
  for (const KlartextWord& word : words) {
    const bool is_step = word.name.size() == 2 && word.name[0] == 'I';
    const std::size_t axis = std::string_view("XYZ").find(is_step             ? word.name[1]
                                                          : word.name.empty() ? '?'
                                                                              : word.name[0]);
    const bool is_axis = word.name.size() == (is_step ? 2 : 1) && axis != std::string_view::npos;
    if (!is_axis || word.kind != KlartextWord::Kind::number)
      return lose_rest("'" + word_text(word) + "' has no place in CYCL DEF 7");
    if (frame_.has_shifted(axis)) return lose_rest("CYCL DEF 7 states an axis twice");
    frame_.shift(axis, length(word.value), is_step);
  }
}

// Source: TNC 640 34059x-05, cycle 32: T of the contour, HSC-MODE, TA of rotary axes.
void KlartextRunner::define_tolerance(int step, const Words& words) {
  const auto exceeds = [&](double stated, std::optional<double> covered) { return !(stated <= covered.value_or(0)); };
  const auto turn_reason = [&](const std::string& by) {
    return "cycle 32" + in_line(line_) + " lets rotary axes leave their path by " + by + "; expected --axis-tolerance";
  };
  if (step == 1) {
    if (words.size() > 1 || (words.size() == 1 && !words[0].has_number("T"))) return lose_rest("CYCL DEF 32.1 needs T");
    const double stated = words.empty() ? kUnknownValue : length(words[0].value);
    tolerance_open_.clear();
    if (exceeds(stated, setup_.tip_tolerance_mm))
      tolerance_open_ = "cycle 32" + in_line(line_) + " lets the tool leave its path by " +
                        (is_known(stated) ? display_text(stated, 4) + " mm" : "an unknown distance") +
                        "; expected --tip-tolerance";
    // Without TA a parameter of the machine states the tolerance of its rotary axes.
    motion_.doubt_turns(setup_.axis_tolerance_rad ? "" : turn_reason("an unknown angle"));
    return settle_path();
  }
  if (step != 2) return lose_rest("CYCL DEF 32." + std::to_string(step) + " is not read");
  for (const KlartextWord& word : words) {
    const bool is_angle = word.has_number("TA"), is_mode = word.name == "HSC" || word.name == "MODE";
    if (!is_angle && !is_mode) return lose_rest("'" + word_text(word) + "' has no place in CYCL DEF 32.2");
    if (!is_angle || !motion_.mapper().has_machine()) continue;
    constexpr double kRounding = 1 + Tolerance::kSingleSum;
    const bool is_covered =
        setup_.axis_tolerance_rad && word.value * kDegree_rad <= *setup_.axis_tolerance_rad * kRounding;
    motion_.doubt_turns({});
    if (!is_covered && tolerance_open_.empty()) tolerance_open_ = turn_reason(display_text(word.value, 4) + " degrees");
  }
  settle_path();
}

// The form with Q parameters, whose values stay in force as parameters.
void KlartextRunner::define_parameters(int cycle, std::string_view text) {
  const std::string name = "CYCL DEF " + std::to_string(cycle);
  const KlartextCycle* const row = find_klartext_cycle(cycle);
  if (row == nullptr && cycle != kPreset) return lose_rest(name + " is a cycle that is not read");
  // The title stands before the first parameter.
  std::size_t begin = text.find('Q');
  while (begin != std::string_view::npos && (begin + 1 >= text.size() || !is_digit(text[begin + 1])))
    begin = text.find('Q', begin + 1);
  if (begin == std::string_view::npos) return lose_rest(name + " has no parameters");
  if (!is_title(text.substr(0, begin))) return lose_rest(name + " has a title that is not understood");
  std::map<int, double> values;
  std::string_view rest = text.substr(begin);
  while (!rest.empty()) {
    std::string_view after = rest;
    const std::string parameter = take_parameter_name(after);
    after = trim_blanks(after);
    if (parameter.empty() || !after.starts_with('=')) return lose_rest(name + " has a value that is not understood");
    after = trim_blanks(after.substr(1));
    const std::size_t end = std::min(after.find(' '), after.size());
    const FormulaValue value = read_operand(after.substr(0, end), parameters_);
    if (!value.error.empty()) return lose_rest(name + ": " + value.error);
    const auto number = parse_integer(std::string_view(parameter).substr(1));
    if (!number || !values.emplace(static_cast<int>(*number), value.value).second)
      return lose_rest(name + " states " + parameter + " twice");
    rest = trim_blanks(after.substr(end));
  }
  for (const auto& [number, value] : values) parameters_.set("Q" + std::to_string(number), value);
  if (row != nullptr) {
    cycle_ = {row, std::move(values)};
    return;
  }
  const auto found = values.find(339);
  const bool is_whole = found != values.end() && values.size() == 1 && found->second >= 0 && found->second < 1e6 &&
                        std::abs(found->second - std::round(found->second)) <= 0;
  if (!is_whole) return lose_rest("CYCL DEF 247 needs Q339, the number of a preset");
  choose_preset(static_cast<int>(found->second));
}

// Source: cycle 247: a new preset resets the datum shift, mirror image, rotation and scale.
void KlartextRunner::choose_preset(std::optional<int> number) {
  has_preset_ = true;
  if (number && facts_.offset_line == 0) facts_.offset_line = line_;
  if (number) {
    if (has_tilt_) return lose_rest("CYCL DEF 247 in a tilted plane is not read");
    frame_.reset();
    pole_.reset();
    settle_frame();
  }
  motion_.choose_offset("PRESET" + (number ? std::to_string(*number) : ""));
}

void KlartextRunner::call_cycle(std::string_view text) {
  PathWords words;
  if (text.starts_with("POS") || text.starts_with("PAT"))
    return lose_rest("CYCL CALL " + std::string(text.substr(0, 3)) + " is not read");
  if (!take_words(text, {}, words)) return;
  begin_motion(words);
  drill();
  end_motion(words);
}

std::string KlartextRunner::why_not_drilled() const {
  if (cycle_.row == nullptr) return "no cycle is defined that can be called";
  if (motion_.tip_control() != TipControl::off) return "a cycle under tool centre point control";
  const std::map<int, double>& q = cycle_.parameters;
  const auto is_stated = [&](int number) { return q.contains(number) && is_known(q.at(number)); };
  const std::string name = "cycle " + std::to_string(cycle_.row->number);
  for (const int needed : {200, 201, 203, 204})
    if (!is_stated(needed)) return name + " does not state Q" + std::to_string(needed);
  for (const auto& [number, value] : q)
    if (is_known(value) && std::abs(parameters_.value("Q" + std::to_string(number)) - value) > 0)
      return name + ": Q" + std::to_string(number) + " has changed since its definition";
  if (cycle_.row->form == KlartextDrilling::not_checked) return name + ": " + std::string(cycle_.row->note);
  const int zero = cycle_.row->zero_parameter;
  const bool is_other = zero > 0 && (q.contains(zero) ? !(std::abs(q.at(zero)) <= 0) : cycle_.row->needs_zero);
  if (is_other) return name + " is read with Q" + std::to_string(zero) + "=0 alone";
  if (!(q.at(200) >= 0) || !(q.at(201) < 0)) return name + " has no depth below its clearance";
  const bool has_low_clearance = q.at(204) < q.at(200) && std::abs(q.at(204)) > 0;
  if (has_low_clearance) return name + " has a second clearance below the first";
  return {};
}

// Source: iTNC 530 and TNC 640, cycles 200 to 209 and 240: to the clearance, in by feed, back, to the second clearance.
void KlartextRunner::drill() {
  const std::string open = why_not_drilled();
  Target at{motion_.place(), {}};
  if (!open.empty()) {
    at.place.xyz.setConstant(kUnknownValue);
    return run_unchecked(MoveKind::feed, at, open);
  }
  at.place.xyz = place();
  const std::map<int, double>& q = cycle_.parameters;
  const double surface = length(q.at(203)), clearance = surface + length(q.at(200));
  const auto go_to = [&](MoveKind kind, double level) {
    at.place.xyz.z() = level;
    run_line(kind, at);
  };
  const auto feed = q.find(206);
  if (feed != q.end() && feed->second > 0 && unit_ == LengthUnit::mm)
    motion_.set_feed({feed->second, FeedUnit::per_minute});
  constexpr int kTapping = 206, kRigidTapping = 207;
  if (cycle_.row->number == kTapping || cycle_.row->number == kRigidTapping) motion_.stop_spindle(false);
  go_to(MoveKind::rapid, clearance);
  go_to(MoveKind::feed, surface + length(q.at(201)));
  go_to(cycle_.row->form == KlartextDrilling::feed_out ? MoveKind::feed : MoveKind::rapid, clearance);
  if (q.at(204) > q.at(200)) go_to(MoveKind::rapid, surface + length(q.at(204)));
  set_feed();
}

}  // namespace gouge
