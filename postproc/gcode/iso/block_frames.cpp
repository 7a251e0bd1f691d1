#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "postproc/gcode/iso/block_runner.h"
#include "postproc/gcode/running/program_text.h"

// Tool lengths, tool centre point control, work offsets and tilted frames.

namespace gouge {
namespace {

using Code = GcodeMeaning;

/// Rotation of a tilted frame by the angles of Euler: about Z, about the new X, about the new Z. Degrees.
Eigen::Matrix3d euler_rotation(double about_z, double about_x, double about_new_z) {
  const auto turn = [](double degrees, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees * kDegree_rad, axis).toRotationMatrix();
  };
  return turn(about_z, Vec3::UnitZ()) * turn(about_x, Vec3::UnitX()) * turn(about_new_z, Vec3::UnitZ());
}

}  // namespace

bool BlockRunner::states_place_of_z() const {
  const bool is_in_force = modes_.motion != nullptr && words_.row_of(ModalGroup::motion) == nullptr &&
                           words_.row_of(ModalGroup::cycle_end) == nullptr;
  const bool is_cycle = words_.row_of(Code::cycle) != nullptr || (is_in_force && modes_.motion->meaning == Code::cycle);
  return words_.is_axis('Z') && modes_.is_absolute == true && !is_cycle;
}

// Source: Fanuc, parameter 5006#6: a code of length shifts the coordinates, or moves the axis by the change of the length.
void BlockRunner::take_lengths() {
  const GcodeRow* const of_length = words_.row_of(ModalGroup::length);
  const bool was_known = is_known(motion_.place().xyz.z());
  const bool was_doubtful = motion_.has_doubt(ProgramDoubt::length);
  const auto before = motion_.applied_length();
  for (const GcodeRow* row : words_.rows()) take_length(*row);
  const std::string_view parameter = index_.control().length_motion;
  if (error_ || of_length == nullptr || parameter.empty() || !was_known || states_place_of_z()) return;
  const auto after = motion_.applied_length();
  const bool is_certain = before && after && !was_doubtful && !motion_.has_doubt(ProgramDoubt::length);
  if (is_certain && before == after) return;
  AxisPlace to = motion_.place();
  to.xyz.z() = kUnknownValue;
  motion_.go_unchecked(MoveKind::rapid, to,
                       std::string(parameter) + " states whether " + code_text(of_length->letter, of_length->number) +
                           in_line(line_) + " moves Z; expected an absolute Z in its block");
}

void BlockRunner::take_length(const GcodeRow& row) {
  const bool is_of_length_group = row.group == ModalGroup::length;
  const auto h = words_.integer('H');
  switch (row.meaning) {
    case Code::length_on:
    case Code::tip_control_on:
      if (row.meaning == Code::tip_control_on && !motion_.mapper().has_machine()) {
        error_ = make_error("gcode-machine",
                            code_text(row.letter, row.number) + " begins tool centre point control; expected --machine",
                            path_.file, line_);
        return;
      }
      motion_.end_doubt(ProgramDoubt::length);
      if (is_of_length_group) {
        if (!h && (words_.has('H') || !index_.control().has_default_length))
          return motion_.doubt(ProgramDoubt::length,
                               code_text(row.letter, row.number) + in_line(line_) + " has no H that states its length");
        motion_.apply_length(h);
      }
      if (row.meaning == Code::tip_control_on)
        begin_tip_control(row);
      else if (motion_.tip_control() == TipControl::on && index_.has_tip_control_of(ModalGroup::length))
        motion_.set_tip_control(TipControl::off);
      break;
    case Code::length_off:
      motion_.end_doubt(ProgramDoubt::length);
      if (motion_.tip_control() == TipControl::turned_offset)
        motion_.set_tip_control(TipControl::unknown);
      else if (index_.has_tip_control_of(ModalGroup::length)) {
        motion_.end_doubt(ProgramDoubt::tip_control);
        motion_.set_tip_control(TipControl::off);
      }
      motion_.cancel_length();
      break;
    case Code::tip_control_off:
      motion_.end_doubt(ProgramDoubt::tip_control);
      motion_.set_tip_control(TipControl::off);
      break;
    case Code::turned_offset_on:
      if (!motion_.mapper().has_machine())
        motion_.doubt(ProgramDoubt::tip_control,
                      code_text(row.letter, row.number) + in_line(line_) +
                          " shifts positions by the places of the rotary joints; expected --machine, and a block that "
                          "states them");
      motion_.set_tip_control(motion_.tip_control() == TipControl::off ? TipControl::turned_offset
                                                                       : TipControl::unknown);
      break;
    case Code::turned_offset_off:
      if (!motion_.mapper().has_machine()) motion_.end_doubt(ProgramDoubt::tip_control);
      end_tip_control(row);
      break;
    default:
      break;
  }
}

