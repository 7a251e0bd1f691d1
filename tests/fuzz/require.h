#pragma once

#include <cstdlib>

namespace gouge::fuzz {

/// Ends the program, which libFuzzer takes for a finding, where `condition` is false.
inline void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace gouge::fuzz
