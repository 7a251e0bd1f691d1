#include "cli/commands/load_result.h"

#include "cli/output/report_folder.h"
#include "lib/base/files.h"

namespace gouge {

Result<StoredResult> load_result(const std::string& typed, const InputLimit& limit) {
  if (const auto other = refuse_other_folder(typed)) return *other;
  const std::string file = result_in(typed);
  const Result<std::string> bytes = read_file(file, limit.max_bytes);
  if (!bytes) return bytes.error();
  return read_result(file, *bytes);
}

}  // namespace gouge
