#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lib/geom/vec.h"

namespace gouge {

using Json = nlohmann::ordered_json;  ///< keys stay in the order they are written

/// Returns [x, y, z] in the unit of `mm_per_unit` mm; use 1 for a direction. Zero has no sign.
[[nodiscard]] inline Json point_json(const Vec3& v_mm, double mm_per_unit) {
  return Json::array({v_mm.x() / mm_per_unit + 0.0, v_mm.y() / mm_per_unit + 0.0, v_mm.z() / mm_per_unit + 0.0});
}

/// Returns the text indented by two blanks, with a line end. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] inline std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gouge
