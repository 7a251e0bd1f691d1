#include "postproc/cldata/interpreting/frame_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/words.h"

// Unit and frame of positions.

namespace gouge {

namespace {

constexpr double kFarthest_mm = 1e7;  // ten kilometres: no machine is that large

}  // namespace

bool FrameState::state_unit(double mm_per_unit) {
  mm_per_unit_ = mm_per_unit;
  is_recorded_ = false;
  return !std::exchange(is_unit_stated_, true);
}

bool FrameState::set(const RigidTransform& to_part) {
  const double change = (to_part.rotation - to_part_.rotation).cwiseAbs().maxCoeff() +
                        (to_part.shift - to_part_.shift).cwiseAbs().maxCoeff();
  to_part_ = to_part;
  is_recorded_ = false;
  const bool is_turned = !to_part.rotation.isIdentity(kIdentityError);
  has_turned_ = has_turned_ || is_turned;
  if (is_turned || to_part.shift.norm() > kIdentityError) line_ = in_.line();
  return change > kIdentityError;
}

void FrameState::begin_block() {
  to_part_ = {};
  is_recorded_ = false;
}

std::optional<Vec3> FrameState::read_tip(std::size_t first) {
  const Vec3 tip = in_.vector(first) * mm_per_unit_;
  if (tip.cwiseAbs().maxCoeff() <= kFarthest_mm) return tip;
  in_.fail("path-range", in_.major() + ": a coordinate is beyond " + fixed_text(kFarthest_mm, 0) +
                             " mm; expected a position within a machine" + in_.comma_hint());
  return std::nullopt;
}

// Makes a frame. Each component of a unit vector has an error of up to `rounding`. So its length has an error of
// sqrt(3) times that, and the product of two vectors one of twice that. The cross product of both differs from the
// third axis by at most six times `rounding`.
std::optional<RigidTransform> FrameState::make(const Vec3& origin, const Vec3& x, const Vec3& y,
                                               const std::optional<Vec3>& z, double rounding, const char* what) {
  constexpr double kOfLength = 1.74, kOfProduct = 3.48, kOfThird = 6;
  const bool is_frame = std::abs(x.norm() - 1) <= kFrameError && std::abs(y.norm() - 1) <= kFrameError &&
                        std::abs(x.dot(y)) <= kFrameError;
  if (!is_frame) {
    in_.fail("path-frame",
             std::string(what) + ": the axes are not two unit vectors at right angles; expected X and Y axis");
    return std::nullopt;
  }
  RigidTransform frame;
  const Vec3 unit_x = x.normalized();
  const Vec3 unit_z = unit_x.cross(y).normalized();
  frame.rotation.col(0) = unit_x;
  frame.rotation.col(1) = unit_z.cross(unit_x);
  frame.rotation.col(2) = unit_z;
  frame.shift = origin * mm_per_unit_;
  is_skewed_ = std::abs(x.norm() - 1) > kOfLength * rounding + kIdentityError ||
               std::abs(y.norm() - 1) > kOfLength * rounding + kIdentityError ||
               std::abs(x.dot(y)) > kOfProduct * rounding + kIdentityError ||
               (z && (*z - unit_z).norm() > kOfThird * rounding + kIdentityError);
  return frame;
}

void FrameState::write_note() const {
  in_.report(Severity::note, "path-csys", csys_, "CSYS statement",
             " not applied: Creo writes positions in the machine coordinate system");
}

const MotionFrame* FrameState::record(std::deque<MotionFrame>& frames) {
  if (!std::exchange(is_recorded_, true)) frames.push_back({mm_per_unit_, to_part_});
  return &frames.back();
}

namespace {

constexpr std::array<double, 12> kIdentityByRows = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

bool is_identity(std::span<const Argument> arguments) {
  if (arguments.size() != kIdentityByRows.size()) return false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!arguments[i].number || std::abs(*arguments[i].number - kIdentityByRows[i]) > kIdentityError) return false;
  }
  return true;
}

