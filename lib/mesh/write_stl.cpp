#include "lib/mesh/write_stl.h"

#include <bit>
#include <cstdint>

namespace gouge {
namespace {

// The header does not begin with "solid": readers that use the first word would treat the file as ASCII.
constexpr std::string_view kHeader = "binary STL, written by gougecheck";
constexpr std::size_t kTextSize = 80;

void append_word(std::string& bytes, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((word >> shift) & 0xffU);
}

void append_vector(std::string& bytes, const Vec3& v) {
  for (int k = 0; k < 3; ++k) append_word(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(v[k])));
}

}  // namespace

std::string binary_stl_bytes(const IndexedMesh& mesh, LengthUnit unit) {
  std::string bytes;
  bytes.reserve(kTextSize + 4 + 50 * mesh.triangles.size());
  bytes = kHeader;
  bytes.resize(kTextSize, ' ');
  append_word(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 cross = (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0));
    append_vector(bytes, cross.normalized());
    for (std::size_t k = 0; k < 3; ++k) append_vector(bytes, mesh.corner(t, k) / mm_per(unit));
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace gouge
