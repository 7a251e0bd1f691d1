#pragma once

namespace gouge {

/// The least resolution of a depth that may be asked for, beyond which the search would work on rounding alone.
inline constexpr double kFinestResolution_mm = 1e-6;

}  // namespace gouge
