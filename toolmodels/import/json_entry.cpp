#include "toolmodels/import/json_entry.h"

#include <algorithm>
#include <initializer_list>

#include "lib/base/file_kind.h"

namespace gouge::detail {

namespace {

// Returns whether `key` is a list that is empty or has an object with one of `members`.
bool has_list_with(const nlohmann::json& root, const char* key, std::initializer_list<const char*> members) {
  const auto list = root.find(key);
  if (list == root.end() || !list->is_array()) return false;
  return list->empty() || std::any_of(list->begin(), list->end(), [&](const nlohmann::json& entry) {
           return std::any_of(members.begin(), members.end(),
                              [&](const char* member) { return entry.is_object() && entry.contains(member); });
         });
}

}  // namespace

JsonKind imported_kind(const std::string& what) { return {"import-syntax", "import-duplicate-key", what}; }

std::string text_of(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? clean_text(found->get<std::string>()) : std::string();
}

Result<std::optional<Quantity>> quantity_of(const nlohmann::json& value, const std::string& key, LengthUnit unit,
                                            bool angle) {
  if (value.is_null()) return std::optional<Quantity>();
  std::optional<Quantity> quantity;
  if (value.is_number()) quantity = Quantity{value.get<double>(), QuantityUnit::none, false};
  if (value.is_string()) {
    quantity = parse_quantity(value.get<std::string>());
    if (!quantity)
      return make_error("import-field", key + " is \"" + clean_text(value.get<std::string>()) +
                                            "\"; expected a number and a unit, such as \"6.0 mm\"");
  }
  if (!quantity) return make_error("import-field", key + " is neither a number nor a text; expected a number");
  const bool is_degrees = quantity->unit == QuantityUnit::degree;
  if (quantity->unit != QuantityUnit::none && is_degrees != angle)
    return make_error("import-field", key + " has the unit of " +
                                          (angle ? "a length; expected an angle" : "an angle; expected a length"));
  if (quantity->unit == QuantityUnit::none && !angle) quantity->value *= mm_per(unit);
  return quantity;
}

std::string_view without_mark(std::string_view bytes) { return trim_blanks(without_byte_order_mark(bytes)); }

bool is_json(std::string_view bytes) {
  const std::string_view text = without_mark(bytes);
  return text.starts_with('{') || text.starts_with('[');
}

bool is_freecad_bit(const nlohmann::json& root) {
  return root.is_object() && root.contains("parameter") && (root.contains("shape") || root.contains("shape-type"));
}

bool is_freecad_library(const nlohmann::json& root) { return has_list_with(root, "tools", {"path"}); }

bool is_fusion_library(const nlohmann::json& root) { return has_list_with(root, "data", {"geometry", "segments"}); }

}  // namespace gouge::detail
