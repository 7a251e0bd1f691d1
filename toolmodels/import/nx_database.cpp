#include "toolmodels/import/nx_database.h"

#include <algorithm>
#include <utility>

#include "toolmodels/import/quantity.h"

namespace gouge {
namespace {

using Fields = std::vector<std::string>;

Fields split_blanks(std::string_view text) {
  Fields words;
  for (text = trim_blanks(text); !text.empty(); text = trim_blanks(text)) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

// Splits a row at its bars. The bar that closes a row does not begin another field.
Fields split_bars(std::string_view text) {
  Fields fields;
  text = trim_blanks(text);
  if (!text.empty() && text.front() == '|') text.remove_prefix(1);
  while (true) {
    const std::size_t bar = text.find('|');
    fields.push_back(clean_text(text.substr(0, bar)));
    if (bar == std::string_view::npos) break;
    text.remove_prefix(bar + 1);
    if (trim_blanks(text).empty()) break;
  }
  return fields;
}

bool begins_with_word(std::string_view line, std::string_view word) {
  return line.starts_with(word) && (line.size() == word.size() || line[word.size()] == ' ' ||
                                    line[word.size()] == '\t' || line[word.size()] == '|');
}

}  // namespace

std::string NxRow::text(const std::string& field) const {
  const auto found = values.find(field);
  return found == values.end() ? std::string() : found->second;
}

Result<std::optional<double>> NxRow::number(const std::string& field, double factor) const {
  const std::string value = text(field);
  if (value.empty()) return std::optional<double>();
  const std::optional<Quantity> quantity = parse_quantity(value);
  if (!quantity || quantity->unit != QuantityUnit::none)
    return make_error("import-field", field + " is \"" + value + "\"; expected a number");
  return std::optional<double>(quantity->value * factor);
}

std::vector<NxRow> NxDatabaseReader::read(std::string_view text) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    take(trim_blanks(text.substr(0, end)), line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  close_row();
  return std::move(rows_);
}

void NxDatabaseReader::take(std::string_view line, std::size_t number) {
  if (line.empty()) return;
  if (line.front() == '#') {
    close_row();
    is_in_format_ = false;
    const bool is_class = begins_with_word(line, "#CLASS");
    if (!is_class && !begins_with_word(line, "#END_DATA")) return;
    class_ = is_class ? clean_text(line.substr(6)) : std::string();
    has_class_ = has_class_ || is_class;
    format_.clear();
  } else if (begins_with_word(line, "FORMAT")) {
    close_row();
    format_ = split_blanks(line.substr(6));
    is_in_format_ = true;
  } else if (begins_with_word(line, "DATA")) {
    close_row();
    is_in_format_ = false;
    data_ = std::string(line.substr(4));
    data_line_ = number;
  } else if (line.front() == '|' && data_line_ > 0) {
    data_ += line;
  } else if (is_in_format_) {
    for (std::string& word : split_blanks(line)) format_.push_back(std::move(word));
  }
}

void NxDatabaseReader::close_row() {
  if (data_line_ == 0) return;
  const Fields fields = split_bars(data_);
  const std::size_t line = std::exchange(data_line_, 0);
  // The general rows of holders may precede the first class.
  const bool has_place = !class_.empty() || std::ranges::find(format_, "RTYPE") != format_.end();
  if (!has_place || format_.empty())
    return collector_.report("row", make_error("import-field", "a DATA row stands outside of a #CLASS with a FORMAT"),
                             line);
  if (fields.size() > format_.size())
    return collector_.report(
        "row \"" + fields.front() + "\"",
        make_error("import-field", "has " + std::to_string(fields.size()) + " values, but its FORMAT names " +
                                       std::to_string(format_.size()) + " fields"),
        line);
  NxRow row{class_, {}, line};
  for (std::size_t i = 0; i < fields.size(); ++i) row.values.emplace(format_[i], fields[i]);
  rows_.push_back(std::move(row));
}

}  // namespace gouge
