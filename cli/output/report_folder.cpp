#include "cli/output/report_folder.h"

#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/options/help_text.h"
#include "lib/base/files.h"
#include "postproc/report/report_model.h"

namespace gouge {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = ".gougecheck-report-";  // of temporary names of files

bool has_name(const std::vector<std::string>& names, const char* name) {
  return std::ranges::find(names, name) != names.end();
}

Outcome unwritable(const std::string& path, const std::string& why) {
  return make_error("file-unwritable", "belongs to an older report and cannot be removed: " + why, path);
}

}  // namespace

ReportFolder::~ReportFolder() {
  staged_.clear();
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
}

Outcome ReportFolder::open() {
  std::error_code ignored;
  if (!fs::is_directory(folder_, ignored)) return Done{};
  if (Outcome locked = lock(); !locked) return locked;
  return look();
}

Outcome ReportFolder::lock() {
  if (lock_ || is_locked_) return Done{};
  Result<ReportLock> lock = ReportLock::take(folder_, has_name(names_, kBatchSummaryName));
  if (!lock) return lock.error();
  lock_.emplace(std::move(*lock));
  return Done{};
}

Outcome ReportFolder::make() {
  const Result<std::string> target = follow_links(folder_);
  if (!target) return target.error();
  std::error_code ignored;
  for (fs::path at = *target; !at.empty() && !fs::exists(at, ignored); at = at.parent_path())
    made_.insert(made_.begin(), at.string());
  return make_folder(*target);
}

Diagnostic ReportFolder::foreign(const std::string& message) const {
  return make_error("report-foreign", message, folder_);
}

Outcome ReportFolder::look() {
  std::error_code ignored;
  present_.clear();
  const fs::file_status status = fs::symlink_status(at(kManifestName), ignored);
  std::optional<ReportManifest> manifest;
  if (fs::is_regular_file(status)) {
    Result<std::optional<ReportManifest>> read = manifest_in(folder_);
    if (!read) return read.error();
    manifest = std::move(*read);
  }
  const bool is_for_batch = has_name(names_, kBatchSummaryName);
  const char* const marker = is_for_batch ? kResultName : kBatchSummaryName;
  if (manifest && !is_forced_ &&
      std::ranges::any_of(manifest->files, [&](const auto& file) { return file.name == marker; }))
    return foreign(is_for_batch ? "is the folder of a report, which a batch would take over; name another folder"
                                : "is the folder of a batch, which a report would take over; name another folder");
  const auto plain = [](const std::string& file) { return fs::path(file).lexically_normal(); };
  const bool is_of_other = manifest && !manifest->toolpath.empty() && plain(manifest->toolpath) != plain(toolpath_);
  replaced_ = is_of_other ? manifest->toolpath : "";
  std::vector<std::string> others;
  for (const std::string& name : names_) {
    const fs::file_status found = fs::symlink_status(at(name), ignored);
    if (!fs::exists(found)) continue;
    if (!fs::is_regular_file(found))
      return foreign(name + " is no plain file, so no report can replace it; move it away, or name another folder");
    if (const auto why = why_not_replaceable(at(name)))
      return make_error("file-unwritable", "no report can replace it: " + *why + "; nothing was written", at(name));
    if (name == kManifestName) {
      if (!manifest) others.push_back(name);
      continue;
    }
    Result<ManifestEntry> file = describe_file(folder_, name);
    if (!file) return file.error();
    if (!manifest || !manifest->has(*file)) others.push_back(name);
    present_.push_back(std::move(*file));
  }
  if (others.empty() || is_forced_) return Done{};
  const std::string what_to_do =
      "; expected a folder without them: name another one, move them away, or let --force replace or remove them";
  if (manifest)
    return foreign("a report would replace or remove " + listed(others, " and ") +
                   ", which no report wrote or which was changed since (" + kManifestName + ")" + what_to_do);
  return foreign("a report would replace or remove " + listed(others, " and ") + ", and no " + kManifestName +
                 " says that a report wrote them: they are yours, or of an earlier version of gougecheck" + what_to_do);
}

void ReportFolder::remove_leftovers() {
  std::vector<std::string> leftovers;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder_, ignored), end; entry != end; entry.increment(ignored)) {
    if (entry->path().filename().string().starts_with(kPrefix)) leftovers.push_back(entry->path().string());
  }
  for (const std::string& file : leftovers) ::unlink(file.c_str());
}

Outcome ReportFolder::stage(const std::vector<NamedFile>& files) {
  if (Outcome made = make(); !made) return made;
  if (Outcome opened = open(); !opened) return opened;
  remove_leftovers();
  for (const NamedFile& file : files) {
    Result<StagedFile> staged = StagedFile::make(at(file.name), file.bytes, kPrefix);
    if (!staged) return staged.error();
    staged_.push_back(std::move(*staged));
    new_.push_back(describe_bytes(file.name, file.bytes));
  }
  return Done{};
}

Outcome ReportFolder::put_manifest(const ReportManifest& manifest) {
  Result<StagedFile> staged = StagedFile::make(at(kManifestName), write_manifest(manifest), kPrefix);
  return staged ? staged->commit() : staged.error();
}

Outcome ReportFolder::remove_older() {
  for (const ManifestEntry& file : present_) {
    const bool is_new = std::ranges::any_of(new_, [&](const ManifestEntry& n) { return n.name == file.name; });
    if (!is_new && ::unlink(at(file.name).c_str()) != 0 && errno != ENOENT)
      return unwritable(at(file.name), std::strerror(errno));
  }
  return Done{};
}

Outcome ReportFolder::commit() {
  // Until the last file is in its place, each file may be the old one or the new one.
  ReportManifest either{present_, false, toolpath_};
  either.files.insert(either.files.end(), new_.begin(), new_.end());
  if (Outcome put = put_manifest(either); !put) return put;
  made_.clear();
  for (StagedFile& file : staged_) {
    if (Outcome put = file.commit(); !put) return put;
  }
  if (Outcome removed = remove_older(); !removed) return removed;
  return put_manifest({new_, true, toolpath_});
}

std::optional<Diagnostic> refuse_other_folder(const std::string& name) {
  if (is_interrupted_batch(name)) return make_error("usage", "'" + name + "' " + kIsInterrupted);
  if (is_batch_folder(name))
    return make_error("usage", "'" + name + "' is the folder of a batch; expected one result of it: " +
                                   (fs::path(name) / kReportsFolder / "JOB").string());
  std::error_code ignored;
  if (!fs::is_directory(name, ignored) || fs::exists(result_in(name), ignored)) return std::nullopt;
  return make_error("usage", "'" + name + "' is a folder without " + kResultName +
                                 "; expected a result of check --json, or the folder of check --report");
}

}  // namespace gouge
