#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "lib/base/units.h"
#include "lib/json/json_file.h"
#include "toolmodels/assembly.h"
#include "toolmodels/import/quantity.h"

// What the importers of JSON formats share.

namespace gouge::detail {

/// Of a file to import, where `what` was expected: "a Fusion tool library".
[[nodiscard]] JsonKind imported_kind(const std::string& what);

/// The cleaned text of `key`; empty when there is none or it is no text.
[[nodiscard]] std::string text_of(const nlohmann::json& object, const char* key);

/// A number, or a text with a unit. A bare number is in mm_per(unit), or degrees when `angle`. Nothing for
/// null.
/// Errors   import-field, naming `key`.
[[nodiscard]] Result<std::optional<Quantity>> quantity_of(const nlohmann::json& value, const std::string& key,
                                                          LengthUnit unit, bool angle);

}  // namespace gouge::detail
