#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/json/json_file.h"

namespace gouge {

/// The first error of a file that is read field by field.
struct JsonErrors {
  std::string file;                      ///< as the user named it
  std::string code;                      ///< code of the errors of a field
  const JsonLines* lines = nullptr;      ///< of the file
  std::optional<Diagnostic> first = {};  ///< none: no error so far
};

/// A value of a JSON text that must have an expected form. After the first error every reading returns an empty value.
/// So the reader examines JsonErrors::first only once, at the end. The text and the object `errors` must outlive it.
class JsonField {
 public:
  JsonField(const nlohmann::json& root, JsonErrors& errors) : value_(&root), errors_(&errors) {}

  /// Returns the value of `key`, which must exist.
  [[nodiscard]] JsonField at(const std::string& key) const;
  /// Returns the value of `key`, or none if the key is missing.
  [[nodiscard]] std::optional<JsonField> find(const std::string& key) const;
  /// Returns the elements of a list.
  [[nodiscard]] std::vector<JsonField> list() const;
  /// Returns the keys and values of an object.
  [[nodiscard]] std::vector<std::pair<std::string, JsonField>> entries() const;

  [[nodiscard]] bool is_null() const { return value_ == nullptr || value_->is_null(); }
  [[nodiscard]] bool is_list() const { return value_ != nullptr && value_->is_array(); }
  [[nodiscard]] bool is_text() const { return value_ != nullptr && value_->is_string(); }
  [[nodiscard]] std::string text() const;
  /// Reads one of `words` and returns its index.
  [[nodiscard]] std::size_t word(const std::vector<std::string>& words) const;
  /// Returns a finite number.
  [[nodiscard]] double number() const;
  [[nodiscard]] std::optional<double> number_or_null() const;
  /// Returns a whole number of at least 0.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] bool flag() const;

  /// Reports the field, its line and the expected value as the error, unless there was an error before.
  void fail(const std::string& expected) const;

 private:
  JsonField(const nlohmann::json* value, std::string pointer, JsonErrors& errors)
      : value_(value), pointer_(std::move(pointer)), errors_(&errors) {}

  const nlohmann::json* value_;  // null: the value is missing, and the error is reported
  std::string pointer_;
  JsonErrors* errors_;
};

}  // namespace gouge
