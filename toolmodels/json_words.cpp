#include "toolmodels/json_words.h"

#include <vector>

#include "lib/base/number_text.h"

namespace gouge::detail {

const char* type_word(const nlohmann::json& value) {
  if (value.is_string()) return "a text";
  if (value.is_number()) return "a number";
  if (value.is_array()) return "a list";
  if (value.is_object()) return "an object";
  return value.is_null() ? "null" : "true or false";
}

std::string keys_text(const nlohmann::json& object) {
  constexpr std::size_t kMaxKeys = 12;
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items())
    if (keys.size() < kMaxKeys) keys.push_back("\"" + key + "\"");
  return keys.empty() ? std::string() : ", and has " + listed(keys);
}

}  // namespace gouge::detail
