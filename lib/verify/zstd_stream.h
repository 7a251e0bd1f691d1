#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

// Compression and decompression with Zstandard, piece by piece.

namespace gouge {

class ZstdWriter {
 public:
  ZstdWriter();
  ~ZstdWriter();
  void add(std::string_view bytes);
  /// Returns all compressed bytes. Nothing may be added afterwards.
  [[nodiscard]] std::string finish();

 private:
  struct State;
  void run(std::string_view bytes, bool is_end);
  std::unique_ptr<State> state_;
};

class ZstdReader {
 public:
  /// `bytes` must outlive the object.
  explicit ZstdReader(std::string_view bytes);
  ~ZstdReader();
  /// Returns the next `count` bytes; fewer if the stream ends or is broken (is_broken).
  [[nodiscard]] std::string take(std::size_t count);
  [[nodiscard]] bool is_broken() const;
  /// Returns whether all bytes are taken and the checksum at the end is correct.
  [[nodiscard]] bool is_at_end();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gouge
