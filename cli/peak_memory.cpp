#include "cli/peak_memory.h"

#include <fstream>
#include <ostream>
#include <string>

namespace gouge {

// Not getrusage: its peak begins with that of the program which started this one.
std::optional<std::size_t> peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.compare(0, 6, "VmHWM:") == 0) return 1024 * std::stoull(line.substr(6));
  }
  return std::nullopt;
}

void print_peak_memory(std::ostream& err) {
  constexpr std::size_t kMegabyte = 1000000;
  if (const auto bytes = peak_memory_bytes()) {
    err << "memory: " << (*bytes + kMegabyte - 1) / kMegabyte << " MB at the peak\n";
  }
}

}  // namespace gouge
