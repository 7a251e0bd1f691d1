#include "postproc/report_files/own_files.h"

#include <algorithm>
#include <filesystem>

#include "postproc/report_files/manifest.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

/// Returns the folder of the batch below whose folder `part` a file or folder is; else empty.
std::string batch_above(const std::string& name, const char* part) {
  std::error_code ignored;
  const fs::path full = fs::weakly_canonical(name, ignored);
  for (fs::path above = full.parent_path(); above != above.parent_path(); above = above.parent_path()) {
    const bool is_batch = is_batch_folder(above.string()) || is_interrupted_batch(above.string());
    if (is_batch && *full.lexically_relative(above).begin() == part) return above.string();
  }
  return {};
}

/// Returns the folder of a file if that is the folder of a report or of a batch and the file is one of theirs; else empty.
std::string folder_with_own_file(const std::string& file) {
  std::error_code ignored;
  const fs::path full = fs::weakly_canonical(file, ignored), folder = full.parent_path();
  const std::string name = full.filename().string();
  const bool is_batch = is_batch_folder(folder.string()) || is_interrupted_batch(folder.string());
  if (is_batch && (std::ranges::count(names_of_batch(), name) > 0 || name.starts_with(kBatchStoreName)))
    return folder.string();
  const auto manifest = manifest_in(folder.string());
  if (!manifest || !*manifest) return {};
  const bool is_listed = std::ranges::any_of((*manifest)->files, [&](const auto& entry) { return entry.name == name; });
  return is_listed || name == kManifestName ? folder.string() : std::string();
}

}  // namespace

const std::vector<std::string>& names_of_report() {
  // Pictures are event_1.png to event_9.png. A report has no more, and a longer number may be a date in a file of the
  // user.
  static const std::vector<std::string> kNames = {
      "report.html",          kResultName,   "moves.csv",   "before_after.png", "tilt_field.png", "heat_map.png",
      "depth_along_path.png", "event_1.png", "event_2.png", "event_3.png",      "event_4.png",    "event_5.png",
      "event_6.png",          "event_7.png", "event_8.png", "event_9.png",      kManifestName};
  return kNames;
}

std::string result_in(const std::string& file) {
  std::error_code ignored;
  if (!fs::is_directory(file, ignored)) return file;
  return file + (file.ends_with('/') ? "" : "/") + kResultName;
}

bool is_batch_folder(const std::string& name) {
  std::error_code ignored;
  return fs::is_regular_file(fs::path(name) / kBatchSummaryName, ignored);
}

std::string batch_of_report(const std::string& folder) { return batch_above(folder, kReportsFolder); }

std::string why_kept(const std::string& file, bool is_of_batch) {
  std::string folder = folder_with_own_file(file);
  for (const char* const own : {kCorrectedFolder, kCertificatesFolder})
    if (folder.empty() && !is_of_batch) folder = batch_above(file, own);
  if (folder.empty()) return {};
  return "is a file of the report or the batch in " + folder + ", where nothing else writes; name another file";
}

bool is_interrupted_batch(const std::string& name) {
  std::error_code ignored;
  return !is_batch_folder(name) && fs::is_regular_file(fs::path(name) / kBatchStoreName, ignored);
}

const std::vector<std::string>& names_of_batch() {
  static const std::vector<std::string> kNames = {kBatchPageName, "summary.csv",    kBatchSummaryName,
                                                  "junit.xml",    "findings.sarif", kManifestName};
  return kNames;
}

}  // namespace gouge
