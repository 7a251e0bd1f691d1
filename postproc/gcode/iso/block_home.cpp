#include <cmath>

#include "postproc/gcode/iso/block_runner.h"
#include "postproc/gcode/running/program_text.h"

// Motions to places of the machine.

namespace gouge {

void BlockRunner::move_to_machine_place() {
  AxisPlace to = motion_.place();
  Vec3 machine = Vec3::Constant(kUnknownValue);
  for (int i = 0; i < 3; ++i) {
    const char letter = "XYZ"[i];
    if (words_.is_axis(letter)) machine[i] = length(letter);
  }
  const Vec3 stated = motion_.from_machine(machine);
  for (int i = 0; i < 3; ++i)
    if (words_.is_axis("XYZ"[i])) to.xyz[i] = stated[i];
  for (const char letter : {'A', 'B', 'C'}) {
    const auto rotary = motion_.mapper().rotary_of(letter);
    if (words_.is_axis(letter) && rotary) to.angles.at(*rotary) = kUnknownValue;
  }
  const bool is_rapid = index_.control().takes_rapids_to_machine_places ||
                        (modes_.motion != nullptr && modes_.motion->meaning == GcodeMeaning::rapid);
  const MoveKind kind = is_rapid ? MoveKind::rapid : MoveKind::feed;
  const bool is_incremental = modes_.is_absolute == false;
  if (is_incremental) to.xyz.setConstant(kUnknownValue);
  if (is_incremental || to.xyz.hasNaN() || !lost_.empty())
    return motion_.go_unchecked(kind, to,
                                !lost_.empty()   ? lost_
                                : is_incremental ? "G53 needs G90"
                                                 : "the place of G53 in the coordinates of the part is not known; "
                                                   "expected --offset of the work offset in force, and the length of "
                                                   "the tool");
  go_to_machine(kind, to);
}

// Moves to a place of the machine that is known.
void BlockRunner::go_to_machine(MoveKind kind, const AxisPlace& to) {
  const AxisPlace& from = motion_.place();
  int axes = 0;
  const auto stays = [](double a, double b) { return std::abs(a - b) <= 0; };
  for (int i = 0; i < 3; ++i) axes += stays(from.xyz[i], to.xyz[i]) ? 0 : 1;
  for (std::size_t k = 0; k < 2; ++k) axes += stays(from.angles.at(k), to.angles.at(k)) ? 0 : 1;
  const bool runs_apart = index_.control().goes_apart_to_machine && setup_.are_joint_rapids_straight && axes > 1;
  if (!runs_apart) return motion_.go(kind, to);
  motion_.go_unchecked(kind, to,
                       "the control runs each axis at its own rate to a place of the machine; expected one axis in a "
                       "block, or --joint-rapid-law independent");
}

void BlockRunner::go_home(const GcodeRow& row) {
  const bool is_first_home = row.number == 280;
  AxisPlace home = motion_.place();
  const Vec3 stated =
      is_first_home && setup_.home_mm ? motion_.from_machine(*setup_.home_mm) : Vec3(Vec3::Constant(kUnknownValue));
  const Target by = target();
  if (error_) return;
  for (int i = 0; i < 3; ++i)
    if (words_.is_axis("XYZ"[i]) || !words_.has_axes()) home.xyz[i] = stated[i];
  for (const char letter : {'A', 'B', 'C'}) {
    const auto rotary = motion_.mapper().rotary_of(letter);
    if (rotary && (words_.is_axis(letter) || !words_.has_axes())) home.angles.at(*rotary) = kUnknownValue;
  }
  const auto differs = [](double a, double b) { return std::abs(a - b) > 0; };
  bool has_way = false;
  for (int i = 0; i < 3; ++i) has_way = has_way || differs(by.place.xyz[i], motion_.place().xyz[i]);
  for (std::size_t k = 0; k < 2; ++k) has_way = has_way || differs(by.place.angles.at(k), motion_.place().angles.at(k));
  if (has_way && by.open.empty()) motion_.go(MoveKind::rapid, by.place);
  if (has_way && !by.open.empty()) motion_.go_unchecked(MoveKind::rapid, by.place, by.open);
  if (home.xyz.hasNaN() || std::isnan(home.angles[0] + home.angles[1]))
    return motion_.go_unchecked(MoveKind::rapid, home,
                                "the home position of the machine is not known; expected --home X,Y,Z and --offset of "
                                "the work offset in force, and of rotary joints a block that states them");
  go_to_machine(MoveKind::rapid, home);
}

// Whether and when the length comes back is chosen by parameters of the control. No manual at hand limits the end of the
// length by G28 to a motion of Z.
void BlockRunner::end_length_by(const GcodeRow& row) {
  const bool may_end = row.meaning == GcodeMeaning::home || words_.is_axis('Z');
  if (!row.cancels_length || !may_end) return;
  motion_.lose_length(code_text(row.letter, row.number) + in_line(line_) +
                      " cancels the tool length; expected G43 after it");
}

}  // namespace gouge
