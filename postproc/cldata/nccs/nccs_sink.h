#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "postproc/cldata/nccs/nccs_records.h"
#include "postproc/cldata/writing/sink_options.h"
#include "postproc/program/motion_sink.h"

// A sink that writes a toolpath as binary NCCS records.

namespace gouge {

class NccsSink final : public MotionSink {
 public:
  NccsSink(LengthUnit unit, const std::string& name);

  void begin_operation(const std::string& name) override;
  void change_tool(const PathTool& tool) override;
  [[nodiscard]] bool break_motion() override;
  [[nodiscard]] bool set_cutcom(CutcomSide side) override;
  void retract() override;
  [[nodiscard]] bool set_feed(const Feed& feed) override;
  void stop_spindle(bool is_stopped) override;
  [[nodiscard]] bool make_rapid() override;
  void go_to(const Pose& end) override;
  [[nodiscard]] bool go_round(const PathArc& arc, const Pose& start, const Pose& end) override;
  [[nodiscard]] std::string finish() override;

 private:
  void add(std::uint16_t klass, std::uint16_t subclass, const std::string& words);

  LengthUnit unit_;
  std::string words_;
  std::uint16_t sequence_ = 0;
  bool has_feed_per_turn_ = false;
};

[[nodiscard]] std::unique_ptr<MotionSink> make_nccs_sink(const SinkOptions& options);

}  // namespace gouge
