#pragma once

#include <memory>
#include <vector>

#include "cli/library/content.h"
#include "cli/machine/machine_choice.h"
#include "lib/certify/check.h"
#include "postproc/report/report_model.h"

namespace gougecheck {

/// The tools of one path, compiled as the options state. They must stay where they are.
struct PathTools {
  std::vector<std::optional<gouge::ToolVariants>> variants;  // one per Toolpath::tools; empty: no definition
  std::vector<gouge::ToolFacts> facts;
  gouge::Diagnostics notes;
  gouge::Assumptions assumptions;  // of the tools and their holders
  std::string file;                // of the library; empty: from memory

  [[nodiscard]] std::vector<const gouge::ToolVariants*> pointers() const;
};

/// The machine of a check.
struct PathMachine {
  gouge::ChosenMachine chosen;
  std::vector<gouge::OptionText> options;     // as the program records them
  std::optional<gouge::InputFile> file = {};  // none: a preset
};

/// All that a path is checked with, shared by the reports on it. Immutable.
struct CheckedPath {
  Path path;
  Scene scene;
  std::shared_ptr<const PathTools> tools;
  gouge::CheckOptions options;
  gouge::SetupBasis basis;
  std::shared_ptr<const PathMachine> machine;  // null: the axis turns on the great circle

  /// Returns the set-up. Path and tools must outlive it, like `heads`, which are none.
  [[nodiscard]] gouge::CheckSetup setup() const;
  [[nodiscard]] gouge::ReportModel model(const gouge::CheckResult& result) const;
  /// Returns the files that were read for it.
  [[nodiscard]] std::vector<std::string> inputs() const;
};

/// Errors: a length that is negative, too long or no number.
[[nodiscard]] gouge::CheckOptions to_check_options(const CheckOptions& options);

/// Compiles a tool for `options`. Errors: those of make_tool_variants.
[[nodiscard]] gouge::ToolVariants compile(const gouge::ToolAssembly& tool, const gouge::CheckOptions& options,
                                          bool has_wide = false);

/// Prepares a check of every move with this tool. Errors: tool-ambiguous, where the path calls several.
[[nodiscard]] CheckedPath prepare(const Path& path, const Scene& scene, const Tool& tool, const CheckOptions& options);
/// Prepares a check with each tool by number or name, else as the path defines it. Errors: no-tool, where none is
/// defined.
[[nodiscard]] CheckedPath prepare(const Path& path, const Scene& scene, const ToolLibrary& library,
                                  const CheckOptions& options);

[[nodiscard]] Report make_report(CheckedPath checked, gouge::CheckResult result);

}  // namespace gougecheck
