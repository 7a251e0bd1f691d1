#pragma once

#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "toolmodels/assembly.h"
#include "toolmodels/import/dimensions.h"

// Converts catalogue dimensions to a cutter shape of this project that describes the same tool exactly.

namespace gouge {

/// Shapes of catalogues; a shape determines which dimensions count, and their meaning.
enum class CatalogueShape {
  flat,
  ball,
  bull_nose,
  tapered,       ///< diameter is that at which the side, extended downwards, meets the tip plane
  tapered_ball,  ///< diameter is that of the ball at the tip
  chamfer,       ///< diameter is the largest; a cone from tip_diameter up to it, then a cylinder
  drill,         ///< a conical point of point_angle, then a cylinder
  face,          ///< an edge that leans outward by taper_angle up to the largest diameter, or no such edge
  full,          ///< threads and edges, which are taken as a full cylinder; this is reported
  slot,
  saw,
  dovetail,  ///< diameter is that of the bottom
  lollipop,
  probe,   ///< the shape of a lollipop; it removes no stock
  radius,  ///< rounds edges; diameter is that of the small end
  center_drill,
  barrel,
  oval,
  lens,
  taper_segment,
  five_numbers,  ///< NX: diameter where bottom and side meet, corner radius, taper and bottom angle
};

struct CatalogueCutter {
  Cutter cutter;
  double top_diameter_mm = 0;
};

/// Errors   import-field, and those of make_cutter_profile. The message does not name the tool; the caller adds the
///          name.
/// Notes    import-contradiction, import-guess.
[[nodiscard]] Result<CatalogueCutter> make_catalogue_cutter(CatalogueShape shape, const Dimensions& dimensions,
                                                            Diagnostics& notes);

}  // namespace gouge
