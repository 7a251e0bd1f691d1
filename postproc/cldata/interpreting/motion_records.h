#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/program/cutcom.h"

// The state (axis, frame, unit, rapid) in which each position of a file was read. A writer needs it to change the
// position.

namespace gouge {

/// Form of a position in its file, as far as a writer needs it.
enum class PositionForm : std::uint8_t { go_to, from, gohome, godlta, curve, cycle, unread };

/// A conversion of the numbers of a position to a point: p = to_part(mm_per_unit x).
struct MotionFrame {
  double mm_per_unit = 1;
  RigidTransform to_part;
};

/// The state in which a move was read.
struct MotionRecord {
  SmallIndex statement;
  SmallIndex point, points = 1;        ///< index of the position in its statement, and number of positions there
  SmallIndex first_argument;           ///< index of the first argument of this position
  SmallIndex rapid_statement = kNone;  ///< the last RAPID before it
  SmallIndex block;                    ///< number of the TOOL PATH block; the modal axis ends with the block
  SmallIndex curve_statement = kNone;  ///< for an arc: the statement of its description, if that is another one
  /// 3 or 6; for a step of a cycle those of the hole. 0 for the forms godlta, curve and unread.
  std::uint8_t numbers = 0;
  PositionForm form = PositionForm::go_to;
  bool is_rapid = false;  ///< whether a RAPID before it applies
  CutcomSide cutcom = CutcomSide::none;
  bool is_tapping = false;          ///< a step of a cycle that reverses the spindle
  bool is_multax_off = false;       ///< here a position with an axis would be read as two positions, or not checked
  Vec3 axis_local = Vec3::UnitZ();  ///< axis of this position, in the frame of the block
  Vec3 implied_axis_local = Vec3::UnitZ();  ///< the axis of a position of 3 numbers here
  const MotionFrame* frame = nullptr;       ///< one of MotionRecords::frames
};

struct MotionRecords final : MoveOrigins {
  std::vector<MotionRecord> of_move;  ///< one for each of Toolpath::moves, in the same order
  std::deque<MotionFrame> frames;     ///< a deque, because records point into it while it grows
};

/// Returns the records of the moves of `path`: those in the path if it has them. Else reads its bytes once more.
[[nodiscard]] std::shared_ptr<const MotionRecords> read_motion_records(const Toolpath& path, OpenStatements open);

/// A position of one statement before it becomes a move. Its numbers are converted to mm, in the frame of the block.
struct Position {
  Vec3 tip_local = Vec3::Zero();
  Vec3 axis_local = Vec3::UnitZ();
  std::size_t point = 0, points = 1, first_argument = 0, numbers = 0;
  PositionForm form = PositionForm::go_to;
  const char* uncertainty = nullptr;  ///< why it cannot be checked in any state
  Cover cover = Cover::none;          ///< deviation of a motion with an uncertainty
};

inline constexpr const char* kPositionForm = "expected x,y,z or x,y,z,i,j,k";

}  // namespace gouge
