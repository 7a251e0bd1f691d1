#include "postproc/formats/read_toolpath.h"

#include <utility>

#include "lib/base/file_kind.h"
#include "postproc/formats/toolpath_format.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

Dialect dialect_of(std::string_view bytes, const ReadOptions& options) {
  Dialect dialect = options.dialect ? *options.dialect : recognise_dialect(bytes);
  // A program of a few blocks has no marks; the user who states a control, or a machine with one, has a program. The control
  // may be that of another file, such as the program that is compared with this CL data.
  const bool has_control = options.program && !options.program->control.empty();
  if (!options.dialect && dialect.is_fallback && has_control && !looks_like_cl_data(bytes)) dialect = gcode_dialect();
  return dialect;
}

ReadOutcome read_toolpath(const std::string& file_name, SourceText bytes, const ReadOptions& options,
                          const ProgressCall& progress) {
  const Dialect dialect = dialect_of(bytes, options);
  return format_called(dialect.format).read(file_name, std::move(bytes), dialect, options, progress);
}

}  // namespace gouge