// Source: Fanuc A-79294E, p.2 and 3: P1 turns the tool axis on the plane of its ends, P0 moves the rotary axes on their own.
void BlockRunner::begin_tip_control(const GcodeRow& row) {
  motion_.set_tip_control(TipControl::on);
  motion_.end_doubt(ProgramDoubt::tip_control);
  const std::string code = code_text(row.letter, row.number) + in_line(line_);
  if (!words_.has('P')) return;
  const auto p = words_.integer('P');
  const bool covers_both = setup_.feed_law == TurnLaw::documented || setup_.feed_law == TurnLaw::any;
  const bool is_covered =
      (p == 0 && setup_.feed_law != TurnLaw::vector) || (p == 1 && setup_.feed_law == TurnLaw::vector);
  if (!covers_both && !is_covered)
    motion_.doubt(ProgramDoubt::tip_control, code + " chooses another law of motion than that of the check; expected " +
                                                 (p == 1 ? "--feed-law vector" : "--feed-law documented or any"));
}

// Returns the angle of a joint at the end of the block, before its words are taken. Not a number: it is not known.
double BlockRunner::angle_of_block(std::size_t rotary) {
  const double before = motion_.place().angles.at(rotary);
  for (const char letter : {'A', 'B', 'C'}) {
    if (!words_.is_axis(letter) || motion_.mapper().rotary_of(letter) != rotary) continue;
    const double degrees = number(letter, StepRounding::kIncrement_deg);
    return modes_.is_absolute.value_or(true) ? motion_.angle_from_program(rotary, degrees)
                                             : before + degrees * kDegree_rad;
  }
  return before;
}

// Chooses the coordinates that turn with the table. Returns why they are not known; empty: they are. Source: Fanuc A-79348E,
// p.19: they are those of the work offset when G43.4 is called, and what turned before or turns in its block is their initial
// state. Programs also state them with the table at 0, and a control may have been set to that.
std::string BlockRunner::take_frame_at_call() {
  const bool is_at_zero = index_.control().has_tip_frame_of_table || setup_.tip_frame == TipFrame::table_at_zero;
  RotaryAngles frame{0, 0};
  for (std::size_t k = 0; k < 2 && !is_at_zero; ++k) {
    const Joint& joint = setup_.machine->joints[setup_.machine->rotary.at(k)];
    if (joint.side != JointSide::table) continue;
    const double before = motion_.place().angles.at(k), after = angle_of_block(k);
    const auto is_off = [](double angle) { return is_known(angle) && std::abs(angle) > Tolerance::kExactDirection; };
    const bool is_stated_twice = is_known(before) && is_known(after);
    if (setup_.tip_frame == TipFrame::table && (is_off(before) || is_off(after)))
      return " begins while joint " + joint.name +
             " is not at 0, and a control may take coordinates with the table at 0 or as it stands; expected --tip-frame "
             "table-at-zero or table-at-call";
    if (!is_known(after)) return ": " + motion_.mapper().unknown_angles();
    if (setup_.tip_frame == TipFrame::table_at_call && is_stated_twice && std::abs(after - before) > 0)
      return " turns joint " + joint.name + " in its own block; expected it in a block before";
    frame.at(k) = setup_.tip_frame == TipFrame::table_at_call ? after : 0;
  }
  motion_.set_tip_frame(frame);
  if (is_at_zero && motion_.has_turned_offset() && !index_.control().shifts_words_of_joints)
    return ": the work offset turns a rotary joint, and no manual at hand states what it does to coordinates that turn with "
           "the table";
  return {};
}

