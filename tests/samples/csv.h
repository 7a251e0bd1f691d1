#pragma once

#include <string>
#include <vector>

namespace gouge::testing_samples {

/// Rows of fields; quoted fields may hold commas, quotes (doubled) and line ends.
[[nodiscard]] std::vector<std::vector<std::string>> parse_csv(const std::string& text);

/// One row of `--csv`, the columns every version has.
struct MoveRow {
  std::size_t move = 0, line = 0;
  std::string kind, tool, state, depth, depth_upper, t, body, against;

  [[nodiscard]] double depth_value() const { return depth.empty() ? 0 : std::stod(depth); }
  [[nodiscard]] double depth_upper_value() const { return depth_upper.empty() ? 0 : std::stod(depth_upper); }
};

inline constexpr const char* kCsvHeader = "move,line,kind,tool,state,depth,depth_upper,t,body,against,x,y,z,nx,ny,nz";

/// The moves of a CSV file; empty when its header is not the documented one.
[[nodiscard]] std::vector<MoveRow> parse_moves(const std::string& csv);

}  // namespace gouge::testing_samples
