#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

// Zstandard, piece by piece.

namespace gouge {

class ZstdWriter {
 public:
  ZstdWriter();
  ~ZstdWriter();
  void add(std::string_view bytes);
  /// Returns all of it; nothing may be added after it.
  [[nodiscard]] std::string finish();

 private:
  struct State;
  void run(std::string_view bytes, bool is_end);
  std::unique_ptr<State> state_;
};

class ZstdReader {
 public:
  /// `bytes` must outlive it.
  explicit ZstdReader(std::string_view bytes);
  ~ZstdReader();
  /// Returns the next `count` bytes; fewer where the stream ends, or where it is broken (is_broken).
  [[nodiscard]] std::string take(std::size_t count);
  [[nodiscard]] bool is_broken() const;
  /// Returns whether nothing is left, and the check sum at the end was right.
  [[nodiscard]] bool is_at_end();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace gouge