// Settles the coordinates that tool centre point control follows, after a code that begins it (a call) or that chooses a work
// offset. Source: Fanuc A-79348E: parameter 19696#5 (WKP) states whether they turn with the table.
void BlockRunner::settle_tip_frame(const GcodeRow& row, bool is_call) {
  if (motion_.tip_control() != TipControl::on || !motion_.mapper().has_machine()) return;
  const bool turns_table = std::ranges::any_of(
      setup_.machine->rotary, [&](std::size_t k) { return setup_.machine->joints[k].side == JointSide::table; });
  if (!turns_table) return;
  const ControlTable& control = index_.control();
  const bool is_turned = motion_.tip_frame() != RotaryAngles{0, 0} || motion_.has_turned_offset();
  std::string open;
  if (!is_call)
    open = is_turned && !control.shifts_words_of_joints
               ? " changes the work offset while tool centre point control follows a turned table"
               : "";
  else if (control.has_tip_frame_of_table)
    open = take_frame_at_call();
  else if (setup_.tip_frame == TipFrame::workpiece)
    open = " follows coordinates that do not turn with the table, which are not read";
  else if (setup_.tip_frame == TipFrame::not_stated)
    open = ": a parameter of the control states whether coordinates turn with the table; expected --tip-frame";
  else
    open = take_frame_at_call();
  if (!open.empty())
    motion_.doubt(ProgramDoubt::tip_control, code_text(row.letter, row.number) + in_line(line_) + open);
}

// G255 ends the turned work offset. Programs end tool centre point control by it too, and no manual states that it does.
void BlockRunner::end_tip_control(const GcodeRow& row) {
  const std::vector<std::string>& ends = setup_.tip_control_ends;
  const bool is_named = std::ranges::find(ends, code_text(row.letter, row.number)) != ends.end();
  const bool is_open = motion_.tip_control() == TipControl::on || motion_.tip_control() == TipControl::unknown;
  if (is_open && !is_named && !ends.empty()) return;
  motion_.set_tip_control(is_open && !is_named ? TipControl::unknown : TipControl::off);
}

void BlockRunner::take_offset(const GcodeRow& row) {
  std::string name = code_text(row.letter, row.number);
  if (row.words.find('P') != std::string_view::npos) {
    const auto p = words_.integer('P');
    if (!p) return lose_rest(name + " has no P that states the work offset", line_);
    name += "P" + std::to_string(*p);
  }
  if (offset_line_ == 0 && line_ > 0) offset_line_ = line_;
  motion_.choose_offset(name);
}

// Source: Fanuc B-64484EN, tilted working plane indexing by Euler angles.
void BlockRunner::take_tilted_plane() {
  const bool is_by_euler = !words_.has_any("PQR");
  if (!is_by_euler) return lose_rest("this form of a tilted frame is not read; expected X Y Z I J K", line_);
  RigidTransform plane;
  Vec3 angles = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const char axis = "XYZ"[i], angle = "IJK"[i];
    if (words_.has(axis)) plane.shift[i] = length(axis);
    if (words_.has(angle)) angles[i] = number(angle, 0.001);
  }
  if (plane.shift.hasNaN() || angles.hasNaN()) return lose_rest(lost_.empty() ? "a value is not known" : lost_, line_);
  plane.rotation = euler_rotation(angles[0], angles[1], angles[2]);
  motion_.end_doubt(ProgramDoubt::frame);
  motion_.set_plane(plane);
}

}  // namespace gouge
