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

// Outputs of commands: files, or standard output for the name "-".

namespace gouge {

/// The outputs of one command, which appear together or not at all, as far as the system allows it.
class PendingOutputs {
 public:
  /// Writes `bytes` beside the place of `file`; `commit` puts them there. Bytes for "-" are kept. Errors:
  /// file-unwritable.
  [[nodiscard]] Outcome add(const std::string& file, std::string_view bytes);
  [[nodiscard]] Outcome add(const std::string& file, const TextWriter& write);
  /// Puts the files in their places, then writes the bytes for standard output to `out`. Errors: file-unwritable,
  /// output-unwritable.
  [[nodiscard]] Outcome commit(std::ostream& out);

 private:
  std::vector<StagedFile> files_;
  std::optional<std::string> for_stdout_;
};

/// Writes one file in the manner of PendingOutputs.
[[nodiscard]] Outcome write_output(const std::string& file, std::string_view bytes, std::ostream& out);

/// The name of a toolpath file without its folder, in two parts.
struct ToolpathName {
  std::string stem, ending;  ///< "op10", ".ncl.1": Creo appends a version to the ending
};

[[nodiscard]] ToolpathName split_toolpath_name(const std::string& file);

/// Finds errors that will prevent these outputs, as far as they are known before the work. The folder is missing or
/// closed to us, a folder has the name of the file, or the existing file could not keep its owner and mode. The folder
/// of a report may be missing if it can be made (code folder-unwritable). The name "-" is ignored. Creates and opens
/// nothing. Code: file-unwritable.
[[nodiscard]] Diagnostics find_unwritable(const OutputTable& outputs);

/// Errors of outputs, and the exit status for them.
struct RefusedOutputs {
  Diagnostics errors;
  int status = 0;
};

/// Finds errors in a command's outputs before its work. Two outputs are for standard output, one is an input or another
/// output, one is a file of a report or of a batch, or one cannot be written. A job of a batch (`is_of_batch`) writes its
/// corrected toolpath into that batch.
[[nodiscard]] RefusedOutputs find_refused(const std::vector<InputOption>& inputs, const OutputTable& outputs,
                                          bool is_of_batch = false);

/// Prints these errors and returns the exit status; returns none if there is no error.
[[nodiscard]] std::optional<int> refuse_outputs(const std::vector<InputOption>& inputs, const OutputTable& outputs,
                                                std::ostream& err, bool is_of_batch = false);

/// Returns whether the picture `file` is an SVG; else it is a PNG. Error (code usage) for an ending other than .svg and
/// .png, in upper or lower case.
[[nodiscard]] Result<bool> is_svg_file(const std::string& file);

/// Returns the note of find_missing_letters (postproc/image/font.h) about the names that a picture of this path may
/// show. They are those of the file, its tools and operations, and of `meshes`.
[[nodiscard]] Diagnostics find_missing_letters(const Toolpath& path, const std::vector<std::string>& meshes = {});

}  // namespace gouge
