#include <algorithm>
#include <cmath>

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
// A-79348E: parameter 19696#5 (WKP) chooses the coordinates.
void BlockRunner::begin_tip_control(const GcodeRow& row) {
  motion_.set_tip_control(TipControl::on);
  motion_.end_doubt(ProgramDoubt::tip_control);
  const std::string code = code_text(row.letter, row.number) + in_line(line_);
  const bool turns_table = std::ranges::any_of(
      setup_.machine->rotary, [&](std::size_t k) { return setup_.machine->joints[k].side == JointSide::table; });
  const bool follows_table = index_.control().has_tip_frame_of_table || setup_.tip_frame == TipFrame::table;
  if (turns_table && !follows_table)
    return motion_.doubt(ProgramDoubt::tip_control,
                         code + (setup_.tip_frame == TipFrame::workpiece
                                     ? " follows coordinates that do not turn with the table, which are not read"
                                     : ": a parameter of the control states whether coordinates turn with the table; "
                                       "expected --tip-frame"));
  if (!words_.has('P')) return;
  const auto p = words_.integer('P');
  const bool covers_both = setup_.feed_law == TurnLaw::documented || setup_.feed_law == TurnLaw::any;
  const bool is_covered =
      (p == 0 && setup_.feed_law != TurnLaw::vector) || (p == 1 && setup_.feed_law == TurnLaw::vector);
  if (!covers_both && !is_covered)
    motion_.doubt(ProgramDoubt::tip_control, code + " chooses another law of motion than that of the check; expected " +
                                                 (p == 1 ? "--feed-law vector" : "--feed-law documented or any"));
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
