#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/require.h"
#include "tests/fuzz/tools_made.h"

// Tool libraries (JSON): refused with a code, or read as tools that can be written, read back and compiled.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using gouge::fuzz::require;
  const auto library = gouge::read_tool_library("fuzz", {reinterpret_cast<const char*>(data), size});
  require(library.has_value() || (!library.error().code.empty() && !library.error().message.empty()));
  if (library) gouge::fuzz::require_sound(*library);
  return 0;
}
