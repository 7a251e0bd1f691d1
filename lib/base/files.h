#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "lib/base/paged_memory.h"
#include "lib/base/result.h"

// Whole files in, whole files out. An output file appears complete or not at all.

namespace gouge {

/// Default maximum size of an input: 8 GB.
inline constexpr std::uint64_t kMaxInputBytes = 8'000'000'000;

/// Returns the bytes of `path`, a file or a pipe. Errors: those of InputReader (lib/base/input_file.h).
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::uint64_t max_bytes = kMaxInputBytes);

/// Reads a file as read_file does; it may be longer than memory.
[[nodiscard]] Result<PagedVector<char>> read_long_file(const std::string& path,
                                                       std::uint64_t max_bytes = kMaxInputBytes);

/// Writes a StagedFile and commits it at once. Readers see the old file or the whole new one; links, owner and mode
/// stay.
/// Errors: file-unwritable (with the system's reason).
[[nodiscard]] Outcome write_file(const std::string& path, std::string_view bytes);

/// Creates `path` and its parents. Errors: folder-unwritable.
[[nodiscard]] Outcome make_folder(const std::string& path);

/// Returns whether a file's name has something before `ending` and then that, in any case. `ending`: in small letters,
/// with its dot.
[[nodiscard]] inline bool has_ending(std::string_view file, std::string_view ending) {
  return file.size() > ending.size() && std::equal(ending.rbegin(), ending.rend(), file.rbegin(), [](char e, char f) {
           return e == (f >= 'A' && f <= 'Z' ? static_cast<char>(f - 'A' + 'a') : f);
         });
}

/// The bytes of a file, there as long as `keep` is.
struct FileView {
  std::string_view bytes;
  std::shared_ptr<const void> keep;
};

/// Returns the content as read_file does, without the copy that a string takes. The file is read and not mapped. A
/// mapped file that is cut short ends the program. One that is written meanwhile gives one content to its checksum and
/// another to the check.
[[nodiscard]] Result<FileView> view_file(const std::string& path, std::uint64_t max_bytes = kMaxInputBytes);

}  // namespace gouge
