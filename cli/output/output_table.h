#pragma once

#include <string>
#include <vector>

#include "cli/options/job_options.h"
#include "lib/base/result.h"
#include "lib/base/text_writer.h"
#include "postproc/export/write_scene.h"

namespace gouge {

struct ReportModel;

/// One output of a command line. Whatever protects files, keeps standard output apart or writes goes by these
/// tables alone, so an output that is in none cannot be asked for.
struct Output {
  enum class Kind { file, report_folder };

  std::string option;  ///< "--csv"
  std::string file;    ///< as the user named it; "-": standard output, for a file
  Kind kind = Kind::file;
  void (*write)(const ReportModel&, const PutText&) = nullptr;  ///< of `check` and `correct`, for a file
  WriteScene write_scene = nullptr;                             ///< in place of it, for an exported scene
};

using OutputTable = std::vector<Output>;

/// The outputs asked for of `check` and `correct`, where `corrected` is what -o names, or empty.
[[nodiscard]] OutputTable outputs_of(const JobArguments& arguments, const std::string& corrected);

/// Those of `outputs` that are asked for: without empty names.
[[nodiscard]] OutputTable asked_for(const OutputTable& outputs);

/// Whether one of them is "-", so that standard output belongs to it alone. Errors: usage, for more than one.
[[nodiscard]] Result<bool> is_stdout_taken(const OutputTable& outputs);

/// The folder of --report, or empty.
[[nodiscard]] std::string report_folder_of(const OutputTable& outputs);

}  // namespace gouge
