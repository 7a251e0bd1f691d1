#include "postproc/record/write_record.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/base/printable_text.h"
#include "postproc/record/result_digest.h"
#include "postproc/record/result_fields.h"

namespace gouge {
namespace {

/// A visitor that appends each field of a record to a text. A document in memory would need several times the memory of
/// the text.
class RecordWriter {
 public:
  void constant(const char* key, const char* value) { put(key, quoted(value)); }
  void constant(const char* key, int value) { put(key, std::to_string(value)); }
  void unit(const char* key, LengthUnit value) {
    mm_per_unit_ = mm_per(value);
    put(key, quoted(unit_name(value)));
  }

  void text(const char* key, const std::string& value) { put(key, quoted(value)); }
  void optional_text(const char* key, const std::optional<std::string>& value) {
    put(key, value ? quoted(*value) : kNull);
  }
  void flag(const char* key, bool value) { put(key, value ? "true" : "false"); }
  template <typename Count>
  void count(const char* key, Count value, std::size_t /*min*/ = 0) {
    put(key, std::to_string(value));
  }
  void optional_count(const char* key, const std::optional<std::size_t>& value, std::size_t /*min*/ = 0) {
    put(key, value ? std::to_string(*value) : kNull);
  }
  void number(const char* key, double value, Sign /*sign*/) { put(key, number_text(value)); }
  void optional_number(const char* key, const std::optional<double>& value, Sign /*sign*/) {
    put(key, value ? number_text(*value) : kNull);
  }
  void length(const char* key, double value_mm, Sign /*sign*/) { put(key, length_text(value_mm)); }
  void optional_length(const char* key, const std::optional<double>& value_mm, Sign /*sign*/) {
    put(key, value_mm ? length_text(*value_mm) : kNull);
  }
  void per_length(const char* key, double value_per_mm, int power) {
    put(key, number_text(value_per_mm * std::pow(mm_per_unit_, power) + 0.0));
  }
  void point(const char* key, const Vec3& value_mm) {
    begin(key, '[');
    for (int k = 0; k < 3; ++k) item(length_text(value_mm[k]));
    end(']');
  }
  void direction(const char* key, const Vec3& value) {
    begin(key, '[');
    for (int k = 0; k < 3; ++k) item(number_text(value[k]));
    end(']');
  }

  template <typename Enum>
  void word(const char* key, Enum value, const Words& words) {
    put(key, quoted(words.at(static_cast<std::size_t>(value))));
  }
  void word(const char* key, const std::string& value, const Words& /*words*/) { put(key, quoted(value)); }
  template <typename Enum>
  void optional_word(const char* key, const std::optional<Enum>& value, const Words& words) {
    put(key, value ? quoted(words.at(static_cast<std::size_t>(*value))) : kNull);
  }
  template <typename Enum>
  void words(const char* key, const std::vector<Enum>& values, const Words& words) {
    begin(key, '[');
    for (const Enum value : values) item(quoted(words.at(static_cast<std::size_t>(value))));
    end(']');
  }
  void texts(const char* key, const std::vector<std::string>& values) {
    begin(key, '[');
    for (const std::string& value : values) item(quoted(value));
    end(']');
  }
  void counts(const char* key, const std::vector<std::size_t>& values) {
    begin(key, '[');
    for (const std::size_t value : values) item(std::to_string(value));
    end(']');
  }
  void counts_by_word(const char* key, const std::map<std::string, std::size_t>& values) {
    begin(key, '{');
    for (const auto& [word, value] : values) put(word, std::to_string(value));
    end('}');
  }
  void option_texts(const char* key, const OptionTexts& options) {
    begin(key, '{');
    for (const auto& [option, values] : options) {
      if (values.size() == 1)
        put(option, quoted(values.front()));
      else
        texts(option.c_str(), values);
    }
    end('}');
  }

  template <typename Record>
  void object(const char* key, const Record& value) {
    begin(key, '{');
    describe(*this, value);
    end('}');
  }
  template <typename Record>
  void optional_object(const char* key, const std::optional<Record>& value) {
    if (value)
      object(key, *value);
    else
      put(key, kNull);
  }
  template <typename Record>
  void object_if_any(const char* key, const std::optional<Record>& value) {
    if (value) object(key, *value);
  }
  template <typename Record>
  void list_if_any(const char* key, const std::vector<Record>& values) {
    if (!values.empty()) list(key, values);
  }
  template <typename Record>
  void list(const char* key, const std::vector<Record>& values) {
    begin(key, '[');
    for (const Record& value : values) {
      start_item();
      open('{');
      describe(*this, value);
      end('}');
    }
    end(']');
  }

  std::string whole(const ResultRecord& record) {
    open('{');
    describe(*this, record);
    end('}');
    return std::move(text_) + "\n";
  }

 private:
  static constexpr const char* kNull = "null";

  static std::string quoted(std::string_view value) { return nlohmann::json(valid_utf8(value)).dump(); }
  static std::string number_text(double value) { return nlohmann::json(value).dump(); }
  // Returns a length as text; null for a bound that was never reached, which has no number.
  [[nodiscard]] std::string length_text(double value_mm) const {
    const double value = value_mm / mm_per_unit_;
    return std::isfinite(value) ? number_text(value + 0.0) : kNull;
  }

  void start_item() {
    text_ += is_empty_ ? "\n" : ",\n";
    text_.append(depth_, ' ');
    is_empty_ = false;
  }
  void item(std::string_view value) {
    start_item();
    text_ += value;
  }
  void start_field(std::string_view key) {
    start_item();
    text_ += quoted(key);
    text_ += ": ";
  }
  void put(std::string_view key, std::string_view value) {
    start_field(key);
    text_ += value;
  }
  void open(char bracket) {
    text_ += bracket;
    ++depth_;
    is_empty_ = true;
  }
  void begin(std::string_view key, char bracket) {
    start_field(key);
    open(bracket);
  }
  void end(char bracket) {
    --depth_;
    if (!is_empty_) {
      text_ += '\n';
      text_.append(depth_, ' ');
    }
    text_ += bracket;
    is_empty_ = false;
  }

  std::string text_;
  std::size_t depth_ = 0;
  bool is_empty_ = true;  // whether the innermost object or list is still empty
  double mm_per_unit_ = 1;
};

}  // namespace

std::string write_record(const ResultRecord& record) { return with_digest(RecordWriter().whole(record)); }

}  // namespace gouge
