#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/job/scene_files.h"
#include "cli/options/job_options.h"
#include "lib/base/file_search.h"
#include "lib/certify/check.h"
#include "lib/machine/machine.h"
#include "lib/motion/pose_reach.h"
#include "postproc/report/report_model.h"
#include "toolmodels/assembly.h"

namespace gouge {

/// Content that a command adds to the report of a job, besides the verdicts.
struct ReportParts {
  std::optional<CorrectionFacts> correction = {};
  std::vector<OptionText> more_options = {};
  Diagnostics notes = {};
  std::optional<StickoutOptions> stickout_options = {};
  std::vector<StickoutFacts> stickouts = {};
  std::optional<CureOptions> cure_options = {};
  std::vector<FindingCures> cures = {};
  std::vector<LawRecord> laws = {};
  std::string_view certificate_bytes = {};
  std::optional<StockLeft> stock_left = {};
  const IndexedMesh* shown_stock = nullptr;
};

/// All inputs of a check, read and understood. Tools point into `variants`: move a Job, do not copy it.
struct Job {
  JobOptions options;
  Toolpath toolpath;
  std::shared_ptr<const SceneFiles> files;  ///< parts, fixtures and heads; other jobs may share them
  /// one for each of Toolpath::tools; empty if the tool has no definition
  std::vector<std::optional<ToolAssembly>> assemblies;
  std::vector<std::optional<ToolVariants>> variants;  ///< compiled from `assemblies`
  std::vector<InputFile> inputs;
  SearchLog searches;  ///< for files that may be absent; those that were found are in `inputs` too
  std::vector<ToolFacts> tool_facts;
  SetupBasis basis;                     ///< how each input is known
  std::optional<Machine> machine = {};  ///< the machine of --machine
  TurnLaws laws = {};                   ///< the laws of its motions
  Diagnostics notes;
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();  ///< start of the work on the job

  Job() = default;
  Job(Job&&) = default;
  Job& operator=(Job&&) = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  [[nodiscard]] const Scene& scene() const { return files->scene; }
  [[nodiscard]] const std::vector<HeadBody>& heads() const { return files->heads; }
  [[nodiscard]] std::vector<const ToolVariants*> tools() const;
  /// Applies --extend-up to a tool of this job. The new height of the tool is the distance of the farthest point of the
  /// scene plus the largest radius. So no point is nearest to its end.
  [[nodiscard]] ToolAssembly without_end(const ToolAssembly& tool) const;
  /// Returns the set-up of the check. `prepared` is the scene of the job; both must outlive the result.
  [[nodiscard]] CheckSetup setup(const PreparedScene& prepared) const;
  /// Returns the poses that the machine can take near the path; null: there is no machine. The job must outlive it.
  [[nodiscard]] std::shared_ptr<const PoseReach> reach() const;
  /// Returns the requested unit, else that of the toolpath.
  [[nodiscard]] LengthUnit stl_unit(const JobArguments& arguments) const;
  /// Returns the report of `result`. Both the job and `result` must outlive it.
  [[nodiscard]] ReportModel report(const JobArguments& arguments, const Toolpath& path, const CheckResult& result,
                                   ReportParts parts) const;
};

struct LoadedJob {
  std::optional<Job> job;
  Diagnostics errors;
  SearchLog searches;  ///< those of the job, also of one that could not be read
};

/// Reads toolpath and tools, and takes the meshes from `scenes`. Reports all errors of one kind of input, not only the
/// first.
[[nodiscard]] LoadedJob load_job(const JobArguments& arguments, const JobOptions& options, Progress& progress,
                                 const SceneSource& scenes = load_scene);

/// Reads the `bytes` of a corrected toolpath, which gets the name `file`, as the path of `job` was read. Errors: those
/// of the reader, which would be errors of this program.
[[nodiscard]] Result<Toolpath> read_again(const Job& job, const std::string& file, std::string bytes);

}  // namespace gouge
