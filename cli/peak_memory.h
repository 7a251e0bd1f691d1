#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>

namespace gouge {

/// The most memory this process had in use at once, mapped files included; nothing where the system does not
/// say.
[[nodiscard]] std::optional<std::size_t> peak_memory_bytes();

/// "memory: 178 MB at the peak", or nothing. For people, never for a report: it differs from run to run.
void print_peak_memory(std::ostream& err);

}  // namespace gouge
