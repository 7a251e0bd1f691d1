#include "lib/mesh/read_stl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "lib/base/files.h"
#include "lib/mesh/ascii_stl.h"

namespace gouge {
namespace {

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kTriangleSize = 50;

// STL is little-endian; the shifts below say so without asking what the machine is.
std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap32(word);
  return word;
}

Vec3 vector_at(std::string_view bytes, std::size_t at) {
  const auto number = [&](std::size_t k) {
    return static_cast<double>(std::bit_cast<float>(word_at(bytes, at + 4 * k)));
  };
  return {number(0), number(1), number(2)};
}

std::string count_text(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

bool is_text(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    return (c >= ' ' && c != '\x7f') || c == '\t' || c == '\n' || c == '\r' || c == '\f' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

// Anything wrong with the size of a binary file: the error, or a note about tolerated bytes.
Outcome check_size(std::string_view bytes, TriangleSoup& soup) {
  const std::size_t promised = word_at(bytes, 80);
  const std::size_t body = bytes.size() - kHeaderSize;
  if (promised == 0 && body < kTriangleSize) {
    return make_error("stl-no-triangles", "the binary STL holds no triangle; expected at least one",
                      soup.name);
  }
  if (body / kTriangleSize < promised) {
    return make_error("stl-truncated",
                      "the header promises " + count_text(promised, "triangle") + " (" +
                          std::to_string(kHeaderSize + kTriangleSize * promised) +
                          " bytes) but the file holds " + std::to_string(body / kTriangleSize) + " whole (" +
                          std::to_string(bytes.size()) +
                          " bytes); it is cut off or not an STL, export or copy it again",
                      soup.name);
  }
  const std::string_view extra = bytes.substr(kHeaderSize + kTriangleSize * promised);
  if (extra.empty()) return Done{};
  const bool is_padding = std::all_of(extra.begin(), extra.end(), [](char c) { return c == '\0'; });
  if (extra.size() >= kTriangleSize && !is_padding) {
    return make_error("stl-trailing-data",
                      "the header promises " + count_text(promised, "triangle") + " but " +
                          count_text(extra.size(), "byte") +
                          " follow them; expected the file to end there, export it again",
                      soup.name);
  }
  soup.notes.push_back(make_note("stl-trailing-bytes",
                                 count_text(extra.size(), "byte") + " after the last triangle ignored",
                                 soup.name));
  return Done{};
}

Result<TriangleSoup> parse_binary_stl(std::string_view bytes, const std::string& name) {
  TriangleSoup soup;
  soup.name = name;
  soup.format = StlFormat::binary;
  if (const Outcome size = check_size(bytes, soup); !size) return size.error();
  const std::size_t count = word_at(bytes, 80);
  soup.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderSize + kTriangleSize * i;
    soup.triangles.push_back(
        {vector_at(bytes, at + 12), vector_at(bytes, at + 24), vector_at(bytes, at + 36)});
    const auto& [a, b, c] = soup.triangles.back();
    if (!a.allFinite() || !b.allFinite() || !c.allFinite()) {
      return make_error("stl-bad-number",
                        "triangle " + std::to_string(i + 1) + " of " + std::to_string(count) +
                            " has a coordinate that is infinite or not a number; expected finite coordinates",
                        name);
    }
    detail::count_normal(soup, vector_at(bytes, at));
  }
  return soup;
}

}  // namespace

Result<TriangleSoup> parse_stl(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) {
    return make_error("stl-empty", "the file is empty (0 bytes); expected a binary or ASCII STL", name);
  }
  const bool has_header = bytes.size() >= kHeaderSize;
  if (has_header && bytes.size() == kHeaderSize + kTriangleSize * word_at(bytes, 80)) {
    return parse_binary_stl(bytes, name);
  }
  if (detail::looks_like_ascii_stl(bytes)) return detail::parse_ascii_stl(bytes, name);
  if (is_text(bytes.substr(0, 4096))) {
    return make_error("stl-not-stl", "the file is text but not ASCII STL; expected it to begin with 'solid'",
                      name);
  }
  if (!has_header) {
    return make_error("stl-truncated",
                      "the file has " + count_text(bytes.size(), "byte") +
                          "; a binary STL has at least 84 and an ASCII one begins with 'solid'",
                      name);
  }
  return parse_binary_stl(bytes, name);
}

Result<TriangleSoup> read_stl(const std::string& path) {
  Result<std::string> bytes = read_file(path);
  if (!bytes) return bytes.error();
  return parse_stl(*bytes, path);
}

}  // namespace gouge
