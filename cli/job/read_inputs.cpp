#include "cli/job/read_inputs.h"

#include <utility>

#include "cli/machine/program_files.h"
#include "lib/base/files.h"
#include "lib/check/reach.h"
#include "toolmodels/import/read_any_tools.h"

namespace gouge {

std::optional<Toolpath> read_path_file(const std::string& file, const char* role, std::uint64_t max_bytes,
                                       const ReadOptions& reading, Progress& progress, std::vector<InputFile>& inputs,
                                       SearchLog& searches, Diagnostics& errors) {
  progress.begin("reading " + file);
  Result<PagedVector<char>> bytes = read_long_file(file, max_bytes);
  if (!bytes) {
    errors.push_back(bytes.error());
    return std::nullopt;
  }
  SourceText text(std::move(*bytes));
  inputs.push_back(describe_input(role, file, text));
  ReadOptions with_programs = reading;
  std::optional<Diagnostic> unreadable;
  with_programs.program = with_files_beside(
      reading.program, file, max_bytes, searches, [&](const std::string& beside, const Result<std::string>& read) {
        if (read) return inputs.push_back(describe_input(rule_name(SearchRule::program_beside), beside, *read));
        if (!unreadable) unreadable = read.error();
      });
  ReadOutcome outcome = read_toolpath(file, std::move(text), with_programs, progress.call());
  errors.insert(errors.end(), outcome.errors.begin(), outcome.errors.end());
  if (unreadable) errors.push_back(*unreadable);
  if (!outcome.toolpath || unreadable) return std::nullopt;
  for (const Move& move : outcome.toolpath->moves) {
    if (is_within_reach(move.end.tip)) continue;
    errors.push_back(make_error(
        "path-too-far", "the position is more than 100 m from the origin; expected a path within that; check the units",
        file, move.line));
    return std::nullopt;
  }
  return std::move(*outcome.toolpath);
}

Result<ToolLibrary> read_tool_file(const std::string& file, const char* role, std::uint64_t max_bytes,
                                   std::vector<InputFile>& inputs, SearchLog& searches) {
  const Result<std::string> bytes = read_file(file, max_bytes);
  if (!bytes) return bytes.error();
  inputs.push_back(describe_input(role, file, *bytes));
  Result<ReadTools> read = read_any_tools(file, *bytes, max_bytes, searches);
  if (!read) return read.error();
  for (const BesideFile& beside : read->besides)
    inputs.push_back(describe_input(rule_name(SearchRule::named_by_tools), beside.path, beside.bytes));
  return std::move(read->library);
}

}  // namespace gouge
