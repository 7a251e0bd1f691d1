#pragma once

#include <optional>
#include <string>

#include "postproc/cldata/writing/motion_sink.h"
#include "postproc/cldata/writing/text_format.h"

// Writes a toolpath as the text of one dialect.

namespace gouge {

struct TextSinkOptions {
  DialectKind kind = DialectKind::apt;
  LengthUnit unit = LengthUnit::mm;
  int decimals = 0, axis_decimals = 0;  ///< no fewer than these
  bool is_tilted = false;               ///< an axis of the path is not +Z
  bool is_on_centre = true;             ///< all positions are the cutter's centre
  std::string name;                     ///< of the part program
};

class TextSink final : public MotionSink {
 public:
  explicit TextSink(const TextSinkOptions& options);

  void begin_operation(const std::string& name) override;
  void change_tool(const PathTool& tool) override;
  [[nodiscard]] bool break_motion() override;
  [[nodiscard]] bool set_cutcom(CutcomSide side) override;
  void retract() override;
  [[nodiscard]] bool set_feed(const Feed& feed) override;
  [[nodiscard]] bool make_rapid() override;
  void go_to(const Pose& end) override;
  [[nodiscard]] bool go_round(const PathArc& arc, const Pose& start, const Pose& end) override;
  [[nodiscard]] std::string finish() override;

 private:
  void line(const std::string& text) { text_ += text + std::string(format_.line_end); }
  void begin_file();
  void begin_catia_file();
  void write_mcs();
  void say_on_centre();
  void begin_nx_block();
  void write_cutter(const PathTool& tool);
  void write_number(const PathTool& tool);
  [[nodiscard]] std::string seven(const CutterStatement& cutter, const char* separator) const;
  [[nodiscard]] bool write_catia_arc(const PathArc& arc, const Pose& start, const Pose& end);
  [[nodiscard]] std::string unit_word() const { return options_.unit == LengthUnit::inch ? "INCHES" : "MM"; }
  [[nodiscard]] double scaled(double mm) const { return mm / mm_per(options_.unit); }

  TextSinkOptions options_;
  TextFormat format_;
  std::string text_;
  std::string operation_;
  std::optional<PathTool> tool_;
  std::optional<Vec3> axis_;  // last written, where it is modal
  bool is_block_due_ = true;  // NX: the next motion begins a block
  bool is_block_open_ = false;
  bool is_alone_ = true;  // nothing leads to the next position
  bool has_feed_per_turn_ = false;
};

}  // namespace gouge
