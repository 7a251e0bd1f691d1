#pragma once

#include "toolmodels/import/catalogue_cutter.h"

namespace gouge {

/// The shapes beyond end mills, drills and chamfers: slot and dovetail mills, lollipops, saws, radius mills,
/// centre drills, circle segments. Requires signs that have been checked.
///
/// Errors   import-field: a dimension that is missing or impossible.
/// Notes    import-contradiction, import-guess.
[[nodiscard]] Result<Cutter> make_special_cutter(CatalogueShape shape, const Dimensions& dimensions,
                                                 Diagnostics& notes);

}  // namespace gouge
