#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/job/scene_files.h"
#include "cli/options/job_options.h"
#include "lib/certify/check.h"
#include "lib/machine/machine.h"
#include "postproc/report/report_model.h"
#include "toolmodels/assembly.h"

namespace gouge {

/// Content that a command adds to the report of a job beside the verdicts.
struct ReportParts {
  std::optional<CorrectionFacts> correction = {};
  std::vector<OptionText> more_options = {};
  Diagnostics notes = {};
  std::optional<StickoutOptions> stickout_options = {};
  std::vector<StickoutFacts> stickouts = {};
  std::optional<CureOptions> cure_options = {};
  std::vector<FindingCures> cures = {};
  std::string_view certificate_bytes = {};
};

/// Everything a check needs, read and understood. Tools point into `variants`: move a Job, do not copy it.
struct Job {
  JobOptions options;
  Toolpath toolpath;
  std::shared_ptr<const SceneFiles> files;              ///< what stands still, and heads; other jobs may share it
  std::vector<std::optional<ToolAssembly>> assemblies;  ///< one per Toolpath::tools; empty where it has no definition
  std::vector<std::optional<ToolVariants>> variants;    ///< of these
  std::vector<InputFile> inputs;
  std::vector<ToolFacts> tool_facts;
  SetupBasis basis;                     ///< how the inputs are known
  std::optional<Machine> machine = {};  ///< of --machine
  TurnLaws laws = {};                   ///< of its motions
  Diagnostics notes;
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();  ///< of the work on it

  Job() = default;
  Job(Job&&) = default;
  Job& operator=(Job&&) = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  [[nodiscard]] const Scene& scene() const { return files->scene; }
  [[nodiscard]] const std::vector<HeadBody>& heads() const { return files->heads; }
  [[nodiscard]] std::vector<const ToolVariants*> tools() const;
  /// --extend-up for a tool of this job: as high as the farthest point of the scene, and the widest radius more: its end
  /// is nearest to nothing.
  [[nodiscard]] ToolAssembly without_end(const ToolAssembly& tool) const;
  /// `prepared` is the scene of the job; both must outlive the result.
  [[nodiscard]] CheckSetup setup(const PreparedScene& prepared) const;
  /// As requested, else the toolpath's.
  [[nodiscard]] LengthUnit stl_unit(const JobArguments& arguments) const;
  /// The report of `result`, which must outlive it, like the job.
  [[nodiscard]] ReportModel report(const JobArguments& arguments, const Toolpath& path, const CheckResult& result,
                                   ReportParts parts) const;
};

struct LoadedJob {
  std::optional<Job> job;
  Diagnostics errors;
};

/// Reads toolpath and tools, and takes the meshes from `scenes`. All errors of one kind of input are reported, not the
/// first alone.
[[nodiscard]] LoadedJob load_job(const JobArguments& arguments, const JobOptions& options, Progress& progress,
                                 const SceneSource& scenes = load_scene);

/// The `bytes` of a corrected toolpath, to be called `file`, read as the path of `job`, which it was made from.
/// Errors: those of the reader; they would be a fault of ours.
[[nodiscard]] Result<Toolpath> read_again(const Job& job, const std::string& file, std::string bytes);

}  // namespace gouge
