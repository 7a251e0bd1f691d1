#include "postproc/record/record_schema.h"

#include <nlohmann/json.hpp>

#include "postproc/record/result_fields.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

/// A visitor that states the kind and the limits of each field of a record.
class SchemaMaker {
 public:
  void constant(const char* key, const char* value) { add(key, {{"const", value}}); }
  void constant(const char* key, int value) { add(key, {{"const", value}}); }
  void unit(const char* key, LengthUnit /*value*/) {
    add(key, {{"enum", {unit_name(LengthUnit::mm), unit_name(LengthUnit::inch)}}});
  }

  void text(const char* key, const std::string& /*value*/) { add(key, {{"type", "string"}}); }
  void optional_text(const char* key, const std::optional<std::string>& /*value*/) {
    add(key, {{"type", {"string", "null"}}});
  }
  void flag(const char* key, bool /*value*/) { add(key, {{"type", "boolean"}}); }
  template <typename Count>
  void count(const char* key, Count /*value*/, std::size_t min = 0) {
    add(key, {{"type", "integer"}, {"minimum", min}});
  }
  void optional_count(const char* key, const std::optional<std::size_t>& /*value*/, std::size_t min = 0) {
    add(key, {{"type", {"integer", "null"}}, {"minimum", min}});
  }
  void number(const char* key, double /*value*/, Sign sign) { add(key, limited({{"type", "number"}}, sign)); }
  void optional_number(const char* key, const std::optional<double>& /*value*/, Sign sign) {
    add(key, limited({{"type", {"number", "null"}}}, sign));
  }
  void length(const char* key, double value_mm, Sign sign) { number(key, value_mm, sign); }
  void optional_length(const char* key, const std::optional<double>& value_mm, Sign sign) {
    optional_number(key, value_mm, sign);
  }
  void per_length(const char* key, double value_per_mm, int /*power*/) {
    number(key, value_per_mm, Sign::non_negative);
  }
  void point(const char* key, const Vec3& /*value_mm*/) {
    add(key, {{"type", "array"}, {"minItems", 3}, {"maxItems", 3}, {"items", {{"type", "number"}}}});
  }
  void direction(const char* key, const Vec3& value) { point(key, value); }

  template <typename Value>
  void word(const char* key, const Value& /*value*/, const Words& words) {
    add(key, {{"enum", words}});
  }
  template <typename Enum>
  void optional_word(const char* key, const std::optional<Enum>& /*value*/, const Words& words) {
    Json all = words;
    all.push_back(nullptr);
    add(key, {{"enum", std::move(all)}});
  }
  template <typename Enum>
  void words(const char* key, const std::vector<Enum>& /*values*/, const Words& words) {
    add(key, list_of({{"enum", words}}));
  }
  void texts(const char* key, const std::vector<std::string>& /*values*/) { add(key, list_of({{"type", "string"}})); }
  void counts(const char* key, const std::vector<std::size_t>& /*values*/) {
    add(key, list_of({{"type", "integer"}, {"minimum", 0}}));
  }
  void counts_by_word(const char* key, const std::map<std::string, std::size_t>& /*values*/) {
    add(key, {{"type", "object"}, {"additionalProperties", {{"type", "integer"}, {"minimum", 1}}}});
  }
  void option_texts(const char* key, const OptionTexts& /*options*/) {
    const Json one_or_several = {{"type", {"string", "array"}}, {"items", {{"type", "string"}}}};
    add(key, {{"type", "object"}, {"additionalProperties", one_or_several}});
  }

  template <typename Record>
  void object(const char* key, const Record& value) {
    add(key, of_object(value, "object"));
  }
  template <typename Record>
  void optional_object(const char* key, const std::optional<Record>& /*value*/) {
    add(key, of_object(Record(), {"object", "null"}));
  }
  template <typename Record>
  void object_if_any(const char* key, const std::optional<Record>& /*value*/) {
    properties_[key] = of_object(Record(), "object");
  }
  template <typename Record>
  void list_if_any(const char* key, const std::vector<Record>& /*values*/) {
    properties_[key] = list_of(of_object(Record(), "object"));
  }
  template <typename Record>
  void list(const char* key, const std::vector<Record>& /*values*/) {
    add(key, list_of(of_object(Record(), "object")));
  }

  template <typename Record>
  [[nodiscard]] static Json of_object(const Record& value, const Json& type) {
    SchemaMaker inner;
    describe(inner, value);
    return {{"type", type},
            {"required", std::move(inner.required_)},
            {"additionalProperties", false},
            {"properties", std::move(inner.properties_)}};
  }

 private:
  static Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }
  static Json limited(Json kind, Sign sign) {
    if (sign == Sign::non_negative) kind["minimum"] = 0;
    return kind;
  }
  void add(const char* key, Json kind) {
    required_.push_back(key);
    properties_[key] = std::move(kind);
  }

  Json required_ = Json::array();
  Json properties_ = Json::object();
};

}  // namespace

std::string result_schema() {
  Json fields = SchemaMaker::of_object(ResultRecord(), "object");
  fields["required"].push_back("digest");
  fields["properties"]["digest"] = {{"type", "string"}};
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "Result of gougecheck"},
                 {"description",
                  "The result that gougecheck --json writes. Lengths are in the unit that \"unit\" names. "
                  "docs/formats/report_json.md explains the fields."}};
  schema.update(fields);
  return schema.dump(1) + "\n";
}

}  // namespace gouge
