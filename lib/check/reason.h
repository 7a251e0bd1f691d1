#pragma once

#include <cstdint>
#include <string>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Reason for the state of a move, as a value: code follows `kind`, people get reason_text.
struct Reason {
  enum class Kind : std::uint8_t {
    none,
    of_path,  ///< the reader's own: `detail`
    rapid_skipped,
    no_tool,
    tool_undefined,
    no_start,
    no_curve,
    axis_reversed,
    link_gouges,  ///< from line `amount`
    out_of_reach,
    axis_not_unit,
    options_invalid,
    buried,         ///< `body`
    side_unknown,   ///< of `body`, for the meshes' sake: `detail`
    body_too_thin,  ///< `body`
    head_too_thin,
    thin_feature,   ///< may reach `amount` mm into the solid (rounded up; infinite: any amount)
    out_of_budget,  ///< of `amount` bounds
    head_out_of_budget,
    clearance_entered,        ///< of `body`, by `amount` mm
    mesh_clearance_entered,   ///< of the witness's mesh, by `body` and `amount` mm
    mesh_tolerance_exceeded,  ///< of the witness's mesh: `body` is `amount` mm deep
  };

  Kind kind = Kind::none;
  Body body = Body::cutter;
  double amount = 0;
  std::string detail{};

  [[nodiscard]] bool is(Kind of) const { return kind == of; }
  /// States which limit a gouge passed, and leaves nothing open.
  [[nodiscard]] bool names_limit() const { return kind >= Kind::clearance_entered; }
  [[nodiscard]] bool is_same(const Reason& other) const {
    return kind == other.kind && body == other.body && !(amount < other.amount) && !(other.amount < amount) &&
           detail == other.detail;
  }
};

/// Returns the sentence for people; empty where there is no reason.
[[nodiscard]] std::string reason_text(const Reason& reason);

}  // namespace gouge
