#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace gouge {

/// SHA-256 (FIPS 180-4) of bytes that are added piece by piece. Two files with the same hash are the same file, and
/// `sha256sum` prints the same digits. It uses libcrypto, with the processor's SHA instructions if available (about 2
/// GB/s).
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void add(std::string_view bytes);
  /// Returns 64 hexadecimal digits for all added bytes; nothing may be added after it.
  [[nodiscard]] std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] std::string sha256_of(std::string_view bytes);

}  // namespace gouge
