#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/output/report_lock.h"
#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/base/staged_file.h"
#include "postproc/report/named_file.h"
#include "postproc/report_files/manifest.h"
#include "postproc/report_files/own_files.h"

namespace gouge {

/// The rest of a sentence that begins with the name of such a folder.
inline constexpr const char* kIsInterrupted =
    "is the folder of a batch that was interrupted; finish it with gougecheck batch ... --resume";
/// Returns the error for a folder where one result is expected, if it is not that of a report: the folder of a batch, also
/// of one that was interrupted, or a folder without a result. None for any other name. Code: usage.
[[nodiscard]] std::optional<Diagnostic> refuse_other_folder(const std::string& name);

/// The folder of --report, in which a new report replaces an older one and nothing else. The manifest of the older
/// report states its files, by name and content. Every other file with a name of a report is foreign, and refused
/// unless `is_forced`. A process that is killed at any instant leaves a folder whose manifest has every file of the
/// report in it. Order of calls: open, stage, commit.
class ReportFolder {
 public:
  /// `names` are the names that the report may write; no other file in the folder belongs to it. They must outlive the
  /// object.
  ReportFolder(std::string folder, bool is_forced, const std::vector<std::string>& names = names_of_report())
      : folder_(std::move(folder)), is_forced_(is_forced), names_(names) {}
  ReportFolder(const ReportFolder&) = delete;
  ReportFolder& operator=(const ReportFolder&) = delete;
  /// Restores the folder if commit() was not called; a folder that was made is removed.
  ~ReportFolder();

  /// States, before open(), that the caller holds the ReportLock of the folder.
  void set_locked() { is_locked_ = true; }

  /// Locks the folder, if it exists, until the end, and finds files that prevent a report. Changes nothing. Errors:
  /// report-busy (another process has the folder), report-foreign.
  [[nodiscard]] Outcome open();

  /// States the toolpath that the new report is about, before open(). The manifest has its name.
  void set_toolpath(std::string toolpath) { toolpath_ = std::move(toolpath); }
  /// Returns, after open(), the toolpath of the older report if it is another one; empty: it is the same, or not stated.
  [[nodiscard]] const std::string& replaced_toolpath() const { return replaced_; }

  /// Makes the folder if necessary, opens it again, and writes all of `files` beside their places, without a name yet.
  /// Errors: folder-unwritable, file-unwritable, and those of open().
  [[nodiscard]] Outcome stage(const std::vector<NamedFile>& files);

  /// Puts every file in its place and removes the files of the older report that the new one does not have. Errors:
  /// file-unwritable; then some files may be new and others old.
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

  std::string folder_, toolpath_, replaced_;
  bool is_forced_;
  const std::vector<std::string>& names_;
  bool is_locked_ = false;  // by the caller
  std::optional<ReportLock> lock_;
  std::vector<std::string> made_;       // folders made for the report, the outermost first
  std::vector<ManifestEntry> present_;  // present files with names of the report
  std::vector<ManifestEntry> new_;
  std::vector<StagedFile> staged_;
};

}  // namespace gouge
