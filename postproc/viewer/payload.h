#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"

namespace gouge {

/// Scene data for a browser: a JSON text and its numbers, deflated together and written as base64.
///
/// Before compression it has three parts, one after the other. The first is the length of the JSON text, a
/// little-endian number of four bytes. The text and the planes of numbers follow. A plane has the lowest byte of each
/// number, then the next byte of each, and so on. Then neighbouring bytes are similar, which compresses well. The JSON
/// names each run of planes by its first byte, its count and its width.
class Payload {
 public:
  /// Makes room for so many more bytes. Without room, the numbers of a large mesh are in memory twice while they grow.
  void reserve(std::size_t bytes) { planes_.reserve(planes_.size() + bytes); }
  /// Adds `count` numbers below 256^bytes: number(i) for each i in turn. Returns their description for the JSON.
  template <typename Number>
  nlohmann::ordered_json add(std::size_t count, int bytes, const Number& number) {
    const std::size_t at = planes_.size();
    planes_.resize(at + count * static_cast<std::size_t>(bytes));
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t value = number(i);
      for (int plane = 0; plane < bytes; ++plane)
        planes_[at + static_cast<std::size_t>(plane) * count + i] = static_cast<char>((value >> (8 * plane)) & 0xFFU);
    }
    return {{"at", at}, {"count", count}, {"bytes", bytes}};
  }
  nlohmann::ordered_json add(std::span<const std::uint32_t> numbers, int bytes);
  /// Adds each number as its difference from the previous one, modulo 256^bytes. Small differences are near 0 and near
  /// the top. They are folded (0, -1, 1, -2, ...), so that all of them become small.
  nlohmann::ordered_json add_differences(std::span<const std::uint32_t> numbers, int bytes);

  /// Returns base64 of the compressed data. Errors: page-not-packed, if there is no memory for it.
  [[nodiscard]] Result<std::string> text(const nlohmann::ordered_json& json) const;

 private:
  std::string planes_;
};

}  // namespace gouge
