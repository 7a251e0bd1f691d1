#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/reading_options.h"
#include "postproc/accept/accepted.h"
#include "postproc/report/report_model.h"

namespace CLI {
class App;
}

namespace gouge {

/// --baseline, of commands that check.
void add_baseline_option(CLI::App& command, std::string& file);

/// The accepted findings of --baseline as they were read, before the work.
struct LoadedBaseline {
  std::string file;  ///< empty: none is given
  InputFile input;
  std::vector<Acceptance> accepted;

  /// States in a result what is accepted of it, and that the file was read.
  void apply(ReportModel& model) const;
};

/// Errors: those of read_file and read_accepted. An empty name is not a baseline.
[[nodiscard]] Result<LoadedBaseline> load_baseline(const std::string& file, const InputLimit& limit);

}  // namespace gouge
