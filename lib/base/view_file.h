#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "lib/base/files.h"
#include "lib/base/result.h"

namespace gouge {

/// The bytes of a file, there as long as `keep` is.
struct FileView {
  std::string_view bytes;
  std::shared_ptr<const void> keep;
};

/// As read_file, without the copy a string takes. The file is read and not mapped: a mapped file that is cut
/// short ends the program, and one that is written meanwhile gives one content to its checksum and another to
/// the check.
[[nodiscard]] Result<FileView> view_file(const std::string& path, std::uint64_t most_bytes = kMaxInputBytes);

}  // namespace gouge
