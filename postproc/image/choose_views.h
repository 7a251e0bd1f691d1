#pragma once

#include <vector>

#include "postproc/image/picture_events.h"
#include "postproc/image/picture_scene.h"
#include "postproc/image/view.h"

namespace gouge {

/// `count` directions to look at the part from, out of the faces and corners of a cube and the mean tool
/// axis: the one that shows the most of what is gouged (gouge_witnesses.h) and the worst events, then the best that differs by 50
/// degrees. Without gouges the usual view from above the tool and the one opposite.
[[nodiscard]] std::vector<Vec3> choose_directions(const CheckedToolpath& input, const PictureScene& scene,
                                                  const std::vector<PictureEvent>& events, std::size_t count);

}  // namespace gouge
