#pragma once

#include <nlohmann/json.hpp>
#include <string>

// Words for JSON values in the messages about a tool library.

namespace gouge::detail {

/// Returns the type of a value: "a text", "a number", "a list", "an object", "null", "true or false".
[[nodiscard]] const char* type_word(const nlohmann::json& value);

/// Returns the end of a message about a missing key, which names the keys that the object has: one of them may be
/// mistyped. Empty if it has none.
[[nodiscard]] std::string keys_text(const nlohmann::json& object);

}  // namespace gouge::detail
