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

// Functions that importers of JSON formats share.

namespace gouge::detail {

/// Returns the kind of JSON of a file to import; `what` names the expected content, such as "a Fusion tool library".
[[nodiscard]] JsonKind imported_kind(const std::string& what);

/// Returns the cleaned text of `key`; empty if there is no such key or its value is not text.
[[nodiscard]] std::string text_of(const nlohmann::json& object, const char* key);

/// Returns a number, or a text with a unit. A bare number is in `unit`, or in degrees if `angle`. Returns nothing for
/// null.
/// Errors   import-field, with the name `key`.
[[nodiscard]] Result<std::optional<Quantity>> quantity_of(const nlohmann::json& value, const std::string& key,
                                                          LengthUnit unit, bool angle);

/// Returns the text of a file without its byte order mark and the blanks around it.
[[nodiscard]] std::string_view without_mark(std::string_view bytes);

/// Returns whether the text of a file begins like a JSON object or list.
[[nodiscard]] bool is_json(std::string_view bytes);

/// Returns whether a JSON file is a FreeCAD tool bit: it has "parameter" and a shape.
[[nodiscard]] bool is_freecad_bit(const nlohmann::json& root);

/// Returns whether a JSON file is a FreeCAD library: a list "tools" that is empty or has an entry with a "path".
[[nodiscard]] bool is_freecad_library(const nlohmann::json& root);

/// Returns whether a JSON file is a tool table of CAMotics, or a project with one: all its tools have "shape", "diameter"
/// and "units".
[[nodiscard]] bool is_camotics_table(const nlohmann::json& root);

/// Returns whether a JSON file is a Fusion library: a list "data" that is empty or has an entry with a "geometry" or
/// "segments".
[[nodiscard]] bool is_fusion_library(const nlohmann::json& root);

}  // namespace gouge::detail
