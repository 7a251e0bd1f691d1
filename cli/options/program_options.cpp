#include "cli/options/program_options.h"

#include <memory>
#include <utility>

#include "cli/options/reading_options.h"
#include "lib/base/files.h"
#include "postproc/gcode/reading/read_gcode.h"

namespace gouge {

std::vector<std::string> control_ids() {
  std::vector<std::string> ids;
  for (const ProgramLanguage& language : all_languages()) ids.emplace_back(language.id);
  return ids;
}

std::optional<Diagnostic> read_tool_lengths(const ReadingArguments& arguments, std::uint64_t max_bytes,
                                            ReadOptions& options, std::string& bytes) {
  const std::string& file = arguments.tool_lengths;
  if (file.empty()) return std::nullopt;
  Result<std::string> read = read_file(file, max_bytes);
  if (!read) return read.error();
  bytes = std::move(*read);
  Result<ToolTable> table = parse_tool_lengths(file, bytes);
  if (!table) return table.error();
  ProgramSetup setup = options.program ? *options.program : ProgramSetup{};
  take_tool_table(std::move(*table), setup);
  options.program = std::make_shared<const ProgramSetup>(std::move(setup));
  return std::nullopt;
}

}  // namespace gouge
