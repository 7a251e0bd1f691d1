#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"
#include "postproc/gcode/siemens/siemens_runner.h"

// Frames: TRANS, ROT, SCALE, MIRROR and their additive forms, and the swivelled plane of CYCLE800.

namespace gouge {
namespace {

using Meaning = SiemensMeaning;

Eigen::Matrix3d turned_about(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree_rad, Vec3::Unit(axis)).toRotationMatrix();
}

/// Returns whether the axes of a frame are at right angles, as the parts of a frame of the control make them.
bool keeps_right_angles(const Eigen::Matrix3d& linear) {
  const Eigen::Matrix3d square = linear.transpose() * linear;
  const Eigen::Matrix3d off = square - Eigen::Matrix3d(square.diagonal().asDiagonal());
  return off.cwiseAbs().maxCoeff() <= Tolerance::kRounding * square.diagonal().maxCoeff();
}

/// Returns whether the state of CYCLE800 is that of a new plane with which the tool is aligned: its decimal digits above
/// the third only choose the direction of a rotary joint, and the tens keep the tip in place while the joints turn.
/// Source: Tool and Mold Making 08/2007, p. 71; Work preparation 10/2015, p. 678.
bool is_new_plane(double status) {
  constexpr auto kStates = std::to_array<double>({0, 10, 100000, 100010, 200000, 200010});
  return std::ranges::find(kStates, status) != kStates.end();
}

/// Returns whether the display mode of CYCLE800 states the plane of G17, or none. Source: as above, p. 681.
bool is_in_plane_xy(double display) {
  constexpr auto kModes = std::to_array<double>({0, 1});
  return std::ranges::find(kModes, display) != kModes.end();
}

/// Returns the axes of the three turns of CYCLE800, 0 for X; none: its mode is another one.
std::optional<std::array<int, 3>> turn_order(double mode) {
  constexpr double kMaxMode = 255;
  if (!(mode >= 0 && mode <= kMaxMode) || std::abs(mode - std::round(mode)) > 0) return std::nullopt;
  const auto bits = static_cast<unsigned>(mode);
  if (bits >> 6U != 0) return std::nullopt;
  std::array<int, 3> order{};
  unsigned seen = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned axis = bits >> (2 * i) & 3U;
    if (axis == 0) return std::nullopt;
    order.at(i) = static_cast<int>(axis) - 1;
    seen |= 1U << axis;
  }
  return seen == 14U ? std::optional(order) : std::nullopt;
}

}  // namespace

void SiemensRunner::take_frame(const SiemensWords::Code& code) {
  if (code.row->meaning == Meaning::swivel) return take_swivel(*code.word);
  modes_.is_moved.setOnes();
  const bool has_values = words_.has_path_axes() || words_.value("RPL") != nullptr;
  if (!has_values) {
    if (code.row->is_additive) return lose_rest(code.word->name + " states no value", line_);
    modes_.frame.reset();
    modes_.open_frame.clear();
    return motion_.set_frame(std::nullopt);
  }
  const auto stated = stated_frame(*code.row);
  if (!stated) {
    modes_.open_frame = here("a value of " + code.word->name + " is not known");
  } else if (!code.row->is_additive) {
    modes_.frame = *stated;
    modes_.open_frame.clear();
  } else {
    modes_.frame = modes_.frame.value_or(ProgramFrame{}).after(*stated);
    if (!keeps_right_angles(modes_.frame->linear))
      modes_.open_frame = here(code.word->name + " turns a frame with different scales");
  }
  motion_.set_frame(modes_.frame);
}

// Source of the order of the turns: NC programming, 12/2019, p. 309 to 316, RPY angles: Z, then the new Y, then the new X.
std::optional<ProgramFrame> SiemensRunner::stated_frame(const SiemensRow& row) {
  ProgramFrame frame;
  std::array<double, 3> values{};
  std::array<bool, 3> is_stated{};
  for (std::size_t i = 0; i < 3; ++i) {
    const SiemensWord* const word = words_.value(std::string_view("XYZ").substr(i, 1));
    if (word == nullptr) continue;
    if (word->measure != SiemensMeasure::modal || !is_known(word->value)) return std::nullopt;
    values.at(i) = word->value;
    is_stated.at(i) = true;
  }
  const SiemensWord* const in_plane = words_.value("RPL");
  if (in_plane != nullptr) {
    const bool is_alone = !is_stated[0] && !is_stated[1] && !is_stated[2];
    if (!is_alone || !modes_.plane || !is_known(in_plane->value)) return std::nullopt;
    values.at(static_cast<std::size_t>((*modes_.plane)[2])) = in_plane->value;
  }
  switch (row.meaning) {
    case Meaning::translate:
      frame.shift = mm_per_unit() * Vec3(values[0], values[1], values[2]);
      break;
    case Meaning::rotate:
      frame.linear = turned_about(2, values[2]) * turned_about(1, values[1]) * turned_about(0, values[0]);
      break;
    case Meaning::scale:
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!is_stated.at(k)) continue;
        if (!(values.at(k) > 0)) return std::nullopt;
        frame.linear(i, i) = values.at(k);
      }
      break;
    case Meaning::mirror:
      for (int i = 0; i < 3; ++i)
        if (is_stated.at(static_cast<std::size_t>(i))) frame.linear(i, i) = -1;
      break;
    default:
      return std::nullopt;
  }
  return frame;
}

