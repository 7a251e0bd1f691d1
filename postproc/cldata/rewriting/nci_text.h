#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/geom/pose.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/nci/nci_lines.h"
#include "postproc/cldata/nci/nci_motion.h"
#include "postproc/cldata/rewriting/number_style.h"

// Motion pairs as one NCI file writes them: its pairs with other ends, and new ones that look like them. Ends
// are in the file's unit. What a position inserted before a pair says besides its end: compensation 0 (no
// change) and flags 0, as both are events of the pair's own position; the feed of the pair, which -1 and -2
// keep right.

namespace gouge {

struct NciMotionPair {
  NciPair lines;
  std::vector<Argument> fields;
  NciMotion motion;
};

class NciText {
 public:
  /// Learns from the first motions of the file.
  NciText(const Toolpath& path, const MotionRecords& records);

  /// The pair of a move that has a position.
  [[nodiscard]] NciMotionPair pair_of(std::size_t move) const;

  /// `pair` with another end. Numbers that stay the same at the file's decimals keep their bytes. The axis
  /// counts for five axes alone; the second point stays as far above the tip as it is, in as many decimals as
  /// the file has, or more where the axis read again would be off by more than the file's own last digit
  /// makes it (at least 1e-6, at most 1e-5). Requires a line, of five axes or not.
  [[nodiscard]] std::string moved(const NciMotionPair& pair, const Pose& end) const;
  /// A position of the same form before `pair`. Requires a line, of five axes or not.
  [[nodiscard]] std::string inserted(const NciMotionPair& pair, const Pose& end) const;
  /// A line in place of the arc `pair`, or before that one.
  [[nodiscard]] std::string straight(const NciMotionPair& pair, const Vec3& tip, bool is_inserted) const;

 private:
  using Tokens = std::vector<std::string>;  // for each field; empty: the file's bytes stay

  void learn(const NciMotionPair& pair);
  [[nodiscard]] std::size_t offset(std::string_view text) const {
    return static_cast<std::size_t>(text.data() - path_.source.data());
  }
  void put_end(const NciMotionPair& pair, const Pose& end, Tokens& tokens) const;
  void put_second_point(const NciMotionPair& pair, const Vec3& tip, const Vec3& axis, Tokens& tokens) const;
  [[nodiscard]] std::string rendered(const NciMotionPair& pair, const Tokens& tokens) const;
  [[nodiscard]] std::string with_line_end(std::string text) const;

  const Toolpath& path_;
  NumberStyle tips_, second_points_;
  double least_axis_error_ = 0;  // what the decimals of the file's points leave open, times the length
  std::string line_end_;
};

}  // namespace gouge
