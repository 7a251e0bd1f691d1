#include "postproc/formats/read_toolpath.h"

#include <utility>

#include "postproc/formats/toolpath_format.h"

namespace gouge {

ReadOutcome read_toolpath(const std::string& file_name, SourceText bytes, const ReadOptions& options,
                          const ProgressCall& progress) {
  const Dialect dialect = options.dialect ? *options.dialect : recognise_dialect(bytes);
  return format_called(dialect.format).read(file_name, std::move(bytes), dialect, options, progress);
}

}  // namespace gouge
