#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "lib/base/file_search.h"
#include "lib/base/result.h"
#include "toolmodels/import/catalogue_tool.h"
#include "toolmodels/import/import_tools.h"

namespace gouge {

/// Adds catalogue tools to the library, and collects the notes about each. Tool numbers stay unique: the first tool
/// with a number keeps it.
class Collector {
 public:
  Collector(std::string file, const ImportOptions& options);

  /// Counts a tool of the file under its number and its name. To be called once for each, also if it is left out later.
  void count(const std::optional<int>& number, const std::string& name);
  void add(CatalogueTool tool);
  void add_holder(NamedHolder holder, LengthUnit unit, std::size_t line);
  /// Reports that the tool `who` was left out because its shape cannot be expressed.
  void leave_out(const std::string& who, const std::string& shape, std::size_t line);
  /// Adds a diagnostic about the tool `who`, with file and line.
  void report(const std::string& who, const Diagnostic& diagnostic, std::size_t line);

  [[nodiscard]] const ImportOptions& options() const { return options_; }
  [[nodiscard]] const std::string& file() const { return made_.library.file; }

  /// Returns the library with its notes. Adds a note if the library has no tool.
  [[nodiscard]] ImportedTools finish();

 private:
  void report_of(const CatalogueTool& tool, const std::string& who, Diagnostic diagnostic);
  void assign_number(ToolAssembly& tool, std::size_t line);

  const ImportOptions& options_;
  ImportedTools made_;
  std::unordered_set<int> numbers_;  // tool numbers already in use
  std::map<int, std::size_t> tools_of_number_;
  std::map<std::string, std::size_t> tools_of_name_;
  bool is_all_inch_ = true;
};

/// Returns the name of a tool of another program's file in messages: its number and its name, as far as it has them.
[[nodiscard]] std::string tool_label(const std::optional<int>& number, const std::string& name);

/// Returns the number if this project can store it as a tool number.
[[nodiscard]] std::optional<int> tool_number(long long number);

struct BesideFile {
  std::string path;
  std::string bytes;
};

/// Reads the file that a tool library names `name` (SearchRule::named_by_tools). The search for it is added to `searches`.
///
/// Errors   (1) file-not-found, with both places. (2) import-beside: several files differ in case alone. (3) Those of
///          read_file.
[[nodiscard]] Result<BesideFile> read_beside(const std::string& library_file, const std::string& name,
                                             std::uint64_t max_bytes, SearchLog& searches);

}  // namespace gouge
