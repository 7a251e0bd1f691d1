#pragma once

#include <memory>
#include <vector>

#include "cli/library/content.h"
#include "cli/machine/machine_choice.h"
#include "lib/certify/check.h"
#include "postproc/report/report_model.h"

namespace gougecheck {

/// The compiled tools of one path. Other objects point to them, so they must not move.
struct PathTools {
  std::vector<std::optional<gouge::ToolVariants>> variants;  // one for each of Toolpath::tools; empty: no definition
  std::vector<gouge::ToolFacts> facts;
  gouge::Diagnostics notes;
  gouge::Assumptions assumptions;                              // about the tools and their holders
  std::vector<gouge::InputFile> files;                         // of the library; empty: from memory
  bool is_by_facts = false;                                    // read with facts that the file does not state
  std::vector<std::optional<gouge::ToolAssembly>> assemblies;  // one for each of Toolpath::tools

  [[nodiscard]] std::vector<const gouge::ToolVariants*> pointers() const;
};

struct PathStock;

/// The machine of a check.
struct PathMachine {
  gouge::ChosenMachine chosen;
  std::vector<gouge::OptionText> options;     // the options as the program records them
  std::optional<gouge::InputFile> file = {};  // none: the machine is a preset
  std::string key = {};                       // machine_key
};

/// All inputs of the check of a path, shared by the reports on it. Immutable.
struct CheckedPath {
  Path path;
  Scene scene;
  std::shared_ptr<const PathTools> tools;
  gouge::CheckOptions options;
  gouge::MotionTube stated_tube;  // of the options and the control, without the addition for intervals
  gouge::SetupBasis basis;
  std::shared_ptr<const PathMachine> machine;  // null: the axis turns on the great circle
  std::shared_ptr<const PathStock> stock;      // null: moves are not checked against remaining stock

  /// Returns the set-up, which has no heads. Path and tools must outlive it.
  [[nodiscard]] gouge::CheckSetup setup() const;
  [[nodiscard]] gouge::ReportModel model(const gouge::CheckResult& result) const;
  /// Returns the names of the files that were read for this check.
  [[nodiscard]] std::vector<std::string> inputs() const;
};

/// Returns the path with an additional tool for moves for which its file names none.
[[nodiscard]] Path with_every_tool_named(const Path& path);

/// Returns a path with the joints of a machine, and with warnings if the machine cannot run it.
[[nodiscard]] gouge::Toolpath joints_added(gouge::Toolpath path, const PathMachine& machine);

/// Converts the options. Errors: a length that is negative, too long or not a number.
[[nodiscard]] gouge::CheckOptions to_check_options(const CheckOptions& options);

/// Compiles a tool for `options`. Errors: those of make_tool_variants.
[[nodiscard]] gouge::ToolVariants compile(const gouge::ToolAssembly& tool, const gouge::CheckOptions& options,
                                          bool has_wide = false);

/// Prepares a check of every move with this tool. Errors: tool-ambiguous, if the path calls several tools.
[[nodiscard]] CheckedPath prepare(const Path& path, const Scene& scene, const Tool& tool, const CheckOptions& options);
/// Prepares a check in which each tool comes from the library by number or name, else from the path's own definition.
/// Errors: no-tool, if neither defines it.
[[nodiscard]] CheckedPath prepare(const Path& path, const Scene& scene, const ToolLibrary& library,
                                  const CheckOptions& options);

[[nodiscard]] Report make_report(CheckedPath checked, gouge::CheckResult result);

}  // namespace gougecheck
