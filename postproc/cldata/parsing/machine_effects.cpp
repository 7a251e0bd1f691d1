#include "postproc/cldata/parsing/machine_effects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

using Token = MachineToken;
using Tokens = MachineTokens;

// Returns the token without the I for a step: IX+5 of Heidenhain is a step along X.
Token without_step(const Token& t) {
  const bool is_step = t.letters.size() == 2 && (t.letters[0] == 'I' || t.letters[0] == 'i') && t.number;
  return is_step ? Token{t.letters.substr(1), t.number, t.is_glued, t.other} : t;
}

bool is_axis(const Token& t) { return is_address_of(without_step(t), "XYZUVWABC"); }

bool turns_something(const Token& t) { return is_address_of(without_step(t), "ABC") && std::abs(*t.number) > 0; }

void move(Tokens tokens, MachineEffect& effect) {
  effect.moves = true;
  effect.shifts = effect.shifts || std::ranges::any_of(tokens, turns_something);
}

bool has_meaning(Tokens codes, std::initializer_list<ControlMeaning> meanings) {
  return std::ranges::any_of(codes, [&](const Token& code) {
    const auto rows = find_control_code(static_cast<char>(code.letters[0] & ~0x20), *code.number);
    return std::ranges::any_of(
        rows, [&](const ControlCode* row) { return std::ranges::find(meanings, row->meaning) != meanings.end(); });
  });
}

// Returns whether a code uses the numbers of axes, which are then not a position to move to.
bool takes_axes(Tokens codes) { return has_meaning(codes, {ControlMeaning::shifts, ControlMeaning::shifts_with_axes}); }

// Notes a code of the group of G0 to G3. Of two codes the control may keep either.
void note_motion_code(double number, MachineEffect& effect) {
  constexpr double kLastArc = 3, kFirstThread = 32, kEndOfThreads = 34;
  if (number > kLastArc && (number < kFirstThread || number >= kEndOfThreads)) return;
  const bool is_line = !effect.motion_code && number <= 1 && std::floor(number) >= number;
  effect.motion_code = !is_line ? MotionCode::other : number > 0 ? MotionCode::straight : MotionCode::rapid;
}

// Notes a code that starts or stops the spindle. Of two codes the stop counts.
void note_spindle(double number, MachineEffect& effect) {
  constexpr auto kStarts = std::to_array<double>({3, 4, 13, 14});
  constexpr auto kStops = std::to_array<double>({5, 19});
  const auto is_code = [&](double code) { return std::abs(number - code) <= 0; };
  if (std::ranges::any_of(kStarts, is_code)) effect.stops_spindle = effect.stops_spindle.value_or(false);
  if (std::ranges::any_of(kStops, is_code)) effect.stops_spindle = true;
}

// Returns the name of an offset, with the tokens beside the code that belong to it.
std::string offset_of(const Token& code, const ControlCode& row, Tokens tokens) {
  std::string name = "G" + exact_text(*code.number);
  for (const Token& t : tokens) {
    if (is_address_of(t, row.addresses)) name += std::string(t.letters) + exact_text(*t.number);
  }
  return name;
}

// Notes whether a code smooths the path, and by which distance. Among its addresses, P of G64 and E of G187 are distances.
void note_smoothing(const ControlCode& row, Tokens tokens, MachineEffect& effect) {
  using enum ControlMeaning;
  if (row.meaning != smooths && row.meaning != blends) return;
  bool has_address = false, has_value = false;
  for (const Token& t : tokens) {
    if (!is_address_of(t, row.addresses)) continue;
    has_address = true;
    has_value = has_value || std::abs(*t.number) > 0;
    if (is_address_of(t, row.meaning == blends ? "PQ" : "E")) note_smoothing(std::abs(*t.number), effect);
  }
  effect.smooths = effect.smooths || row.meaning == blends || has_value || !has_address;
}

// Notes the plane of G17 to G19, and the level of G98 and G99.
void note_mode(const ControlCode& row, double number, MachineEffect& effect) {
  constexpr double kZx = 18, kFromStart = 98;
  if (row.meaning == ControlMeaning::plane)
    effect.plane = number < kZx ? ControlPlane::xy : number > kZx ? ControlPlane::yz : ControlPlane::zx;
  if (row.meaning == ControlMeaning::level) effect.level_at_start = number <= kFromStart;
}

}  // namespace

