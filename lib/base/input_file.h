#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "lib/base/result.h"

namespace gouge {

/// Reader of a file, once from its beginning to its end, with a maximum number of bytes. Endless input is rejected:
/// devices before they are opened, pipes at the maximum. A file that changes while it is read is rejected too: its
/// bytes would be partly old and partly new.
class InputReader {
 public:
  /// Opens a file, or standard input as "-", which only one reader can have. A terminal is accepted only as this
  /// program's standard input. Opening a pipe waits for its writer.
  /// Errors: file-not-found, file-is-folder, file-unreadable, input-is-device, input-too-large (a file of more than
  /// `max_bytes`), input-twice (standard input was read already).
  [[nodiscard]] static Result<InputReader> open(const std::string& path, std::uint64_t max_bytes);

  InputReader(InputReader&& other) noexcept;
  InputReader& operator=(InputReader&&) = delete;
  ~InputReader();

  /// Returns the expected number of bytes; 0 if it is known only after reading.
  [[nodiscard]] std::size_t expected_bytes() const;

  /// Reads the next bytes, at most `room`, into `to`, and returns their number; 0 at the end. Requires room > 0.
  /// Errors: file-unreadable, input-too-large, input-changed.
  [[nodiscard]] Result<std::size_t> read(char* to, std::size_t room);

 private:
  static constexpr const char* kStandardInput = "-";

  [[nodiscard]] static Result<InputReader> open_standard_input(std::uint64_t max_bytes);

  InputReader(std::string path, int handle, const struct stat& before, std::uint64_t max_bytes);

  std::string path_;
  int handle_ = -1;
  struct stat before_;
  std::uint64_t max_bytes_ = 0, bytes_ = 0;
};

}  // namespace gouge
