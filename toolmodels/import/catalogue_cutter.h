#pragma once

#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "toolmodels/assembly.h"
#include "toolmodels/import/dimensions.h"

// From catalogue dimensions to the cutter shapes of this project, where these are exactly the tool.

namespace gouge {

/// Dimensions that count, and their meaning.
enum class CatalogueShape {
  flat,
  ball,
  bull_nose,
  tapered,       ///< diameter is where the side, going on down, meets the tip plane
  tapered_ball,  ///< diameter is that of the ball at the tip
  chamfer,       ///< diameter is the largest; a cone from tip_diameter up to it, then straight
  drill,         ///< a point of point_angle
  face,          ///< an edge leaning outward by taper_angle up to the largest diameter, or none
  full,          ///< threads and edges that are taken as a full cylinder, which is reported
  slot,
  saw,
  dovetail,  ///< diameter is that of the bottom
  lollipop,
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

/// Errors   import-field, and those of make_cutter_profile; without the tool's name, which the caller knows.
/// Notes    import-contradiction, import-guess.
[[nodiscard]] Result<CatalogueCutter> make_catalogue_cutter(CatalogueShape shape, const Dimensions& dimensions,
                                                            Diagnostics& notes);

}  // namespace gouge
