#include "postproc/record/read_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "postproc/record/result_fields.h"

namespace gouge {
namespace {

/// A visitor that takes each field of a record from one object of a JSON text.
class RecordReader {
 public:
  RecordReader(const JsonField& object, double mm_per_unit) : object_(object), mm_per_unit_(mm_per_unit) {}

  void constant(const char* key, const char* value) { (void)object_.at(key).word({value}); }
  void constant(const char* key, int value) {
    const JsonField field = object_.at(key);
    if (field.count() != static_cast<std::size_t>(value)) field.fail(std::to_string(value));
  }
  void unit(const char* key, LengthUnit& value) {
    const bool is_inch = object_.at(key).word({unit_name(LengthUnit::mm), unit_name(LengthUnit::inch)}) == 1;
    value = is_inch ? LengthUnit::inch : LengthUnit::mm;
    mm_per_unit_ = mm_per(value);
  }

  void text(const char* key, std::string& value) { value = object_.at(key).text(); }
  void optional_text(const char* key, std::optional<std::string>& value) {
    if (const JsonField field = object_.at(key); !field.is_null()) value = field.text();
  }
  void flag(const char* key, bool& value) { value = object_.at(key).flag(); }
  template <typename Count>
  void count(const char* key, Count& value, std::size_t min = 0) {
    const JsonField field = object_.at(key);
    const std::size_t read = field.count();
    if (read < min) return field.fail("at least " + std::to_string(min));
    if (read > std::size_t{std::numeric_limits<Count>::max()}) return field.fail("a smaller number");
    value = static_cast<Count>(read);
  }
  void optional_count(const char* key, std::optional<std::size_t>& value, std::size_t min = 0) {
    if (object_.at(key).is_null()) return;
    count(key, value.emplace(), min);
  }
  void number(const char* key, double& value, Sign sign) {
    const JsonField field = object_.at(key);
    value = field.number();
    if (sign == Sign::non_negative && !(value >= 0)) field.fail("a number of 0 or more");
  }
  void optional_number(const char* key, std::optional<double>& value, Sign sign) {
    if (!object_.at(key).is_null()) number(key, value.emplace(), sign);
  }
  void length(const char* key, double& value_mm, Sign sign) {
    const JsonField field = object_.at(key);
    value_mm = length_of(field);
    if (sign == Sign::non_negative && !(value_mm >= 0)) field.fail("a length of 0 or more");
  }
  void optional_length(const char* key, std::optional<double>& value_mm, Sign sign) {
    if (!object_.at(key).is_null()) length(key, value_mm.emplace(), sign);
  }
  void per_length(const char* key, double& value_per_mm, int power) {
    number(key, value_per_mm, Sign::non_negative);
    value_per_mm /= std::pow(mm_per_unit_, power);
  }
  void point(const char* key, Vec3& value_mm) {
    const std::vector<JsonField> numbers = three(key);
    for (std::size_t k = 0; k < numbers.size(); ++k) value_mm[static_cast<int>(k)] = length_of(numbers[k]);
  }
  void direction(const char* key, Vec3& value) {
    const std::vector<JsonField> numbers = three(key);
    for (std::size_t k = 0; k < numbers.size(); ++k) value[static_cast<int>(k)] = numbers[k].number();
  }

  template <typename Enum>
  void word(const char* key, Enum& value, const Words& words) {
    value = static_cast<Enum>(object_.at(key).word(words));
  }
  void word(const char* key, std::string& value, const Words& words) { value = words[object_.at(key).word(words)]; }
  template <typename Enum>
  void optional_word(const char* key, std::optional<Enum>& value, const Words& words) {
    if (!object_.at(key).is_null()) word(key, value.emplace(), words);
  }
  template <typename Enum>
  void words(const char* key, std::vector<Enum>& values, const Words& words) {
    for (const JsonField& one : object_.at(key).list()) values.push_back(static_cast<Enum>(one.word(words)));
  }
  void texts(const char* key, std::vector<std::string>& values) {
    for (const JsonField& one : object_.at(key).list()) values.push_back(one.text());
  }
  void counts(const char* key, std::vector<std::size_t>& values) {
    for (const JsonField& one : object_.at(key).list()) values.push_back(one.count());
  }
  void counts_by_word(const char* key, std::map<std::string, std::size_t>& values) {
    for (const auto& [word, one] : object_.at(key).entries()) values[word] = one.count();
  }
  void option_texts(const char* key, OptionTexts& options) {
    for (const auto& [option, given] : object_.at(key).entries()) {
      std::vector<std::string> values;
      if (given.is_text())
        values.push_back(given.text());
      else
        for (const JsonField& one : given.list()) values.push_back(one.text());
      options.emplace_back(option, std::move(values));
    }
  }

  template <typename Record>
  void object(const char* key, Record& value) {
    RecordReader inner(object_.at(key), mm_per_unit_);
    describe(inner, value);
  }
  template <typename Record>
  void optional_object(const char* key, std::optional<Record>& value) {
    if (!object_.at(key).is_null()) object(key, value.emplace());
  }
  template <typename Record>
  void object_if_any(const char* key, std::optional<Record>& value) {
    if (object_.find(key)) object(key, value.emplace());
  }
  template <typename Record>
  void list_if_any(const char* key, std::vector<Record>& values) {
    if (object_.find(key)) list(key, values);
  }
  template <typename Record>
  void list(const char* key, std::vector<Record>& values) {
    const std::vector<JsonField> items = object_.at(key).list();
    values.reserve(items.size());
    for (const JsonField& item : items) {
      RecordReader inner(item, mm_per_unit_);
      describe(inner, values.emplace_back());
    }
  }

 private:
  [[nodiscard]] double length_of(const JsonField& field) const {
    const double value_mm = field.number() * mm_per_unit_;
    if (!std::isfinite(value_mm)) field.fail("a length");
    return value_mm;
  }
  [[nodiscard]] std::vector<JsonField> three(const char* key) const {
    const JsonField field = object_.at(key);
    std::vector<JsonField> numbers = field.list();
    if (numbers.size() == 3) return numbers;
    field.fail("three numbers");
    return {};
  }

  JsonField object_;
  double mm_per_unit_;
};

Diagnostic not_a_result(const std::string& file) {
  return make_error("result-format",
                    "this is not a result of gougecheck; expected what 'gougecheck check --json FILE' writes", file, 1);
}

}  // namespace

Result<ReadRecord> read_record(const std::string& file, std::string_view bytes) {
  Result<JsonFile> json = parse_json(file, bytes, {"result-syntax", "result-duplicate-key", "a result of gougecheck"});
  if (!json) return json.error();
  const nlohmann::json& root = json->root;
  if (!root.is_object() || root.value("format", nlohmann::json()) != kResultFormat) return not_a_result(file);
  if (root.value("format_version", nlohmann::json()) != kResultVersion)
    return make_error("result-format",
                      "this result is of another version of the format; expected format_version " +
                          std::to_string(kResultVersion) + "; check again",
                      file, json->lines.at("/format_version"));
  JsonErrors errors{file, "result-field", &json->lines};
  ResultRecord record;
  RecordReader reader(JsonField(root, errors), 1);
  describe(reader, record);
  if (errors.first) return *errors.first;
  return ReadRecord{std::move(*json), std::move(record)};
}

}  // namespace gouge