bool is_address_of(const Token& t, std::string_view letters) {
  return is_address(t) && letters.find(static_cast<char>(t.letters[0] & ~0x20)) != std::string_view::npos;
}

bool are_addresses(Tokens tokens) {
  return std::ranges::all_of(tokens, [](const Token& t) { return is_address(t) || is_axis(t); });
}

void take_meaning(ControlMeaning meaning, Tokens tokens, bool has_axes, MachineEffect& effect) {
  using enum ControlMeaning;
  switch (meaning) {
    case harmless:
    case smooths:  // its values decide
    case blends:
      return;
    case plane:  // its code decides
    case level:
      return;
    case centres_absolute:
    case centres_from_start:
      effect.centres_absolute = meaning == centres_absolute;
      return;
    case ends_tilt:
      effect.ends_tilt = true;
      return;
    case ends_compensation:
      effect.ends_compensation = true;
      return;
    case turns_axes:
      effect.turns_axes = true;
      return;
    case stops_spindle:
      effect.stops_spindle = true;
      return;
    case length:
      effect.changes_length = true;
      return;
    case path:
      if (has_axes) move(tokens, effect);
      return;
    case moves:
      return move(tokens, effect);
    case shifts:
      effect.shifts = true;
      return;
    case shifts_with_axes: {
      // With only an S it limits the speed of the spindle.
      const bool has_speed = std::ranges::any_of(tokens, [](const Token& t) { return is_address_of(t, "S"); });
      effect.shifts = effect.shifts || has_axes || !has_speed;
      return;
    }
    case begins_cycle:
      effect.begins_cycle = true;
      return;
    case ends_cycle:
      effect.ends_cycle = true;
      return;
    case offset:  // its code or its values name the offset
      return;
    case begins_steps:
      effect.begins_steps = true;
      return;
    case ends_steps:
      effect.begins_steps = false;
      effect.ends_steps = true;
      return;
    case inch:
      effect.unit = LengthUnit::inch;
      return;
    case mm:
      effect.unit = LengthUnit::mm;
      return;
    case changes_tool:
      effect.changes_tool = true;
      return;
    case ends_program:
      effect.ends_program = true;
      return;
  }
}

void note_smoothing(double distance, MachineEffect& effect) {
  effect.smoothing = std::max(effect.smoothing.value_or(0), distance);
}

void take_addresses(Tokens tokens, MachineEffect& effect) {
  constexpr std::string_view kAlways = "NSFTDH";
  std::vector<Token> codes;
  std::string allowed(kAlways);
  for (const Token& t : tokens) {
    if (!is_address_of(t, "GM")) continue;
    codes.push_back(t);
    const auto rows = find_control_code(static_cast<char>(t.letters[0] & ~0x20), *t.number);
    if (rows.empty()) effect.is_unknown = true;
    is_address_of(t, "G") ? note_motion_code(*t.number, effect) : note_spindle(*t.number, effect);
    for (const ControlCode* row : rows) allowed += row->addresses;
  }
  const auto is_taken = [&](const Token& t) { return is_address_of(without_step(t), allowed); };
  bool has_axes = false;
  for (const Token& t : tokens) {
    const bool is_code = is_address_of(t, "GM");
    const bool is_place = !is_code && !is_taken(t) && (is_axis(t) || (!codes.empty() && is_address_of(t, "IJK")));
    has_axes = has_axes || is_place;
    if (!is_code && !is_place && !is_taken(t)) effect.is_unknown = true;
    if (is_address_of(t, "DH") && !is_address_of(t, allowed.substr(kAlways.size()))) effect.changes_length = true;
    if (is_address_of(t, "T")) effect.changes_tool = true;
  }
  for (const Token& code : codes) {
    for (const ControlCode* row : find_control_code(static_cast<char>(code.letters[0] & ~0x20), *code.number)) {
      take_meaning(row->meaning, tokens, has_axes, effect);
      note_smoothing(*row, tokens, effect);
      note_mode(*row, *code.number, effect);
      if (row->meaning == ControlMeaning::offset) effect.work_offset = offset_of(code, *row, tokens);
    }
  }
  if (has_axes && !takes_axes(codes)) move(tokens, effect);
}

}  // namespace gouge
