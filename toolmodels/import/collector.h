#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "lib/base/result.h"
#include "toolmodels/import/catalogue_tool.h"
#include "toolmodels/import/import_tools.h"

namespace gouge {

/// Turns catalogue tools into the library's, and keeps account of what had to be stated about each. Numbers
/// stay unique: the first tool of a number keeps it.
class Collector {
 public:
  Collector(std::string file, const ImportOptions& options);

  void add(CatalogueTool tool);
  void add_holder(NamedHolder holder, LengthUnit unit, std::size_t line);
  /// `who` was left out because its shape cannot be expressed.
  void leave_out(const std::string& who, const std::string& shape, std::size_t line);
  /// A diagnostic about `who`, with file and line filled in.
  void report(const std::string& who, const Diagnostic& diagnostic, std::size_t line);

  [[nodiscard]] const ImportOptions& options() const { return options_; }
  [[nodiscard]] const std::string& file() const { return made_.library.file; }

  /// States so in the notes when nothing is left.
  [[nodiscard]] ImportedTools finish();

 private:
  void report_of(const CatalogueTool& tool, const std::string& who, Diagnostic diagnostic);
  void assign_number(ToolAssembly& tool, std::size_t line);

  const ImportOptions& options_;
  ImportedTools made_;
  std::unordered_set<int> numbers_;  // taken
  bool is_all_inch_ = true;
};

/// Returns how messages call a tool of another program's file: its number and name as far as it has them.
[[nodiscard]] std::string tool_label(const std::optional<int>& number, const std::string& name);

/// Returns a tool number that this project can hold.
[[nodiscard]] std::optional<int> tool_number(long long number);

struct BesideFile {
  std::string path;  ///< where it was found; the first place that was tried where it was not
  std::string bytes;
};

/// Reads the file that a tool library names `name`: in the library's folder, else in the folder Bit beside that, where
/// FreeCAD keeps them. Where none has exactly this name, upper and lower case count as equal.
///
/// Errors   (1) file-not-found with both places. (2) import-beside where several files differ in case alone. (3) Those
///          of read_file.
[[nodiscard]] Result<BesideFile> read_beside(const std::string& library_file, const std::string& name,
                                             std::uint64_t max_bytes);

}  // namespace gouge
