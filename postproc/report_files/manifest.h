#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"

// The manifest.json in the folder of a report or a batch, which lists the files that belong to it
// (docs/formats/report_folder.md).

namespace gouge {

inline constexpr const char* kManifestName = "manifest.json";

/// A content that a file of the report may have.
struct ManifestEntry {
  std::string name;
  std::uint64_t bytes = 0;
  std::string sha256;

  bool operator==(const ManifestEntry&) const = default;
};

struct ReportManifest {
  std::vector<ManifestEntry> files;  ///< one name may have two contents while a report is being replaced
  bool is_complete = true;           ///< false: while a report is being replaced
  std::string toolpath = {};         ///< as the user named it; empty: not stated

  [[nodiscard]] bool has(const ManifestEntry& file) const;
};

[[nodiscard]] std::string write_manifest(const ReportManifest& manifest);

/// Reads a manifest. Returns none if `text` is not a manifest of ours.
[[nodiscard]] std::optional<ReportManifest> read_manifest(std::string_view text);

[[nodiscard]] ManifestEntry describe_bytes(std::string name, std::string_view bytes);

/// Returns name, size and hash of the file `name` of `folder`, which is read in pieces. Errors: file-unreadable.
[[nodiscard]] Result<ManifestEntry> describe_file(const std::string& folder, const std::string& name);

/// Reads the manifest in a folder. Returns none if it is no manifest of ours. Errors: file-not-found, file-unreadable.
[[nodiscard]] Result<std::optional<ReportManifest>> manifest_in(const std::string& folder);

}  // namespace gouge
