#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/fuzz/require.h"
#include "tests/fuzz/tools_made.h"
#include "toolmodels/import/import_tools.h"

// One target for each importer, GOUGE_FUZZ_FORMAT. Files beside the library hold the same bytes. An import ends in an
// error, in notes that state why there is no tool, or in a library that is sound.

namespace gouge {
namespace {

using fuzz::require;

void import(std::string_view bytes) {
  ImportOptions options;
  if (bytes.size() % 3 != 0) options.unit = bytes.size() % 3 == 1 ? LengthUnit::mm : LengthUnit::inch;
  if (bytes.size() % 5 == 0) options.stickout_mm = 30;
  if (bytes.size() % 7 == 0) options.holder = {{40, 50, 60}};
  options.read_beside = [bytes](const std::string& name) -> Result<std::string> {
    if (name.size() % 4 == 3) return make_error("file-not-found", "no such file", name);
    return std::string(bytes.substr(bytes.size() / 4));
  };
  (void)recognise_format(bytes);
  const Result<ImportedTools> made = import_tools("fuzz", bytes, ImportFormat::GOUGE_FUZZ_FORMAT, options);
  require(made.has_value() || (!made.error().code.empty() && !made.error().message.empty()));
  if (!made) return;
  for (const Diagnostic& note : made->notes) require(!note.message.empty());
  if (made->library.tools.empty() && made->library.holders.empty())
    require(has_error(made->notes));
  else
    fuzz::require_sound(made->library);
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gouge::import({reinterpret_cast<const char*>(data), size});
  return 0;
}
