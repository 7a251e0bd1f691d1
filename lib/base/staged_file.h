#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "lib/base/temporary_name.h"
#include "lib/base/text_writer.h"

namespace gouge {

/// Resolves all symbolic links at the end of `path`; the file there need not
/// exist. Errors: file-unwritable where the links go in a circle.
[[nodiscard]] Result<std::string> follow_links(const std::string& path);

/// Returns why a new file cannot take the place of the existing one at `path`, with its owner, group and mode. Reasons:
/// it is write-protected, or belongs to a user to whom a file cannot be given. None where it can, as far as is known
/// beforehand.
[[nodiscard]] std::optional<std::string> why_not_replaceable(const std::string& path);

/// The whole new content of a file, written and synchronised to the disk but not yet in its place. A call of commit()
/// puts it there with one rename, so that readers see the old file or the new one. A symbolic link is followed and
/// stays. A file that is replaced hands on its owner, group and mode; its other hard links keep the old content.
/// Content that is not committed leaves nothing behind. On most file systems this holds even when the process is
/// killed: until commit() the content has no name. Where a kill did leave a name, the next StagedFile in that folder
/// removes it. Devices and pipes (/dev/null, a FIFO) are written directly, by commit().
class StagedFile {
 public:
  /// `prefix` begins the name it has beside `path` for the moment where one is needed. Errors:
  /// file-unwritable, with the system's reason.
  [[nodiscard]] static Result<StagedFile> make(const std::string& path, std::string_view bytes,
                                               const std::string& prefix = ".gougecheck-");
  [[nodiscard]] static Result<StagedFile> make(const std::string& path, const TextWriter& write,
                                               const std::string& prefix = ".gougecheck-");
  StagedFile(StagedFile&& other) noexcept;
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Puts the file in its place; to be called once. Errors: file-unwritable; the old file at `path` is then as it was.
  [[nodiscard]] Outcome commit();

 private:
  StagedFile(std::string path, std::string prefix) : path_(std::move(path)), prefix_(std::move(prefix)) {}
  [[nodiscard]] bool open_beside();
  [[nodiscard]] bool fill(const TextWriter& write);
  [[nodiscard]] bool put_in_place();
  [[nodiscard]] TemporaryName name_beside() const;

  std::string path_;  // as the user named it
  std::string prefix_;
  std::string target_;    // with links followed
  TemporaryName beside_;  // empty where there is none
  std::string direct_;    // the bytes of a device or pipe
  int handle_ = -1;       // -1: a device or pipe, or moved from
};

/// Number of letters random_name adds to its prefix.
inline constexpr int kRandomLetters = 12;

/// Returns `prefix` and kRandomLetters of 0 to 9 and a to v.
[[nodiscard]] std::string random_name(const std::string& prefix);

/// Locks the file of `handle` as long as it is open, so that no other process takes it for abandoned.
void keep_from_removal(int handle);

/// Removes from `folder` the files of a program that was killed. These are named by random_name(prefix) and belong to
/// this user, and no process keeps them from removal. A file that cannot be identified or removed stays.
/// Cost     O(entries of the folder).
void remove_abandoned(const std::string& folder, const std::string& prefix);

}  // namespace gouge
