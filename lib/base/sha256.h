#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gouge {

/// SHA-256 (FIPS 180-4) of bytes that come piece by piece: two files of one hash are the same file.
class Sha256 {
 public:
  void add(std::string_view bytes);
  /// 64 hexadecimal digits of all that was added; nothing may be added after it.
  [[nodiscard]] std::string finish();

 private:
  void take_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> block_{};
  std::size_t filled_ = 0;
  std::uint64_t bytes_ = 0;
};

[[nodiscard]] std::string sha256_of(std::string_view bytes);

}  // namespace gouge
