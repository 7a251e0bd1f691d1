#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "toolmodels/import/nx_database.h"

namespace gouge {

/// Returns whether these are the rows of a holder_database.dat.
[[nodiscard]] bool has_holders(const std::vector<NxRow>& rows);

/// Adds the holders of a holder_database.dat to the library. A holder with an error is left out and reported.
void import_nx_holders(Collector& collector, const std::vector<NxRow>& rows, LengthUnit unit);

/// The holders of the holder_database.dat beside a tool_database.dat. The file is read when the first holder is
/// requested.
class NxHolderSource {
 public:
  NxHolderSource(const ImportOptions& options, LengthUnit unit) : options_(options), unit_(unit) {}

  /// Returns the segments of the holder with this name; null if there is no such file or no such holder in it.
  [[nodiscard]] const std::vector<ToolSegment>* called(const std::string& name);

 private:
  void read();

  const ImportOptions& options_;
  LengthUnit unit_;
  bool is_read_ = false;
  std::map<std::string, std::vector<ToolSegment>> holders_;
};

}  // namespace gouge
