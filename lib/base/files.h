#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lib/base/paged_memory.h"
#include "lib/base/result.h"

// Whole files in, whole files out. An output file appears complete or not at all.

namespace gouge {

/// What an input may have where the user does not say otherwise: 8 GB.
inline constexpr std::uint64_t kMaxInputBytes = 8'000'000'000;

/// The bytes of `path`, a file or a pipe. Errors: those of InputReader (lib/base/input_file.h).
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::uint64_t most_bytes = kMaxInputBytes);

/// As read_file, of a file that may be longer than memory.
[[nodiscard]] Result<PagedVector<char>> read_long_file(const std::string& path,
                                                       std::uint64_t most_bytes = kMaxInputBytes);

/// A StagedFile that is committed at once: readers see the old file or the whole new one; links, owner and mode stay.
/// Errors: file-unwritable (with the system's reason).
[[nodiscard]] Outcome write_file(const std::string& path, std::string_view bytes);

/// Creates `path` and its parents. Errors: folder-unwritable.
[[nodiscard]] Outcome make_folder(const std::string& path);

}  // namespace gouge
