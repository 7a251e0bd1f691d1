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

// State (axis, frame, unit, rapid) in which each position of a file was read. A writer needs it to change the position.

namespace gouge {

/// Form of a position in its file, as far as a writer must know.
enum class PositionForm : std::uint8_t { go_to, from, gohome, godlta, curve, cycle, unread };

/// Converts a position's numbers to a point: p = to_part(mm_per_unit x).
struct MotionFrame {
  double mm_per_unit = 1;
  RigidTransform to_part;
};

/// The state a move was read in.
struct MotionRecord {
  SmallIndex statement;
  SmallIndex point, points = 1;        ///< which of how many positions of its statement
  SmallIndex first_argument;           ///< of this position
  SmallIndex rapid_statement = kNone;  ///< the last RAPID before it
  SmallIndex block;                    ///< number of the TOOL PATH block; the modal axis does not cross blocks
  SmallIndex curve_statement = kNone;  ///< of an arc: its description besides its own statement
  std::uint8_t numbers = 0;  ///< 3 or 6, of the hole for a step of a cycle; 0 where the form is godlta, curve or unread
  PositionForm form = PositionForm::go_to;
  bool is_rapid = false;  ///< by a RAPID before it
  CutcomSide cutcom = CutcomSide::none;
  bool is_tapping = false;                  ///< a step of a cycle whose spindle turns back
  bool is_multax_off = false;               ///< positions with an axis would be read as two, or not checked
  Vec3 axis_local = Vec3::UnitZ();          ///< axis of this position, in the block's frame
  Vec3 implied_axis_local = Vec3::UnitZ();  ///< meaning of a position of 3 numbers here
  const MotionFrame* frame = nullptr;       ///< one of MotionRecords::frames
};

struct MotionRecords final : MoveOrigins {
  std::vector<MotionRecord> of_move;  ///< one for each of Toolpath::moves, in the same order
  std::deque<MotionFrame> frames;     ///< a deque, because records point into it while it grows
};

/// Returns the records of `path`'s moves: its origins where it has them. Else its bytes are read once more.
[[nodiscard]] std::shared_ptr<const MotionRecords> read_motion_records(const Toolpath& path, OpenStatements open);

/// A position of one statement, before it becomes a move: the file's numbers made mm, in the block's frame.
struct Position {
  Vec3 tip_local = Vec3::Zero();
  Vec3 axis_local = Vec3::UnitZ();
  std::size_t point = 0, points = 1, first_argument = 0, numbers = 0;
  PositionForm form = PositionForm::go_to;
  const char* uncertainty = nullptr;  ///< why it cannot be checked, whatever the state it is read in
  Cover cover = Cover::none;          ///< of a motion with a doubt
};

inline constexpr const char* kPositionForm = "expected x,y,z or x,y,z,i,j,k";

}  // namespace gouge
