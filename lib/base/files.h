#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "lib/base/letters.h"
#include "lib/base/paged_memory.h"
#include "lib/base/result.h"

// Functions that read and write whole files. An output file appears complete or not at all.

namespace gouge {

/// Default maximum size of an input: 8 GB.
inline constexpr std::uint64_t kMaxInputBytes = 8'000'000'000;

/// Returns the bytes of `path`, a file or a pipe. Errors: the same as InputReader (lib/base/input_file.h).
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::uint64_t max_bytes = kMaxInputBytes);

/// Reads a file as read_file does; it may be longer than memory.
[[nodiscard]] Result<PagedVector<char>> read_long_file(const std::string& path,
                                                       std::uint64_t max_bytes = kMaxInputBytes);

/// Writes a StagedFile and commits it at once. Readers see the old file or the whole new one. Links, owner and mode
/// stay.
/// Errors: file-unwritable (with the reason that the system gives).
[[nodiscard]] Outcome write_file(const std::string& path, std::string_view bytes);

/// Creates `path` and its parents. Errors: folder-unwritable.
[[nodiscard]] Outcome make_folder(const std::string& path);

/// Returns whether a file's name ends with `ending`, in any case, and is longer than it. `ending` has small letters and
/// includes the dot.
[[nodiscard]] inline bool has_ending(std::string_view file, std::string_view ending) {
  return file.size() > ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), file.rbegin(), [](char e, char f) { return e == small(f); });
}

/// The bytes of a file; valid as long as `keep` exists.
struct FileView {
  std::string_view bytes;
  std::shared_ptr<const void> keep;
};

/// Returns the same content as read_file, but without copying it to a string. The file is read, not mapped, for two
/// reasons. A mapped file that is cut short ends the program. A mapped file that is written meanwhile may show
/// different content to its checksum and to the check.
[[nodiscard]] Result<FileView> view_file(const std::string& path, std::uint64_t max_bytes = kMaxInputBytes);

}  // namespace gouge
