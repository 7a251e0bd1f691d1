#include "postproc/formats/write_corrected.h"

#include "postproc/cldata/rewriting/rewriters.h"
#include "postproc/formats/toolpath_format.h"

namespace gouge {

Result<std::string> write_corrected(const Toolpath& path, const std::vector<PathChange>& changes) {
  if (auto error = find_wrong_change(path, changes)) return std::move(*error);
  const Result<Edits> edits = format_of(path).rewrite(path, changes);
  if (!edits) return edits.error();
  return apply_edits(path.source, *edits);
}

RewritableMoves rewritable_moves(const Toolpath& path) {
  const auto records = format_of(path).records(path);
  return rewritable_moves(path, *records, ArcText(path, *records));
}

}  // namespace gouge
