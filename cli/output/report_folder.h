#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/base/staged_file.h"
#include "postproc/report/named_file.h"

// The manifest.json of a report's folder, which lists the report's own files (docs/formats/report_folder.md).

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

/// Reads a manifest. None where `text` is not a manifest of ours.
[[nodiscard]] std::optional<ReportManifest> read_manifest(std::string_view text);

[[nodiscard]] ManifestEntry describe_bytes(std::string name, std::string_view bytes);

/// Returns the file `name` of `folder` as it is, read in pieces. Errors: file-unreadable.
[[nodiscard]] Result<ManifestEntry> describe_file(const std::string& folder, const std::string& name);

/// Returns every name a report may write into its folder: report.html, result.json, moves.csv, the pictures, and the
/// manifest. No other file of a folder is the report's.
[[nodiscard]] const std::vector<std::string>& names_of_report();

/// Returns the same for the folder of a batch: index.html, the summaries, SARIF, JUnit, and the manifest.
[[nodiscard]] const std::vector<std::string>& names_of_batch();

/// The folder of --report, in which a new report takes the place of an older one and of nothing else. The manifest of
/// an older report states its files, by name and content. All other files under a name of the report's are foreign, and
/// refused unless `is_forced`. A process that is killed at any instant leaves a folder whose manifest knows every file
/// of the report in it. Order of calls: open, stage, commit.
class ReportFolder {
 public:
  /// `names`: those it may write, of which no other file of the folder is; they must outlive it.
  ReportFolder(std::string folder, bool is_forced, const std::vector<std::string>& names = names_of_report())
      : folder_(std::move(folder)), is_forced_(is_forced), names_(names) {}
  ReportFolder(const ReportFolder&) = delete;
  ReportFolder& operator=(const ReportFolder&) = delete;
  /// Without commit() the folder is as it was, and was not made.
  ~ReportFolder();

  /// Locks the folder, if it exists, until the end, and finds what stands in the way of a report. Changes
  /// nothing. Errors: report-busy (another process has it), report-foreign.
  [[nodiscard]] Outcome open();

  /// Makes the folder if need be, opens it again, and writes all of `files` beside their places, with no name
  /// yet. Errors: folder-unwritable, file-unwritable, and those of open().
  [[nodiscard]] Outcome stage(const std::vector<NamedFile>& files);

  /// Puts every file in its place and removes those of the older report that the new one has not. Errors:
  /// file-unwritable, where some files may be new and others old.
  [[nodiscard]] Outcome commit();

 private:
  [[nodiscard]] Outcome lock();
  [[nodiscard]] Outcome make();
  [[nodiscard]] Outcome look();
  [[nodiscard]] Outcome put_manifest(const ReportManifest& manifest);
  [[nodiscard]] Outcome remove_older();
  void remove_leftovers();
  [[nodiscard]] std::string at(const std::string& name) const { return folder_ + "/" + name; }
  [[nodiscard]] Diagnostic foreign(const std::string& message) const;

  std::string folder_;
  bool is_forced_;
  const std::vector<std::string>& names_;
  int lock_ = -1;                       // the folder, locked
  std::vector<std::string> made_;       // folders made for it, the outermost first
  std::vector<ManifestEntry> present_;  // files under names of the report, as they are
  std::vector<ManifestEntry> new_;
  std::vector<StagedFile> staged_;
};

}  // namespace gouge
