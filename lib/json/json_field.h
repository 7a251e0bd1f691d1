#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/json/json_file.h"

namespace gouge {

/// Collects the first error of a file that is read field by field.
struct JsonErrors {
  std::string file;                      ///< as the user named it
  std::string code;                      ///< of what is wrong with a field
  const JsonLines* lines = nullptr;      ///< of the file
  std::optional<Diagnostic> first = {};  ///< none: all is well so far
};

/// A value of a JSON text that must be as expected. After the first error every reading gives an empty value. So the
/// reader examines JsonErrors::first once, at the end. The object `errors` must outlive it, like the text.
class JsonField {
 public:
  JsonField(const nlohmann::json& root, JsonErrors& errors) : value_(&root), errors_(&errors) {}

  /// Returns the value of `key`, which must be there.
  [[nodiscard]] JsonField at(const std::string& key) const;
  /// Returns the same, or none where it is missing.
  [[nodiscard]] std::optional<JsonField> find(const std::string& key) const;
  /// Returns the elements of a list.
  [[nodiscard]] std::vector<JsonField> list() const;
  /// The keys and values of an object.
  [[nodiscard]] std::vector<std::pair<std::string, JsonField>> entries() const;

  [[nodiscard]] bool is_null() const { return value_ == nullptr || value_->is_null(); }
  [[nodiscard]] bool is_text() const { return value_ != nullptr && value_->is_string(); }
  [[nodiscard]] std::string text() const;
  /// Reads one of these words and returns its place among them.
  [[nodiscard]] std::size_t word(const std::vector<std::string>& words) const;
  /// Returns a finite number.
  [[nodiscard]] double number() const;
  [[nodiscard]] std::optional<double> number_or_null() const;
  /// Returns a whole number of 0 or more.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] bool flag() const;

  /// Names the field, its line, and the expected value, unless there was an error before.
  void fail(const std::string& expected) const;

 private:
  JsonField(const nlohmann::json* value, std::string pointer, JsonErrors& errors)
      : value_(value), pointer_(std::move(pointer)), errors_(&errors) {}

  const nlohmann::json* value_;  // null: it is not there, and the error is reported
  std::string pointer_;
  JsonErrors* errors_;
};

}  // namespace gouge
