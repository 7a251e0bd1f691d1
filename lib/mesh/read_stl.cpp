#include "lib/mesh/read_stl.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/view_file.h"
#include "lib/mesh/ascii_stl.h"
#include "lib/mesh/foreign_mesh.h"

namespace gouge {
namespace {

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kTriangleSize = TriangleList::kRecordSize;

bool is_text(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    return (c >= ' ' && c != '\x7f') || c == '\t' || c == '\n' || c == '\r' || c == '\f' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

// Anything wrong with the size of a binary file: the error, or a note about tolerated bytes.
Outcome check_size(std::string_view bytes, TriangleSoup& soup) {
  const std::size_t stated = TriangleList::word_at(bytes, 80);
  const std::size_t body = bytes.size() - kHeaderSize;
  if (stated == 0 && body < kTriangleSize) {
    return make_error("stl-no-triangles", "the binary STL holds no triangle; expected at least one", soup.name);
  }
  if (body / kTriangleSize < stated) {
    return make_error("stl-truncated",
                      "the header states " + count_text(stated, "triangle") + " (" +
                          std::to_string(kHeaderSize + kTriangleSize * stated) + " bytes) but the file holds " +
                          std::to_string(body / kTriangleSize) + " whole (" + std::to_string(bytes.size()) +
                          " bytes); it is cut off or not an STL, export or copy it again",
                      soup.name);
  }
  const std::string_view extra = bytes.substr(kHeaderSize + kTriangleSize * stated);
  if (extra.empty()) return Done{};
  const bool is_padding = std::all_of(extra.begin(), extra.end(), [](char c) { return c == '\0'; });
  if (extra.size() >= kTriangleSize && !is_padding) {
    return make_error("stl-trailing-data",
                      "the header states " + count_text(stated, "triangle") + " but " +
                          count_text(extra.size(), "byte") +
                          " follow them; expected the file to end there, export it again",
                      soup.name);
  }
  soup.notes.push_back(make_note("stl-trailing-bytes",
                                 count_text(extra.size(), "byte") + " after the last triangle ignored", soup.name));
  return Done{};
}

Result<TriangleSoup> parse_binary_stl(std::string_view bytes, const std::string& name,
                                      std::shared_ptr<const void> keep) {
  TriangleSoup soup;
  soup.name = name;
  soup.format = StlFormat::binary;
  if (const Outcome size = check_size(bytes, soup); !size) return size.error();
  const std::size_t count = TriangleList::word_at(bytes, 80);
  soup.triangles = TriangleList(bytes.substr(kHeaderSize, kTriangleSize * count), std::move(keep));
  for (std::size_t i = 0; i < count; ++i) {
    const TrianglePoints triangle = soup.triangles[i];
    const auto& [a, b, c] = triangle;
    if (!a.allFinite() || !b.allFinite() || !c.allFinite()) {
      return make_error("stl-bad-number",
                        "triangle " + std::to_string(i + 1) + " of " + std::to_string(count) +
                            " has a coordinate that is infinite or not a number; expected finite coordinates",
                        name);
    }
    detail::count_normal(soup, i, triangle, TriangleList::vector_at(bytes, kHeaderSize + kTriangleSize * i));
  }
  return soup;
}

}  // namespace

Result<TriangleSoup> parse_stl(std::string_view bytes, const std::string& name, std::shared_ptr<const void> keep) {
  if (bytes.empty()) {
    return make_error("stl-empty", "the file is empty (0 bytes); expected a binary or ASCII STL", name);
  }
  const bool has_header = bytes.size() >= kHeaderSize;
  if (has_header && bytes.size() == kHeaderSize + kTriangleSize * TriangleList::word_at(bytes, 80)) {
    return parse_binary_stl(bytes, name, std::move(keep));
  }
  if (detail::looks_like_ascii_stl(bytes)) return detail::parse_ascii_stl(bytes, name);
  const bool is_plain = is_text(bytes.substr(0, 4096));
  if (const auto foreign = describe_foreign_mesh(bytes, is_plain))
    return make_error("stl-not-stl", "the file " + *foreign, name);
  if (is_plain) {
    return make_error("stl-not-stl", "the file is text but not ASCII STL; expected it to begin with 'solid'", name);
  }
  if (!has_header) {
    return make_error("stl-truncated",
                      "the file has " + count_text(bytes.size(), "byte") +
                          "; a binary STL has at least 84 and an ASCII one begins with 'solid'",
                      name);
  }
  return parse_binary_stl(bytes, name, std::move(keep));
}

Result<TriangleSoup> read_stl(const std::string& path) {
  const Result<FileView> file = view_file(path);
  if (!file) return file.error();
  return parse_stl(file->bytes, path, file->keep);
}

}  // namespace gouge
