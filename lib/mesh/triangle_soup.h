#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/geom/vec.h"

// The content of an STL file: triangles without connections to each other (thesis 4.1.1).

namespace gouge {

using TrianglePoints = std::array<Vec3, 3>;

/// Triangles in file order. They are stored as points, or read from the records of a binary STL where these are. The
/// latter avoids a copy of 72 bytes for each triangle. A record has 50 bytes: normal, three corners, two bytes of
/// attributes.
class TriangleList {
 public:
  static constexpr std::size_t kRecordSize = 50;

  TriangleList() = default;
  TriangleList(std::vector<TrianglePoints> points) : points_(std::move(points)) {}  // NOLINT: a plain list
  /// Makes a list of records. They must stay where they are, unless `keep` ensures that.
  explicit TriangleList(std::string_view records, std::shared_ptr<const void> keep = nullptr)
      : records_(records), keep_(std::move(keep)) {}

  [[nodiscard]] std::size_t size() const { return points_.size() + records_.size() / kRecordSize; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] TrianglePoints operator[](std::size_t i) const {
    if (!points_.empty()) return points_[i];
    const std::size_t at = kRecordSize * i;
    return {vector_at(records_, at + 12), vector_at(records_, at + 24), vector_at(records_, at + 36)};
  }

  /// Appends a triangle. Requires a list of points.
  void push_back(const TrianglePoints& triangle) { points_.push_back(triangle); }
  void reserve(std::size_t count) { points_.reserve(count); }

  /// Returns the vector of three little-endian single-precision numbers at an offset.
  [[nodiscard]] static Vec3 vector_at(std::string_view bytes, std::size_t at) {
    return {number_at(bytes, at), number_at(bytes, at + 4), number_at(bytes, at + 8)};
  }
  [[nodiscard]] static std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap32(word);
    return word;
  }

 private:
  [[nodiscard]] static double number_at(std::string_view bytes, std::size_t at) {
    return static_cast<double>(std::bit_cast<float>(word_at(bytes, at)));
  }

  std::vector<TrianglePoints> points_;
  std::string_view records_;
  std::shared_ptr<const void> keep_;
};

enum class StlFormat { binary, ascii };

struct TriangleSoup {
  std::string name;  ///< as the user named the file
  StlFormat format = StlFormat::binary;
  TriangleList triangles;  ///< file coordinates and file units; finite
  /// Stored normals that point to the other side of their triangle. They are never used for orientation.
  std::size_t opposite_normals = 0;
  std::size_t first_opposite_normal = 0;  ///< index of the first such normal; 0 if there is none
  Diagnostics notes;                      ///< oddities of the file that were tolerated
};

}  // namespace gouge
