#pragma once

#include <string>

#include "lib/path/toolpath.h"
#include "postproc/program/cutcom.h"

// Receives a neutral toolpath: one motion after another, in the order of the path. Poses and feeds are in mm and part
// coordinates; a sink converts them to the unit and the words of its dialect.

namespace gouge {

class MotionSink {
 public:
  MotionSink() = default;
  MotionSink(const MotionSink&) = delete;
  MotionSink& operator=(const MotionSink&) = delete;
  virtual ~MotionSink() = default;

  /// Begins an operation; `change_tool` sets the tool of later motions.
  virtual void begin_operation(const std::string& name) = 0;
  virtual void change_tool(const PathTool& tool) = 0;
  /// States that no motion leads to the next position. Returns false if the dialect cannot state that.
  [[nodiscard]] virtual bool break_motion() = 0;
  /// Compensates later motions, or ends compensation with `none`. Returns false if the dialect cannot state that.
  [[nodiscard]] virtual bool set_cutcom(CutcomSide side) = 0;
  /// States that the tool retracts to an unknown place. Not used for dialects that cannot state it.
  virtual void retract() = 0;
  /// Sets the feed of later motions, which must be a number. Returns false if the dialect cannot state that.
  [[nodiscard]] virtual bool set_feed(const Feed& feed) = 0;
  /// Stops the spindle before later motions, or starts it. Not used for dialects that cannot state it.
  virtual void stop_spindle(bool is_stopped) = 0;
  /// Makes the next motion rapid. Returns false if the dialect cannot state that.
  [[nodiscard]] virtual bool make_rapid() = 0;
  virtual void go_to(const Pose& end) = 0;
  /// Writes an arc. Returns false if the dialect cannot state it; then nothing was written.
  [[nodiscard]] virtual bool go_round(const PathArc& arc, const Pose& start, const Pose& end) = 0;
  /// Returns the bytes of the file. Must be called once, at the end.
  [[nodiscard]] virtual std::string finish() = 0;
};

}  // namespace gouge
