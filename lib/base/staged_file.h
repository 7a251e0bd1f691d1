#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "lib/base/temporary_name.h"
#include "lib/base/text_writer.h"

namespace gouge {

/// Returns the path after resolving all symbolic links at the end of `path`; the file there need not exist. Errors:
/// file-unwritable if the links form a circle.
[[nodiscard]] Result<std::string> follow_links(const std::string& path);

/// Returns the reason why a new file cannot replace the existing one at `path` with the same owner, group and mode. The
/// old file may be write-protected, or belong to a user to whom a file cannot be given. Returns nothing if no such
/// reason is known beforehand.
[[nodiscard]] std::optional<std::string> why_not_replaceable(const std::string& path);

/// The complete new content of a file, written and synchronised to the disk but not yet in its place. A call of
/// commit() puts it there with one rename, so that readers see the old file or the new one. A symbolic link is followed
/// and stays. The new file gets the owner, group and mode of the replaced one, whose other hard links keep the old
/// content. Content that is not committed leaves nothing behind. On most file systems this holds even if the process is
/// killed: before commit() the content has no name. If a kill did leave a name, the next StagedFile in that folder
/// removes it. Devices and pipes (/dev/null, a FIFO) are written directly, by commit().
class StagedFile {
 public:
  /// Writes and synchronises the content. If the content needs a temporary name beside `path`, that name begins with
  /// `prefix`. Errors: file-unwritable, with the reason that the system gives.
  [[nodiscard]] static Result<StagedFile> make(const std::string& path, std::string_view bytes,
                                               const std::string& prefix = ".gougecheck-");
  [[nodiscard]] static Result<StagedFile> make(const std::string& path, const TextWriter& write,
                                               const std::string& prefix = ".gougecheck-");
  StagedFile(StagedFile&& other) noexcept;
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Puts the file in its place; may be called once. Errors: file-unwritable; the old file at `path` is then unchanged.
  [[nodiscard]] Outcome commit();

 private:
  StagedFile(std::string path, std::string prefix) : path_(std::move(path)), prefix_(std::move(prefix)) {}
  [[nodiscard]] bool open_beside();
  [[nodiscard]] bool fill(const TextWriter& write);
  [[nodiscard]] bool put_in_place();
  [[nodiscard]] TemporaryName name_beside() const;

  std::string path_;  // as the user named it
  std::string prefix_;
  std::string target_;    // the path after following links
  TemporaryName beside_;  // temporary name; empty if there is none
  std::string direct_;    // the bytes to write to a device or pipe
  int handle_ = -1;       // -1: a device or pipe, or a moved-from object
};

/// Number of letters that random_name adds to its prefix.
inline constexpr int kRandomLetters = 12;

/// Returns `prefix` followed by kRandomLetters characters from 0 to 9 and a to v.
[[nodiscard]] std::string random_name(const std::string& prefix);

/// Locks the file of `handle` as long as it is open, so that no other process treats it as abandoned.
void keep_from_removal(int handle);

/// Removes from `folder` the files that a killed program left. Their names come from random_name(prefix), they belong
/// to this user, and no process has called keep_from_removal for them. A file that cannot be identified or removed
/// stays.
/// Cost     O(entries of the folder).
void remove_abandoned(const std::string& folder, const std::string& prefix);

}  // namespace gouge
