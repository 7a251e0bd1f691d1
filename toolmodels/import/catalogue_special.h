#pragma once

#include "toolmodels/import/catalogue_cutter.h"

namespace gouge {

/// Input that the builders of cutters share: the dimensions of a file, and the notes about them.
class CatalogueMaker {
 public:
  CatalogueMaker(const Dimensions& d, Diagnostics& notes) : d_(d), notes_(notes) {}

 protected:
  // Two numbers that differ by more than this contradict each other. Files round numbers to a few decimals, also in
  // inches.
  static constexpr double kAgree_mm = 5e-3;

  [[nodiscard]] double at(Dimension dimension) const { return d_.value_or(dimension, 0); }
  [[nodiscard]] static Diagnostic missing(const std::string& what) {
    return make_error("import-field", "the file gives no " + what + "; this shape needs one");
  }
  void guess(const std::string& message) { notes_.push_back(make_note("import-guess", message)); }
  void contradiction(const std::string& message) { notes_.push_back(make_warning("import-contradiction", message)); }

  const Dimensions& d_;
  Diagnostics& notes_;
};

/// Makes the cutter of a shape other than end mills, drills and chamfers. These are slot and dovetail mills, lollipops,
/// saws, radius mills, centre drills and circle segments. Requires that the signs of the dimensions have been checked.
///
/// Errors   import-field: a dimension that is missing or impossible.
/// Notes    import-contradiction, import-guess.
[[nodiscard]] Result<Cutter> make_special_cutter(CatalogueShape shape, const Dimensions& dimensions,
                                                 Diagnostics& notes);

}  // namespace gouge
