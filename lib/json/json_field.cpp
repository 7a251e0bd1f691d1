#include "lib/json/json_field.h"

#include <algorithm>
#include <cmath>

namespace gouge {

JsonField JsonField::at(const std::string& key) const {
  std::optional<JsonField> found = find(key);
  if (found) return *found;
  JsonField missing(nullptr, pointer_ + "/" + key, *errors_);
  if (value_ != nullptr) missing.fail("it to be there");
  return missing;
}

std::optional<JsonField> JsonField::find(const std::string& key) const {
  if (value_ == nullptr) return std::nullopt;
  if (!value_->is_object()) {
    fail("an object");
    return std::nullopt;
  }
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return JsonField(&*found, pointer_ + "/" + key, *errors_);
}

std::vector<JsonField> JsonField::list() const {
  std::vector<JsonField> all;
  if (value_ == nullptr) return all;
  if (!value_->is_array()) {
    fail("a list");
    return all;
  }
  all.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i)
    all.push_back(JsonField(&(*value_)[i], pointer_ + "/" + std::to_string(i), *errors_));
  return all;
}

std::vector<std::pair<std::string, JsonField>> JsonField::entries() const {
  std::vector<std::pair<std::string, JsonField>> all;
  if (value_ == nullptr) return all;
  if (!value_->is_object()) {
    fail("an object");
    return all;
  }
  for (const auto& [key, value] : value_->items())
    all.emplace_back(key, JsonField(&value, pointer_ + "/" + key, *errors_));
  return all;
}

std::string JsonField::text() const {
  if (value_ != nullptr && value_->is_string()) return value_->get<std::string>();
  fail("a text");
  return {};
}

std::size_t JsonField::word(const std::vector<std::string>& words) const {
  const auto found = is_text() ? std::ranges::find(words, value_->get<std::string>()) : words.end();
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string expected;
  for (const std::string& one : words) expected += (expected.empty() ? "" : ", ") + one;
  fail("one of " + expected);
  return 0;
}

double JsonField::number() const {
  if (value_ != nullptr && value_->is_number() && std::isfinite(value_->get<double>())) return value_->get<double>();
  fail("a number");
  return 0;
}

std::optional<double> JsonField::number_or_null() const {
  if (is_null()) return std::nullopt;
  return number();
}

std::size_t JsonField::count() const {
  if (value_ != nullptr && value_->is_number_unsigned()) return value_->get<std::size_t>();
  fail("a whole number of 0 or more");
  return 0;
}

bool JsonField::flag() const {
  if (value_ != nullptr && value_->is_boolean()) return value_->get<bool>();
  fail("true or false");
  return false;
}

void JsonField::fail(const std::string& expected) const {
  if (errors_->first) return;
  const std::string name = pointer_.empty() ? "the file" : "'" + pointer_ + "'";
  constexpr std::size_t kMost = 40;
  std::string found =
      value_ == nullptr ? "nothing" : value_->dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (found.size() > kMost) found = found.substr(0, kMost) + "...";
  errors_->first = make_error(errors_->code, name + " is " + found + "; expected " + expected, errors_->file,
                              errors_->lines != nullptr ? errors_->lines->at(pointer_) : 0);
}

}  // namespace gouge
