#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/record/result_fields.h"

// The values of a record as a plain list, for comparisons of two records. The lists follow result_fields.h, so a new field
// is compared as soon as it is described there.

namespace gouge {

/// A value of a record.
struct RecordLeaf {
  std::string place;                  ///< its place in the JSON: "/witness/point/0"
  std::string text;                   ///< valid UTF-8
  std::optional<double> number = {};  ///< of a number that is rounded in the file; lengths in mm
  bool is_free_text = false;          ///< a text, not a word of a fixed list
};

/// A visitor that lists each value of a record.
class LeafLister {
 public:
  explicit LeafLister(std::string place) : place_(std::move(place)) {}
  [[nodiscard]] std::vector<RecordLeaf> take() { return std::move(leaves_); }

  void text(const char* key, const std::string& value) { add_text(key, value); }
  void optional_text(const char* key, const std::optional<std::string>& value) {
    value ? add_text(key, *value) : add_null(key);
  }
  void flag(const char* key, bool value) { add_word(key, value ? "true" : "false"); }
  template <typename Count>
  void count(const char* key, Count value, std::size_t /*min*/ = 0) {
    add_word(key, std::to_string(value));
  }
  void optional_count(const char* key, const std::optional<std::size_t>& value, std::size_t /*min*/ = 0) {
    value ? add_word(key, std::to_string(*value)) : add_null(key);
  }
  void number(const char* key, double value, Sign /*sign*/) { add_number(key, value); }
  void optional_number(const char* key, const std::optional<double>& value, Sign /*sign*/) {
    value ? add_number(key, *value) : add_null(key);
  }
  void length(const char* key, double value_mm, Sign /*sign*/) { add_number(key, value_mm); }
  void optional_length(const char* key, const std::optional<double>& value_mm, Sign /*sign*/) {
    value_mm ? add_number(key, *value_mm) : add_null(key);
  }
  void per_length(const char* key, double value_per_mm, int /*power*/) { add_number(key, value_per_mm); }
  void point(const char* key, const Vec3& value) {
    for (int k = 0; k < 3; ++k) add_number(key + ("/" + std::to_string(k)), value[k]);
  }
  void direction(const char* key, const Vec3& value) { point(key, value); }

  template <typename Enum>
  void word(const char* key, Enum value, const Words& words) {
    add_word(key, words.at(static_cast<std::size_t>(value)));
  }
  void word(const char* key, const std::string& value, const Words& /*words*/) { add_word(key, value); }
  template <typename Enum>
  void optional_word(const char* key, const std::optional<Enum>& value, const Words& all) {
    value ? word(key, *value, all) : add_null(key);
  }
  template <typename Enum>
  void words(const char* key, const std::vector<Enum>& values, const Words& all) {
    std::string joined;
    for (const Enum value : values) joined += (joined.empty() ? "" : ", ") + all.at(static_cast<std::size_t>(value));
    add_word(key, joined);
  }
  void texts(const char* key, const std::vector<std::string>& values) {
    add_word(std::string(key) + "/length", std::to_string(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k) add_text(key + ("/" + std::to_string(k)), values[k]);
  }
  void counts(const char* key, const std::vector<std::size_t>& values) {
    std::string joined;
    for (const std::size_t value : values) joined += (joined.empty() ? "" : ", ") + std::to_string(value);
    add_word(key, joined);
  }
  void counts_by_word(const char* key, const std::map<std::string, std::size_t>& values) {
    std::string joined;
    for (const auto& [word, value] : values)
      joined += (joined.empty() ? "" : ", ") + word + " " + std::to_string(value);
    add_text(key, joined);
  }

  template <typename Record>
  void object(const char* key, const Record& value) {
    const std::size_t end = place_.size();
    place_ += std::string("/") + key;
    describe(*this, value);
    place_.resize(end);
  }
  template <typename Record>
  void list(const char* key, const std::vector<Record>& values) {
    add_word(std::string(key) + "/length", std::to_string(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k) object((key + ("/" + std::to_string(k))).c_str(), values[k]);
  }
  template <typename Record>
  void optional_object(const char* key, const std::optional<Record>& value) {
    value ? object(key, *value) : add_null(key);
  }
  template <typename Record>
  void object_if_any(const char* key, const std::optional<Record>& value) {
    optional_object(key, value);
  }
  template <typename Record>
  void list_if_any(const char* key, const std::vector<Record>& values) {
    list(key, values);
  }

 private:
  void add_text(std::string_view key, std::string_view value) {
    add(key, valid_utf8(value));
    leaves_.back().is_free_text = true;
  }
  void add_word(std::string_view key, std::string value) { add(key, std::move(value)); }
  void add_null(std::string_view key) { add(key, "null"); }
  void add_number(std::string_view key, double value) {
    add(key, exact_text(value));
    leaves_.back().number = value;
  }
  void add(std::string_view key, std::string value) {
    leaves_.push_back({place_ + "/" + std::string(key), std::move(value)});
  }

  std::string place_;
  std::vector<RecordLeaf> leaves_;
};

/// Returns the values of a record, or of an object in it whose place is `place`, in the order of the file.
template <typename Record>
[[nodiscard]] std::vector<RecordLeaf> leaves_of(std::string place, const Record& record) {
  LeafLister lister(std::move(place));
  describe(lister, record);
  return lister.take();
}

}  // namespace gouge
