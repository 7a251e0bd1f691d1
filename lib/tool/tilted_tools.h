#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace gouge {

struct ToolVariants;

/// Levels of tilt for which a tool is swept. Each level is half of the one before it.
inline constexpr std::size_t kTiltLevels = 14;
inline constexpr double kMaxTilt_rad = std::numbers::pi / 9;
[[nodiscard]] inline double tilt_of_level_rad(std::size_t level) {
  return std::ldexp(kMaxTilt_rad, -static_cast<int>(level));
}
/// Returns the finest level that covers a tilt; none: no level does.
[[nodiscard]] inline std::optional<std::size_t> level_of_tilt(double tilt_rad) {
  if (!(tilt_rad <= kMaxTilt_rad)) return std::nullopt;
  std::size_t level = 0;
  while (level + 1 < kTiltLevels && tilt_rad <= tilt_of_level_rad(level + 1)) ++level;
  return level;
}

/// A tool swept over all tilts about its tip (toolmodels/tilt_sweep.h), for each level. The tools are made when they are
/// first requested; any thread may request them.
class TiltedTools {
 public:
  virtual ~TiltedTools() = default;

  /// Returns the variants of the swept tool; null if the sweep has no contour.
  [[nodiscard]] virtual const ToolVariants* at(std::size_t level) const = 0;
  /// Returns the tool as if it had no cutter, with its own TiltedTools. Null: it has neither shank nor holder.
  [[nodiscard]] virtual const ToolVariants* without_cutter() const = 0;
};

}  // namespace gouge
