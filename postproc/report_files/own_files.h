#pragma once

#include <string>
#include <vector>

// The names of the files that the folder of a report or a batch has, and which files belong to such a folder
// (docs/formats/report_folder.md).

namespace gouge {

inline constexpr const char* kBatchSummaryName = "summary.json";
inline constexpr const char* kBatchPageName = "index.html";
inline constexpr const char* kBatchStoreName = "results.sqlite";
/// Folder of the reports of the jobs in the folder of a batch.
inline constexpr const char* kReportsFolder = "reports";
/// Folder of the corrected toolpaths there.
inline constexpr const char* kCorrectedFolder = "corrected";
/// Folder of the certificates there.
inline constexpr const char* kCertificatesFolder = "certificates";
inline constexpr const char* kResultName = "result.json";

/// Returns every name that a report may write into its folder: report.html, result.json, moves.csv, the pictures, and
/// the manifest. All other files in the folder do not belong to the report.
[[nodiscard]] const std::vector<std::string>& names_of_report();

/// Returns the place of the result in the folder of a report, or `file` itself if it is no folder.
[[nodiscard]] std::string result_in(const std::string& file);

/// Returns whether a name is that of the folder of a batch.
[[nodiscard]] bool is_batch_folder(const std::string& name);
/// Returns whether a name is that of the folder of a batch that was interrupted: it has results, but no summary.
[[nodiscard]] bool is_interrupted_batch(const std::string& name);
/// Returns the folder of the batch to whose jobs the folder of a report belongs; empty: to none.
[[nodiscard]] std::string batch_of_report(const std::string& folder);
/// Returns the names for the folder of a batch: index.html, the summaries, SARIF, JUnit, and the manifest.
[[nodiscard]] const std::vector<std::string>& names_of_batch();

/// Returns why no other output may have this name: it is, or would be, a file of a report or of a batch. Such a folder is
/// locked if a run finds a file in it that it did not write. `is_of_batch`: the output belongs to a job of the batch,
/// which writes its corrected toolpaths and certificates. Empty: any output may have it.
[[nodiscard]] std::string why_kept(const std::string& file, bool is_of_batch = false);

}  // namespace gouge
