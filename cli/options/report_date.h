#pragma once

#include <string>

#include "lib/base/result.h"

namespace gouge {

/// "2026-11-23 14:05 UTC": now, or the instant that SOURCE_DATE_EPOCH names in seconds since 1970, so that reports can
/// be made again to the byte (https://reproducible-builds.org/specs/source-date-epoch/). Errors: usage.
[[nodiscard]] Result<std::string> date_of_report();

}  // namespace gouge
