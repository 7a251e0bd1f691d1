#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/output/outputs.h"
#include "cli/output/overwriting.h"
#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/base/staged_file.h"
#include "lib/base/text_writer.h"
#include "lib/path/toolpath.h"

// Outputs of commands: files, or standard output where their name is "-".

namespace gouge {

/// The outputs of one command, which appear together or not at all, as far as the system lets them.
class PendingOutputs {
 public:
  /// Writes `bytes` so that only their place is missing; those for "-" are kept. Errors: file-unwritable.
  [[nodiscard]] Outcome add(const std::string& file, std::string_view bytes);
  [[nodiscard]] Outcome add(const std::string& file, const TextWriter& write);
  /// Puts the files in their places, then writes what belongs on `out`. Errors: file-unwritable,
  /// output-unwritable.
  [[nodiscard]] Outcome commit(std::ostream& out);

 private:
  std::vector<StagedFile> files_;
  std::optional<std::string> for_stdout_;
};

/// Writes one file as PendingOutputs.
[[nodiscard]] Outcome write_output(const std::string& file, std::string_view bytes, std::ostream& out);

/// Finds errors that will keep these outputs from being written, as far as they are known before the work. Their folder
/// is missing or closed to us, a folder has their name, or the file there could not keep its owner and mode. The folder
/// of a report may be missing if it can be made (code folder-unwritable). The name "-" is passed over. Creates and
/// opens nothing. Code: file-unwritable.
[[nodiscard]] Diagnostics find_unwritable(const OutputTable& outputs);

/// Finds errors in a command's outputs before its work. Two are for standard output, one is an input or another output,
/// or one cannot be written. Prints the error and returns the exit status; none where all is well.
[[nodiscard]] std::optional<int> refuse_outputs(const std::vector<InputOption>& inputs, const OutputTable& outputs,
                                                std::ostream& err);

/// Returns whether the picture `file` is to be an SVG; else a PNG. Error (code usage) for another ending than .svg and
/// .png, in any case.
[[nodiscard]] Result<bool> is_svg_file(const std::string& file);

/// Returns the note of find_missing_letters (postproc/image/font.h) on the names that a picture of this path may show.
/// They are those of the file, its tools and operations, and of `meshes`.
[[nodiscard]] Diagnostics find_missing_letters(const Toolpath& path, const std::vector<std::string>& meshes = {});

}  // namespace gouge
