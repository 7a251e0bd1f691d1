#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"

// manifest.json of a report's folder: what in it is the report's own (docs/formats/report_folder.md).

namespace gouge {

inline constexpr const char* kManifestName = "manifest.json";

/// A content a file of the report may have.
struct ManifestEntry {
  std::string name;
  std::uint64_t bytes = 0;
  std::string sha256;

  bool operator==(const ManifestEntry&) const = default;
};

struct ReportManifest {
  std::vector<ManifestEntry> files;  ///< one name may have two contents while a report is being replaced
  bool is_complete = true;           ///< false: while a report is being replaced

  [[nodiscard]] bool has(const ManifestEntry& file) const;
};

[[nodiscard]] std::string write_manifest(const ReportManifest& manifest);

/// None where `text` is no manifest of ours.
[[nodiscard]] std::optional<ReportManifest> read_manifest(std::string_view text);

[[nodiscard]] ManifestEntry describe_bytes(std::string name, std::string_view bytes);

/// The file `name` of `folder` as it is, read in pieces. Errors: file-unreadable.
[[nodiscard]] Result<ManifestEntry> describe_file(const std::string& folder, const std::string& name);

/// Every name a report may write into its folder: report.html, result.json, moves.csv, the pictures, and the
/// manifest. No other file of a folder is the report's.
[[nodiscard]] const std::vector<std::string>& names_of_report();

/// The same for the folder of a batch: index.html, the summaries, SARIF, JUnit, and the manifest.
[[nodiscard]] const std::vector<std::string>& names_of_batch();

}  // namespace gouge
