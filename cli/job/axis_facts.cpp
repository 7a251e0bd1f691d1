#include "cli/job/axis_facts.h"

#include <algorithm>
#include <numbers>

#include "cli/terminal/length_text.h"
#include "lib/base/number_text.h"
#include "lib/correct/laws.h"
#include "lib/path/axis_quality.h"
#include "lib/path/axis_tilt.h"

namespace gouge {
namespace {

constexpr double kSlowest = 0.001;                             // of degrees a minute: 120 days for half a turn
constexpr double kRadPerSecond = std::numbers::pi / 180 / 60;  // of a degree a minute

std::vector<std::size_t> origins_of(const Toolpath& before, const std::vector<PathChange>& changes) {
  const std::vector<MovesAfter> spans = moves_after(before.moves.size(), changes);
  std::vector<std::size_t> origins(spans.empty() ? 0 : spans.back().last);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    std::fill(origins.begin() + static_cast<std::ptrdiff_t>(spans[i].first),
              origins.begin() + static_cast<std::ptrdiff_t>(spans[i].last), i);
  }
  return origins;
}

}  // namespace

Result<RotaryLimit> understand_rotary_limit(const std::string& typed) {
  if (typed.empty()) return RotaryLimit();
  const std::optional<double> speed = parse_number(typed);
  if (speed && *speed >= kSlowest) return RotaryLimit(speed);
  return usage_error("--max-rotary-speed", typed, "degrees a minute, at least 0.001");
}

AxisFacts measure_axes(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after,
                       const RotaryLimit& limit) {
  const std::optional<double> rad_per_s = limit ? std::optional(*limit * kRadPerSecond) : std::nullopt;
  AxisFacts facts;
  facts.before = measure_axis_quality(before, rad_per_s);
  facts.after = measure_axis_quality(after, rad_per_s);
  facts.tilts = find_axis_tilts(before, after, origins_of(before, changes));
  facts.max_rotary_deg_per_min = limit;
  return facts;
}

}  // namespace gouge
