#include "toolmodels/import/json_entry.h"

namespace gouge::detail {

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

}  // namespace gouge::detail