bool is_all_zero(std::span<const Argument> arguments) {
  return std::ranges::all_of(arguments, [](const Argument& a) { return a.number && std::abs(*a.number) <= 0; });
}

// Returns whether a system of CATIA (origin, X axis, Z axis) is that of the positions themselves.
bool is_same_system(std::span<const Argument> arguments) {
  constexpr std::array<double, 9> kSame = {0, 0, 0, 1, 0, 0, 0, 0, 1};
  return std::ranges::equal(arguments, kSame, [](const Argument& a, double expected) {
    return a.number && std::abs(*a.number - expected) <= kIdentityError;
  });
}

// Returns whether the numbers are three rows, each with three components of an axis and one of the origin.
bool is_rigid_by_rows(const StatementContext& in) {
  if (!in.has_numbers_alone(12)) return false;
  Eigen::Matrix3d rotation;
  for (Eigen::Index row = 0; row < 3; ++row)
    rotation.row(row) = in.vector(static_cast<std::size_t>(4 * row)).transpose();
  return (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kFrameError &&
         rotation.determinant() > 0;
}

void mark_frame_word_uncertain(States& s, const char* reason = Reasons::kUnreadFrame) {
  s.uncertainties.set(Uncertainty::unread_frame, s.in.because(reason));
}

// Returns the numbers of MCSYS/ NUM,n,POINT,x,y,z,VECTOR,i,j,k,VECTOR,i,j,k; nothing for any other form.
std::optional<std::array<Vec3, 3>> read_mcsys(std::span<const Argument> arguments) {
  constexpr std::array<std::string_view, 14> kForm = {"NUM", "", "POINT", "", "", "", "VECTOR", "", "", "", "VECTOR"};
  if (arguments.size() != kForm.size()) return std::nullopt;
  std::array<Vec3, 3> vectors;
  Eigen::Index count = 0;
  for (std::size_t i = 0; i < kForm.size(); ++i) {
    const bool is_word = !kForm[i].empty();
    if (is_word ? !equals_ignoring_case(arguments[i].text, kForm[i]) : !arguments[i].number) return std::nullopt;
    if (is_word || i == 1) continue;
    vectors[static_cast<std::size_t>(count / 3)][count % 3] = *arguments[i].number;
    ++count;
  }
  return vectors;
}

}  // namespace

// Sets the frame. It moves nothing, so the next position is linked to the last one. A block or a section has one frame,
// which precedes its positions.
void set_frame(States& s, const RigidTransform& to_part, bool says_axis) {
  const bool has_blocks = s.blocks.is_open() || s.in.dialect.operations_are_blocks;
  const bool is_changed = s.frame.set(to_part);
  const bool was_stated = std::exchange(s.is_frame_stated, true);
  const bool is_late = is_changed && !has_blocks && !was_stated;
  if (is_late) mark_moves_uncertain(s, 0, s.in.moves(), Reasons::kLateFrame);
  if (is_changed || says_axis) s.axes.note_frame(says_axis);
  if (is_changed) {
    ++s.frame_changes;
    s.clear_plane_mm.reset();
  }
  if (is_changed) {
    break_motion(s);
    if (has_blocks && s.blocks.has_positions(s.in.moves())) mark_frame_word_uncertain(s);
  }
  s.uncertainties.clear(Uncertainty::setup);  // the file states the place of the setup
  s.uncertainties.set(Uncertainty::skew, s.frame.is_skewed() ? s.in.because(Reasons::kSkewed) : nullptr);
}

void take_msys(States& s) {
  if (!s.in.has_numbers_alone(9)) {
    return s.in.fail("path-frame", "MSYS has " + std::to_string(s.in.arguments.size()) +
                                       " arguments; expected 9 numbers: the origin, the X axis and the Y axis");
  }
  const double rounding = rounding_of(std::span<const Argument>(s.in.arguments).subspan(3));
  const std::optional<RigidTransform> frame =
      s.frame.make(s.in.vector(0), s.in.vector(3), s.in.vector(6), std::nullopt, rounding, "MSYS");
  if (!frame) return;
  set_frame(s, *frame);
  s.blocks.require_frames();
  if (!s.blocks.is_open()) return;
  s.uncertainties.clear(Uncertainty::block);
  if (!s.is_unknown_in_block) s.uncertainties.clear(Uncertainty::unknown);  // the block states tool, axis and frame
  s.blocks.note_frame(s.in.moves());
}

