#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "toolmodels/import/collector.h"

// Reader of the ASCII databases of NX: tool_database.dat and holder_database.dat.

namespace gouge {

/// One DATA row: its values by the field names of its FORMAT.
struct NxRow {
  std::string class_name;
  std::map<std::string, std::string> values;
  std::size_t line = 0;

  /// Returns a field; empty if the row has no such field.
  [[nodiscard]] std::string text(const std::string& field) const;
  /// Returns a field as a number times `factor`; nothing if it is empty. Errors: import-field.
  [[nodiscard]] Result<std::optional<double>> number(const std::string& field, double factor) const;
};

class NxDatabaseReader {
 public:
  explicit NxDatabaseReader(Collector& collector) : collector_(collector) {}

  /// Reads the rows. Lines that begin with a bar continue a row, and lines without a keyword continue a FORMAT. A row
  /// with an error is reported to the collector and left out.
  std::vector<NxRow> read(std::string_view text);

  [[nodiscard]] bool has_class() const { return has_class_; }

 private:
  void take(std::string_view line, std::size_t number);
  void close_row();

  Collector& collector_;
  std::vector<NxRow> rows_;
  std::string class_, data_;
  std::vector<std::string> format_;
  std::size_t data_line_ = 0;
  bool is_in_format_ = false, has_class_ = false;
};

}  // namespace gouge
