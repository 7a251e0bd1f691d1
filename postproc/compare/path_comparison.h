#pragma once

#include <optional>
#include <string>

#include "lib/base/exit_code.h"
#include "lib/path/path_difference.h"
#include "lib/path/path_order.h"

namespace gouge {

/// Two readings of a toolpath, such as CL data and the program that a post-processor made of it. The paths must outlive
/// the object.
struct PathComparison {
  /// An angle between tool axes counts as the distance that it makes at this height above the tip.
  static constexpr double kHeight_mm = 100;

  const Toolpath* before = nullptr;
  const Toolpath* after = nullptr;
  PathDifference forward, backward;  ///< of `before` against `after`, and the reverse
  MovesLeftOut out_of_before, out_of_after;
  PathOrder order;  ///< of the positions of both
  double same_within_mm = 0;
  std::optional<PathRelation> relation = {};  ///< explains a difference of tips: `after` as a relation of `before`

  /// Return the largest distance of a tip, and that of a point at kHeight_mm by the turn of an axis.
  [[nodiscard]] double tip_mm() const;
  [[nodiscard]] double axis_mm() const;
  /// Returns the number of feeds of one path that are rapids in the other.
  [[nodiscard]] std::size_t rapids() const { return forward.rapids + backward.rapids; }
  /// Returns the number of moves of both paths that are not checked, and so not compared.
  [[nodiscard]] std::size_t unchecked() const { return out_of_before.unchecked + out_of_after.unchecked; }
  /// Gouges: a tip or axis is farther than `same_within_mm`, a feed is a rapid in the other path, or the order differs.
  /// Not checked: no such difference, but unchecked moves.
  [[nodiscard]] ExitCode exit_status() const;
};

/// Returns the largest distances and the first different feed rate, in lines for people.
[[nodiscard]] std::string comparison_text(const PathComparison& comparison);
/// Returns the same as JSON: docs/formats/compare.md.
[[nodiscard]] std::string comparison_json(const PathComparison& comparison);

}  // namespace gouge