void take_csys(States& s) {
  if (s.in.dialect.is_in_world && s.is_world_stated) return;
  s.uncertainties.set(Uncertainty::csys, is_identity(s.in.arguments) ? nullptr : s.in.because(Reasons::kCsys));
}

// Takes CAMERA. Creo 9 writes it in place of the comment $$-> CSYS of older files, with the same twelve numbers.
void take_camera(States& s) {
  if (s.in.dialect.has_camera_csys && is_rigid_by_rows(s.in)) return note_creo_csys(s);
  s.in.count_unknown();
  mark_frame_word_uncertain(s);
}

void note_creo_csys(States& s) {
  if (!is_identity(s.in.arguments)) s.frame.note_csys();
}

// Takes MCS of CAMplete: the X, Y and Z axes, then the origin.
void take_mcs(States& s) {
  if (!s.in.has_numbers_alone(12)) {
    return s.in.fail("path-frame", "MCS has " + std::to_string(s.in.arguments.size()) +
                                       " arguments; expected 12 numbers: the X, Y and Z axes and the origin");
  }
  const double rounding = rounding_of(std::span<const Argument>(s.in.arguments).first(9));
  const std::optional<RigidTransform> frame =
      s.frame.make(s.in.vector(9), s.in.vector(0), s.in.vector(3), s.in.vector(6), rounding, "MCS");
  if (!frame) return;
  if ((s.in.vector(6) - frame->rotation.col(2)).norm() > kFrameError)
    return s.in.fail("path-frame",
                     "MCS: the third axis is not the first cross the second; expected a right-handed system");
  set_frame(s, *frame);
  // A file whose only system is that of the part need not repeat it.
  const double turn = (frame->rotation - RigidTransform{}.rotation).cwiseAbs().maxCoeff();
  if (turn > kIdentityError || frame->shift.norm() > kIdentityError) s.blocks.require_frames();
  s.blocks.note_frame(s.in.moves());
}

// Takes MCSYS: an origin, an X axis and a Y axis. Its writer turns positions into no other system before it writes
// them. For positions of three numbers, this is the only source of the axis.
void take_mcsys(States& s) {
  const std::optional<std::array<Vec3, 3>> vectors = read_mcsys(s.in.arguments);
  s.uncertainties.set(Uncertainty::mcs, vectors ? nullptr : s.in.because(Reasons::kMcsys));
  if (!vectors) return;
  constexpr std::size_t kBehindOrigin = 6;
  const double rounding = rounding_of(std::span<const Argument>(s.in.arguments).subspan(kBehindOrigin));
  const std::optional<RigidTransform> frame =
      s.frame.make((*vectors)[0], (*vectors)[1], (*vectors)[2], std::nullopt, rounding, "MCSYS");
  if (frame) set_frame(s, *frame, true);
}

// Takes ROTABL. Except in CAMWorks CLT, angles may be absolute or relative, and belong to one of several tables. So no
// statement undoes them.
void take_rotabl(States& s) {
  const std::vector<Argument>& arguments = s.in.arguments;
  if (std::ranges::none_of(arguments, may_be_number)) {
    distrust(s, Word::rotabl);
    return s.in.count_unknown();
  }
  if (s.in.dialect.has_setups && s.setup.take_turn()) return;
  const bool is_turned = std::ranges::any_of(
      arguments, [](const Argument& a) { return a.number ? std::abs(*a.number) > 0 : may_be_number(a); });
  if (is_turned) mark_frame_word_uncertain(s, Reasons::kTurned);
}

