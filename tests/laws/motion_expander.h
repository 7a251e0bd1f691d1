#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/geom/pose.h"
#include "tests/laws/expander_curves.h"

// The mutation law's own reader: small, and written from docs/formats and the real files alone. For each
// statement of APT-like text it lists the motions that it may mean under the modal states which the file
// leaves possible, or states that anything may happen there. It takes less for granted than a reader that must
// not raise false alarms: what opens and is never closed, or is closed and was never opened, is a doubt.

namespace gouge::laws {

struct PossibleMotion {
  std::size_t line = 0;
  std::optional<Pose> from;  ///< nothing: the position alone
  Pose to;
  std::optional<CurvePoints> curve;  ///< nothing: the tip runs straight
  std::optional<int> tool;
  std::optional<double> diameter_mm;  ///< of the cutter in force
};

/// A statement that may mean any motion, or more than one.
struct Uncertainty {
  std::size_t line = 0;
  std::string why;
};

struct Expansion {
  std::vector<PossibleMotion> motions;
  std::vector<Uncertainty> uncertainties;
};

[[nodiscard]] Expansion expand_nci(std::string_view bytes);

/// `dialect` is one of docs/formats/apt_cl.md, in text. The cutters of `library_tools` need no statement.
[[nodiscard]] Expansion expand_motions(std::string_view bytes, std::string_view dialect,
                                       const std::set<int>& library_tools = {});

}  // namespace gouge::laws
