#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "postproc/cldata/writing/sink_options.h"
#include "postproc/cldata/writing/text_format.h"
#include "postproc/program/motion_sink.h"

// A sink that writes a toolpath as the text of one dialect.

namespace gouge {

class TextSink final : public MotionSink {
 public:
  explicit TextSink(const SinkOptions& options);

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
  using Value = std::pair<std::string_view, std::string>;
  void line(const std::string& text) { text_ += text + std::string(format_.line_end); }
  /// Writes the lines of `form` with `values` in place of their names in braces.
  void fill(std::string_view form, std::initializer_list<Value> values = {});
  [[nodiscard]] std::string on_centre() const;
  void begin_file();
  void begin_block_if_due();
  void begin_block();
  void write_tool(const PathTool& tool);
  [[nodiscard]] std::string seven(const CutterStatement& cutter) const;
  [[nodiscard]] bool write_tlon(const PathArc& arc, const Pose& start, const Pose& end);
  [[nodiscard]] bool is_inch() const { return options_.unit == LengthUnit::inch; }
  [[nodiscard]] double scaled(double mm) const { return mm / mm_per(options_.unit); }

  SinkOptions options_;
  TextFormat format_;
  std::string text_;
  std::string operation_;
  std::optional<PathTool> tool_;
  std::optional<Vec3> axis_;   // the last written axis, if the axis is modal
  bool is_block_due_ = false;  // the next motion begins a block
  bool is_block_open_ = false;
  bool is_alone_ = true;  // the next position has no motion to it
  bool has_feed_per_turn_ = false;
};

[[nodiscard]] std::unique_ptr<MotionSink> make_text_sink(const SinkOptions& options);

}  // namespace gouge
