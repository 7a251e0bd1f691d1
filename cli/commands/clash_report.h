#pragma once

#include <optional>
#include <string>

#include "lib/base/units.h"
#include "lib/clash/clash.h"
#include "lib/clash/free_shift.h"

namespace gouge {

/// Result of `gougecheck clash`. Lengths are in mm, in the coordinates of A.
struct ClashReport {
  std::string a, b;  ///< the files, as the user named them
  LengthUnit unit = LengthUnit::mm;
  ClashOptions options;
  Clash clash;
  std::optional<FreeShift> shift;  ///< set if the bodies penetrate and a shift was found
};

/// Returns the finding in one line, then its details.
[[nodiscard]] std::string clash_text(const ClashReport& report);

/// Returns the report as JSON, with all digits; docs/formats/clash_json.md.
[[nodiscard]] std::string clash_json(const ClashReport& report);

/// Returns "free", "touching", "penetrating" or "not-certified".
[[nodiscard]] const char* state_name(ClashState state);

}  // namespace gouge