// A place that one of these leaves open is not known either when it ends.
std::string SiemensRunner::why_frame_open() const {
  if (!modes_.open_frame.empty()) return modes_.open_frame;
  if (!modes_.open_swivel.empty()) return modes_.open_swivel;
  if (modes_.edge > 1) return "D" + std::to_string(modes_.edge) + " selects a cutting edge whose length is not given";
  if (modes_.edge > 0 && !modes_.plane)
    return "nothing states the plane, across which the length of the tool is applied; expected --start G17";
  if (modes_.edge > 0 && *modes_.plane != PlaneAxes{0, 1, 2})
    return "a length is applied in G18 or G19, where a setting of the control states its axis";
  if (modes_.has_vector && !motion_.mapper().has_machine() && motion_.tip_control() != TipControl::on)
    return "the tool stays tilted after TRAFOOF; expected --machine";
  const bool is_turned = motion_.has_turned_offset();
  if (is_turned && modes_.has_swivel)
    return "CYCLE800 with a work offset of rotary axes, whose effect machine data state";
  if (is_turned && motion_.tip_control() == TipControl::on)
    return "TRAORI with a work offset of rotary axes, whose effect machine data state";
  return {};
}

void SiemensRunner::settle_frame() {
  std::string open = why_frame_open();
  if (open.empty())
    motion_.end_doubt(ProgramDoubt::frame);
  else
    motion_.doubt(ProgramDoubt::frame, std::move(open));
}

void SiemensRunner::take_swivel(const SiemensWord& cycle) {
  modes_.is_moved.setOnes();
  if (modes_.frame) modes_.open_frame = here("CYCLE800 may end the frame of the program; expected TRANS before it");
  if (cycle.arguments.empty()) {
    modes_.has_swivel = false;
    modes_.open_swivel.clear();
    motion_.set_plane(std::nullopt);
    return;
  }
  const bool was_swivelled = modes_.has_swivel;
  modes_.has_swivel = true;
  modes_.open_swivel = motion_.tip_control() == TipControl::on ? "CYCLE800 while TRAORI is in force"
                       : was_swivelled && std::fmod(siemens_argument(cycle, 2, 0), 10) > 0
                           ? "CYCLE800 is added to the swivelled plane in force"
                           : set_swivel(cycle);
  if (!modes_.open_swivel.empty()) modes_.open_swivel = here(modes_.open_swivel);
  if (!modes_.open_swivel.empty()) motion_.go_unchecked(MoveKind::rapid, AxisPlace{}, modes_.open_swivel);
}

// Arguments: FR, TC, ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, DIR, FR_I, DMODE. Returns why they are not read.
std::string SiemensRunner::set_swivel(const SiemensWord& cycle) {
  constexpr std::size_t kStatus = 2, kMode = 3, kFirstZero = 4, kAngles = 7, kSecondZero = 10, kDirection = 13,
                        kDisplay = 15;
  if (modes_.unit == LengthUnit::inch) return "the unit of the arguments of CYCLE800 is not stated";
  const auto order = turn_order(siemens_argument(cycle, kMode, 0));
  const bool is_plain = is_new_plane(siemens_argument(cycle, kStatus, 0)) &&
                        is_in_plane_xy(siemens_argument(cycle, kDisplay, 0)) && cycle.arguments.size() <= kDisplay + 1;
  if (!order || !is_plain) return "this form of CYCLE800 is not read";
  if (modes_.plane != PlaneAxes{0, 1, 2}) return "CYCLE800 is not in the plane of G17";
  Vec3 first, second;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    first[static_cast<int>(i)] = siemens_argument(cycle, kFirstZero + i, 0) * mm_per_unit();
    second[static_cast<int>(i)] = siemens_argument(cycle, kSecondZero + i, 0) * mm_per_unit();
    turn = turn * turned_about(order->at(i), siemens_argument(cycle, kAngles + i, 0));
  }
  if (!turn.allFinite() || !first.allFinite() || !second.allFinite()) return "a value of CYCLE800 is not known";
  motion_.set_plane(RigidTransform{turn, first + turn * second});
  // Without a direction the rotary axes stand, and the plane is not aligned.
  if (std::abs(siemens_argument(cycle, kDirection, 0)) > 0) motion_.align_to_plane();
  return {};
}

}  // namespace gouge
