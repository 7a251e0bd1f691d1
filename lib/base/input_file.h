#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "lib/base/result.h"

namespace gouge {

/// A file that is read once from its begin to its end, with a limit on how much that may be. Endless input is refused:
/// devices before they are opened, pipes at the limit. A file that changes while it is read is refused too, as its
/// bytes would be half old and half new.
class InputReader {
 public:
  /// A terminal is read where it is this program's standard input. Opening a pipe waits for its writer.
  /// Errors: file-not-found, file-is-folder, file-unreadable, input-is-device, input-too-large (a file of more than
  /// `max_bytes`).
  [[nodiscard]] static Result<InputReader> open(const std::string& path, std::uint64_t max_bytes);

  InputReader(InputReader&& other) noexcept;
  InputReader& operator=(InputReader&&) = delete;
  ~InputReader();

  /// Returns the expected number of bytes; 0 where only reading shows it.
  [[nodiscard]] std::size_t expected_bytes() const;

  /// Reads the next bytes, at most `room`, to `to`, and returns their number; 0 at the end. Requires room > 0.
  /// Errors: file-unreadable, input-too-large, input-changed.
  [[nodiscard]] Result<std::size_t> read(char* to, std::size_t room);

 private:
  InputReader(std::string path, int handle, const struct stat& before, std::uint64_t max_bytes);

  std::string path_;
  int handle_ = -1;
  struct stat before_;
  std::uint64_t max_bytes_ = 0, bytes_ = 0;
};

}  // namespace gouge