// Takes TRNTYP. For any system other than that of the part, the three numbers would shift positions; nothing else is
// known.
void take_trntyp(States& s) {
  const std::span<const Argument> all(s.in.arguments);
  constexpr std::size_t kWorldAndPoint = 4;
  const bool is_world =
      all.size() == kWorldAndPoint && equals_ignoring_case(all.front().text, "WORLD") && is_all_zero(all.subspan(1));
  s.uncertainties.set(Uncertainty::trntyp, is_world ? nullptr : s.in.because(Reasons::kTrntyp));
  s.is_world_stated = is_world;
  if (is_world && s.in.dialect.is_in_world) s.uncertainties.clear(Uncertainty::csys);
}

// Takes TRANS and ORIGIN, which shift the output of a post-processor. No file shows whether the part shifts with it.
// Zeros undo the shift of the same word, unless another word states their meaning.
void take_trans(States& s) {
  if (s.in.arguments.empty()) return;
  const bool is_origin = equals_ignoring_case(s.in.statement().major, "ORIGIN");
  const bool is_none = is_all_zero(s.in.arguments) || (is_origin && is_same_system(s.in.arguments));
  switch_uncertainty(s, is_origin ? Uncertainty::origin : Uncertainty::trans, !is_none, Reasons::kTrans);
}

// Takes MODE. The program of a lathe or a wire machine has its positions in another plane.
void take_mode(States& s) {
  if (s.in.has("MILL")) s.uncertainties.clear(Uncertainty::mode);
  for (const char* word : {"TURN", "LATHE", "WIRE", "EDM"}) {
    if (s.in.has(word)) s.uncertainties.set(Uncertainty::mode, s.in.because(Reasons::kTurning));
  }
  const auto leaves_positions_alone = [&](const Argument& argument) {
    constexpr std::array<std::string_view, 8> kWords = {"MILL", "TURN",  "LATHE",    "WIRE",
                                                        "EDM",  "ABSOL", "ABSOLUTE", "ABS"};
    const std::optional<LengthUnit> unit = unit_of_word(argument.text);
    if (equals_ignoring_case(argument.text, "METRIC")) return false;  // it may mean millimetres or centimetres
    return unit ? std::abs(mm_per(*unit) / s.frame.mm_per_unit() - 1) <= Tolerance::kRounding
                : is_one_of(argument.text, kWords);
  };
  if (!s.in.arguments.empty() && std::ranges::all_of(s.in.arguments, leaves_positions_alone)) return;
  s.in.count_unknown();
  mark_frame_word_uncertain(s);
}

void take_tlaxis(States& s) {
  if (s.axes.is_tlaxis_ignored()) return;
  s.in.dialect.has_setups ? s.setup.take_axis() : s.axes.take_tlaxis();
}

void take_units(States& s) {
  std::optional<LengthUnit> stated;
  for (const Argument& argument : s.in.arguments) {
    const std::optional<LengthUnit> unit = unit_of_word(argument.text);
    if (!unit) continue;
    if (stated && *stated != *unit) {
      return s.in.fail("path-statement",
                       s.in.major() + " states two units; expected MM or INCHES: leave the right one");
    }
    stated = unit;
  }
  if (!stated) {
    const std::string what = s.in.arguments.empty() ? std::string("nothing") : quoted_text(s.in.arguments.front().text);
    return s.in.fail("path-statement", s.in.major() + ": " + what + " is not a unit; expected MM or INCHES");
  }
  s.feed_units.close();
  // The function that guesses the unit knows this statement. Before the statement a reader takes mm.
  const bool is_other = *stated != LengthUnit::mm || std::abs(mm_per(*stated) - s.frame.mm_per_unit()) > 0;
  const bool is_late = s.frame.state_unit(mm_per(*stated)) && s.in.moves() > 0;
  if (is_late && is_other) mark_moves_uncertain(s, 0, s.in.moves(), s.in.because(Reasons::kLateUnit));
}

}  // namespace gouge
