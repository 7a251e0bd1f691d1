#pragma once

#include <fcl/fcl.h>

#include <memory>

#include "lib/geom/pose.h"
#include "lib/mesh/indexed_mesh.h"

// Functions that the programs that measure FCL share.

namespace gouge::bench {

/// Trees of oriented boxes, which of FCL's forms grow least with the part.
using FclModel = fcl::BVHModel<fcl::OBBRSSd>;

[[nodiscard]] std::shared_ptr<FclModel> make_fcl_model(const IndexedMesh& mesh);

/// From one fixed frame, that of `like`, so that the way between two poses has no spin about the tool's axis.
[[nodiscard]] fcl::Transform3d fcl_transform(const Pose& pose, const Pose& like);

}  // namespace gouge::bench
