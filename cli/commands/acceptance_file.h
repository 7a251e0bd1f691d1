#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "cli/options/reading_options.h"
#include "postproc/accept/accepted.h"

// The file of accepted findings that `accept` lists, extends and shortens.

namespace gouge {

/// A lock of the folder of a file. If two processes accept at once, it keeps one from losing the entries of the other.
class FolderLock {
 public:
  explicit FolderLock(const std::string& file);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int handle_ = -1;
};

/// Returns the existing entries of the file; none if there is no file, or an empty one. Errors: those of read_file and
/// read_accepted.
[[nodiscard]] Result<std::vector<Acceptance>> read_acceptances(const std::string& file, const InputLimit& limit);

/// Returns "accepted.json has 2 accepted findings", as a line.
[[nodiscard]] std::string count_line(const std::string& file, std::size_t count);

/// Lists the entries with the numbers of --withdraw, which start at 1.
void list_acceptances(const std::string& file, const std::vector<Acceptance>& entries, std::ostream& out);

/// Removes the entries with these numbers from the file, and prints them. Returns the exit status: 0 done, 2 no such entry,
/// 3 unreadable, 5 unwritable.
[[nodiscard]] int withdraw_acceptances(const std::string& file, std::vector<std::uint32_t> numbers,
                                       const InputLimit& limit, std::ostream& out, std::ostream& err);

}  // namespace gouge
