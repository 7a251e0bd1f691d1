#pragma once

#include <string>

namespace gouge {

/// Returns how this program was built and what it found on this machine, one line each: compiler, libraries,
/// instruction sets, MPI.
[[nodiscard]] std::string build_facts_text();

}  // namespace gouge
