#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "lib/geom/vec.h"

namespace gouge {

/// Bytes to which numbers are appended, the lowest byte first on any machine. -0 becomes 0.
class LittleEndian {
 public:
  void u8(std::uint8_t value) { bytes_ += static_cast<char>(value); }
  void u16(std::uint16_t value) { append(value, 2); }
  void u32(std::uint32_t value) { append(value, 4); }
  void u64(std::uint64_t value) { append(value, 8); }
  void i32(std::int32_t value) { u32(std::bit_cast<std::uint32_t>(value)); }
  void i64(std::int64_t value) { u64(std::bit_cast<std::uint64_t>(value)); }
  void f32(float value) { u32(std::bit_cast<std::uint32_t>(value + 0.0F)); }
  void f64(double value) { u64(std::bit_cast<std::uint64_t>(value + 0.0)); }
  void f64(const Vec3& v) {
    for (int k = 0; k < 3; ++k) f64(v[k]);
  }
  void f32(const Eigen::Vector3f& v) {
    for (int k = 0; k < 3; ++k) f32(v[k]);
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void append(std::uint64_t value, unsigned count) {
    for (unsigned k = 0; k < count; ++k) bytes_ += static_cast<char>(value >> (8 * k) & 0xffU);
  }

  std::string bytes_;
};

}  // namespace gouge
