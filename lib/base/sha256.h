#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace gouge {

/// SHA-256 (FIPS 180-4) of bytes that come piece by piece: two files of one hash are the same file, and `sha256sum`
/// prints the same digits. By libcrypto, with the instructions of the processor where it has them (about 2 GB/s).
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void add(std::string_view bytes);
  /// Returns 64 hexadecimal digits of all that was added; nothing may be added after it.
  [[nodiscard]] std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] std::string sha256_of(std::string_view bytes);

}  // namespace gouge
