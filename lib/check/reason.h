#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/boxed.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Reason for the state of a move, as a value. Code uses `kind`; people read reason_text.
struct Reason {
  enum class Kind : std::uint8_t {
    none,
    of_path,  ///< the reason that the reader of the file gives: `detail`
    rapid_skipped,
    rapid_unsure,  ///< whether the move is a rapid is not known, and rapids run differently
    no_tool,
    tool_undefined,
    no_start,
    no_curve,
    axis_reversed,
    link_gouges,  ///< the link from line `amount` gouges
    out_of_reach,
    axis_not_unit,
    options_invalid,
    buried,         ///< `body` is inside a solid
    side_unknown,   ///< the side of `body` is unknown because of the meshes: `detail`
    body_too_thin,  ///< `body` is too thin for a test of its side
    head_too_thin,
    thin_feature,   ///< a thin feature may reach `amount` mm into the solid (rounded up; infinite: any length)
    out_of_budget,  ///< the budget of `amount` bounds ran out
    head_out_of_budget,
    turn_undecided,           ///< no proof covers all positions of the rotary joints
    stock_unknown,            ///< what the motion at `detail` (a line) removed of the stock is not known
    stock_touched,            ///< a tool touched the remaining stock, which it may have removed
    stock_motion_open,        ///< the law states no single motion, so it is not checked against the stock
    stock_met_too,            ///< of a gouge: `body` meets remaining stock too; `detail` has how deep and when
    stock_open_too,           ///< of a gouge: whether the move meets remaining stock too is open; `detail` has why
    clearance_entered,        ///< the clearance of `body` is entered by `amount` mm
    mesh_clearance_entered,   ///< the clearance of the witness's mesh is entered by `body`, by `amount` mm
    mesh_tolerance_exceeded,  ///< the tolerance of the witness's mesh is exceeded: `body` is `amount` mm deep
    stock_met,                ///< remaining stock is met: `detail` has when, and which cut came nearest
  };

  Reason() = default;
  Reason(Kind its_kind, Body its_body = Body::cutter) : kind(its_kind), body(its_body) {}
  Reason(Kind its_kind, Body its_body, double amount, std::string detail = {})
      : kind(its_kind), body(its_body), facts_(Facts{amount, std::move(detail)}) {}

  Kind kind = Kind::none;
  Body body = Body::cutter;

  [[nodiscard]] double amount() const { return facts_ ? facts_->amount : 0; }
  [[nodiscard]] std::string_view detail() const {
    return facts_ ? std::string_view(facts_->detail) : std::string_view();
  }
  [[nodiscard]] bool is(Kind of) const { return kind == of; }
  /// Returns whether the reason is a limit that a gouge exceeded; such a reason leaves nothing undecided, and the move has
  /// no other contact.
  [[nodiscard]] bool names_limit() const { return kind >= Kind::clearance_entered; }
  /// Returns whether the move of a gouge meets remaining stock too, or may meet it.
  [[nodiscard]] bool is_stock_too() const { return kind == Kind::stock_met_too || kind == Kind::stock_open_too; }
  [[nodiscard]] bool is_same(const Reason& other) const {
    return kind == other.kind && body == other.body && !(amount() < other.amount()) && !(other.amount() < amount()) &&
           detail() == other.detail();
  }

 private:
  struct Facts {
    double amount = 0;
    std::string detail;
  };
  Boxed<Facts> facts_;  // boxed, because each of millions of moves has a reason
};

/// Returns the sentence for people; empty if there is no reason.
[[nodiscard]] std::string reason_text(const Reason& reason);

/// Returns whether `text` is the sentence of a clearance or tolerance that a gouge exceeded, and of nothing else.
[[nodiscard]] bool is_text_of_limit(std::string_view text);
/// Returns whether `text` is the sentence of a reason with is_stock_too.
[[nodiscard]] bool is_text_of_stock_too(std::string_view text);

}  // namespace gouge
