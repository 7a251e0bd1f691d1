#pragma once

#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/clash/clash.h"
#include "lib/clash/free_shift.h"

namespace gouge {

/// Result of `gougecheck clash`. Lengths in mm, coordinates of A.
struct ClashReport {
  std::string a, b;  ///< the files as the user named them
  LengthUnit unit = LengthUnit::mm;
  ClashOptions options;
  Clash clash;
  std::optional<FreeShift> shift;  ///< of bodies that penetrate
};

/// Returns the finding in one line, then what is known of it.
[[nodiscard]] std::string clash_text(const ClashReport& report);

/// Returns the same with every digit; docs/formats/clash_json.md.
[[nodiscard]] std::string clash_json(const ClashReport& report);

/// Returns "free", "touching", "penetrating", "not-certified".
[[nodiscard]] const char* state_name(ClashState state);

}  // namespace gouge
