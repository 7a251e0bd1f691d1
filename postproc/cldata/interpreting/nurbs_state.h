#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "postproc/cldata/interpreting/axis_state.h"
#include "postproc/cldata/interpreting/frame_state.h"
#include "postproc/cldata/interpreting/motion_records.h"

namespace gouge {

/// A NURBS from NURBS/, KNOT/ and CNTRL/ lines. Any other statement ends the curve, and so does the end of the file.
class NurbsState {
 public:
  NurbsState(StatementContext& in, FrameState& frame, AxisState& axes) : in_(in), frame_(frame), axes_(axes) {}

  void begin();
  void take_knots();
  void take_control_point();
  /// Returns the position at the end of the curve; nothing after an error. Its move belongs to statement(), in line().
  [[nodiscard]] std::optional<Position> end();
  [[nodiscard]] bool is_open() const { return statement_ != kNone; }
  [[nodiscard]] std::size_t statement() const { return statement_; }
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Attaches the curve to `move`. It begins at `start`, which its CNTRL lines do not repeat.
  void attach(const Pose& start, Move& move);

 private:
  void fail_without_begin(const char* word);

  StatementContext& in_;
  FrameState& frame_;
  AxisState& axes_;
  std::size_t statement_ = kNone;  // the statement whose control points are being read
  std::size_t line_ = 0;
  std::optional<Position> end_;
  std::vector<double> knots_;
  std::vector<Vec3> control_local_;
  bool is_turning_ = false;  // the axes of its control points differ
  bool is_understood_ = false;
};

}  // namespace gouge
