#include "cli/options/baseline.h"

#include <CLI/CLI.hpp>

#include "lib/base/files.h"
#include "postproc/accept/apply_baseline.h"

namespace gouge {

void add_baseline_option(CLI::App& command, std::string& file) {
  command
      .add_option("--baseline", file,
                  "File of accepted findings ('gougecheck accept'). They are counted and listed separately as long "
                  "as nothing has changed")
      ->type_name("FILE")
      ->group("Check");
}

void LoadedBaseline::apply(ReportModel& model) const {
  if (file.empty()) return;
  model.inputs.push_back(input);
  model.baseline = apply_baseline(file, accepted, model);
}

Result<LoadedBaseline> load_baseline(const std::string& file, const InputLimit& limit) {
  LoadedBaseline loaded;
  if (file.empty()) return loaded;
  const Result<std::string> bytes = read_file(file, limit.max_bytes);
  if (!bytes) return bytes.error();
  Result<std::vector<Acceptance>> accepted = read_accepted(file, *bytes);
  if (!accepted) return accepted.error();
  loaded.file = file;
  loaded.input = describe_input("baseline", file, *bytes);
  loaded.accepted = std::move(*accepted);
  return loaded;
}

}  // namespace gouge
