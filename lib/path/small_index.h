#pragma once

#include <cstddef>
#include <cstdint>

namespace gouge {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A count or an index below 2^32 - 1, or kNone, in half the memory of the std::size_t it reads as: a toolpath
/// has millions of them. Requires what it is given to be one; read_toolpath takes no file with more.
class SmallIndex {
 public:
  constexpr SmallIndex(std::size_t value = 0) : value_(static_cast<std::uint32_t>(value)) {}
  constexpr operator std::size_t() const { return value_ == kNoValue ? kNone : value_; }

 private:
  static constexpr std::uint32_t kNoValue = static_cast<std::uint32_t>(kNone);

  std::uint32_t value_;
};

}  // namespace gouge
