#include "lib/mesh/binary_stl.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/mesh/ascii_stl.h"
#include "lib/mesh/mesh_builder.h"
#include "lib/mesh/mesh_findings.h"

namespace gouge::detail {
namespace {

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kFacetSize = TriangleList::kRecordSize;
constexpr std::size_t kAttributeAt = 48;  // offset of the attribute byte count in a facet

std::size_t stated_count(std::string_view bytes) { return TriangleList::word_at(bytes, 80); }

std::size_t attribute_at(std::string_view bytes, std::size_t facet_at) {
  const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at])); };
  return byte(facet_at + kAttributeAt) + 256 * byte(facet_at + kAttributeAt + 1);
}

TrianglePoints corners_at(std::string_view bytes, std::size_t facet_at) {
  return {TriangleList::vector_at(bytes, facet_at + 12), TriangleList::vector_at(bytes, facet_at + 24),
          TriangleList::vector_at(bytes, facet_at + 36)};
}

// The offsets at which the facets of a file begin.
class FacetPlaces {
 public:
  // Facets without gaps: each begins 50 bytes after the one before.
  explicit FacetPlaces(std::size_t count) : count_(count) {}

  // Facets with attribute bytes: the number of bytes between two facets is the attribute byte count of the first.
  // Returns nothing unless the last one ends with the file.
  static std::optional<FacetPlaces> with_attributes(std::string_view bytes, std::size_t count) {
    FacetPlaces places(count);
    places.starts_.reserve(count);
    std::size_t at = kHeaderSize;
    for (std::size_t i = 0; i < count; ++i) {
      if (at + kFacetSize > bytes.size()) return std::nullopt;
      places.starts_.push_back(at);
      at += kFacetSize + attribute_at(bytes, at);
    }
    if (at != bytes.size()) return std::nullopt;
    return places;
  }

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::size_t operator[](std::size_t i) const {
    return starts_.empty() ? kHeaderSize + kFacetSize * i : starts_[i];
  }

 private:
  std::size_t count_;
  std::vector<std::size_t> starts_;  // empty: evenly spaced
};

bool are_same(const FacetPlaces& a, const FacetPlaces& b) {
  return a[a.size() - 1] == b[b.size() - 1];  // offsets only move towards the end of the file
}

bool has_attributes(std::string_view bytes, std::size_t count) {
  const FacetPlaces places(count);
  for (std::size_t i = 0; i < count; ++i)
    if (attribute_at(bytes, places[i]) != 0) return true;
  return false;
}

// Rejects coordinates that are not numbers, and counts the stored normals.
Outcome count_facets(TriangleSoup& soup, std::string_view bytes, const FacetPlaces& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const TrianglePoints triangle = soup.triangles[i];
    const auto& [a, b, c] = triangle;
    if (!a.allFinite() || !b.allFinite() || !c.allFinite()) {
      return make_error("stl-bad-number",
                        "triangle " + std::to_string(i + 1) + " of " + std::to_string(places.size()) +
                            " has a coordinate that is infinite or not a number; expected finite coordinates",
                        soup.name);
    }
    count_normal(soup, i, triangle, TriangleList::vector_at(bytes, places[i]));
  }
  return Done{};
}

TriangleSoup empty_soup(const std::string& name) {
  TriangleSoup soup;
  soup.name = name;
  soup.format = StlFormat::binary;
  return soup;
}

Result<TriangleSoup> read_plain(std::string_view bytes, std::size_t count, const std::string& name,
                                std::shared_ptr<const void> keep) {
  TriangleSoup soup = empty_soup(name);
  soup.triangles = TriangleList(bytes.substr(kHeaderSize, kFacetSize * count), std::move(keep));
  if (const Outcome counted = count_facets(soup, bytes, FacetPlaces(count)); !counted) return counted.error();
  const std::size_t extra = bytes.size() - kHeaderSize - kFacetSize * count;
  if (extra > 0)
    soup.notes.push_back(
        make_note("stl-trailing-bytes", count_text(extra, "byte") + " after the last triangle ignored", name));
  return soup;
}

Result<TriangleSoup> read_spread(std::string_view bytes, const FacetPlaces& places, const std::string& name) {
  TriangleSoup soup = empty_soup(name);
  soup.triangles.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) soup.triangles.push_back(corners_at(bytes, places[i]));
  if (const Outcome counted = count_facets(soup, bytes, places); !counted) return counted.error();
  const std::size_t extra = bytes.size() - kHeaderSize - kFacetSize * places.size();
  soup.notes.push_back(make_note(
      "stl-attribute-bytes",
      count_text(extra, "byte") + " behind the triangles ignored, as their attribute byte counts state", name));
  return soup;
}

// Returns whether the stored normals are unit vectors along those of the corners. More than half of the facets must
// match, and all others must be too thin for a comparison. In a shifted facet, parts of corners are in place of its
// normal.
bool has_matching_normals(std::string_view bytes, const FacetPlaces& places) {
  constexpr double kThinnest = 1e-3;  // area over longest side squared
  constexpr double kAlike = 0.01;
  std::size_t alike = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [a, b, c] = corners_at(bytes, places[i]);
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 cross = ab.cross(ac);
    const double longest2 = std::max(ab.squaredNorm(), ac.squaredNorm());
    if (!(cross.norm() > kThinnest * longest2)) continue;
    const Vec3 normal = TriangleList::vector_at(bytes, places[i]);
    if (!(std::abs(std::abs(normal.dot(cross) / cross.norm()) - 1) < kAlike)) return false;
    if (!(std::abs(normal.norm() - 1) < kAlike)) return false;
    ++alike;
  }
  return 2 * alike > places.size();
}

// Returns whether any stored normal is neither zero nor a unit vector.
bool has_odd_normal(std::string_view bytes, const FacetPlaces& places) {
  constexpr double kAlike = 0.01;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double length = TriangleList::vector_at(bytes, places[i]).norm();
    if (length > 0 && !(std::abs(length - 1) < kAlike)) return true;
  }
  return false;
}

// Returns whether every edge of the triangles has a partner in the opposite direction.
bool is_watertight(const TriangleSoup& soup) {
  const Result<BuiltMesh> built = build_mesh(soup);
  return built && find_mesh_findings(*built).is_watertight();
}

bool is_confirmed(std::string_view bytes, const FacetPlaces& places, const Result<TriangleSoup>& soup) {
  return soup && (has_matching_normals(bytes, places) || is_watertight(*soup));
}

Diagnostic refuse_bytes(std::string_view bytes, std::size_t count, const std::string& name) {
  return make_error("stl-facet-bytes",
                    "the header states " + count_text(count, "triangle") + " (" +
                        std::to_string(kHeaderSize + kFacetSize * count) + " bytes) but the file has " +
                        std::to_string(bytes.size()) +
                        ", and the others may lie between the triangles, so that their places are uncertain; export it "
                        "again without attributes",
                    name);
}

// Parses a file with the size that its header states. With bytes after each facet it would be longer, except for a rare
// file that was cut off at exactly this size. Such a file has attributes, and its shifted facets have arbitrary
// normals.
Result<TriangleSoup> parse_exact(std::string_view bytes, std::size_t count, const std::string& name,
                                 std::shared_ptr<const void> keep) {
  Result<TriangleSoup> soup = read_plain(bytes, count, name, std::move(keep));
  const FacetPlaces plain(count);
  if (!soup || !has_attributes(bytes, count) || !has_odd_normal(bytes, plain) || is_watertight(*soup)) return soup;
  return make_error(
      "stl-facet-bytes",
      "attribute bytes are set, normals are no unit vectors and the surface is open, so that the file may "
      "be cut off and have bytes between its triangles; export it again without attributes",
      name);
}

// Parses a file that is longer than its header states.
Result<TriangleSoup> parse_with_extra(std::string_view bytes, std::size_t count, const std::string& name,
                                      std::shared_ptr<const void> keep) {
  const std::string_view extra = bytes.substr(kHeaderSize + kFacetSize * count);
  const FacetPlaces plain(count);
  const bool has_attribute = has_attributes(bytes, count);
  // The extra bytes may follow the last facet if they are too few for a facet or all zero.
  const bool may_be_tail =
      extra.size() < kFacetSize || std::all_of(extra.begin(), extra.end(), [](char c) { return c == '\0'; });
  const auto spread = has_attribute ? FacetPlaces::with_attributes(bytes, count) : std::nullopt;
  if (!may_be_tail && !spread) {
    return make_error("stl-trailing-data",
                      "the header states " + count_text(count, "triangle") + " but " +
                          count_text(extra.size(), "byte") +
                          " follow them; expected the file to end there, export it again",
                      name);
  }
  Result<TriangleSoup> as_plain = read_plain(bytes, count, name, std::move(keep));
  // Without attributes each facet begins at the end of the one before, unless undeclared bytes follow each facet.
  const bool may_be_even = count > 1 && extra.size() + 1 >= count;
  if (may_be_tail && !has_attribute && !may_be_even) return as_plain;
  if (spread && are_same(*spread, plain)) return read_spread(bytes, *spread, name);
  const bool is_plain = may_be_tail && is_confirmed(bytes, plain, as_plain);
  if (!spread) return is_plain ? std::move(as_plain) : refuse_bytes(bytes, count, name);
  Result<TriangleSoup> as_spread = read_spread(bytes, *spread, name);
  if (is_confirmed(bytes, *spread, as_spread) == is_plain) return refuse_bytes(bytes, count, name);
  return is_plain ? as_plain : as_spread;
}

}  // namespace

bool has_binary_stl_header(std::string_view bytes) { return bytes.size() >= kHeaderSize; }

bool has_binary_stl_size(std::string_view beginning, std::uint64_t size) {
  return has_binary_stl_header(beginning) && size == kHeaderSize + kFacetSize * stated_count(beginning);
}

Result<TriangleSoup> parse_binary_stl(std::string_view bytes, const std::string& name,
                                      std::shared_ptr<const void> keep) {
  const std::size_t count = stated_count(bytes);
  const std::size_t body = bytes.size() - kHeaderSize;
  const bool is_blank = std::all_of(bytes.begin() + kHeaderSize, bytes.end(), [](char c) { return c == '\0'; });
  if (count == 0 && (body < kFacetSize || is_blank)) {
    return make_error("stl-no-triangles", "the binary STL holds no triangle; expected at least one", name);
  }
  if (body / kFacetSize < count) {
    return make_error("stl-truncated",
                      "the header states " + count_text(count, "triangle") + " (" +
                          std::to_string(kHeaderSize + kFacetSize * count) + " bytes) but the file holds " +
                          std::to_string(body / kFacetSize) + " whole (" + std::to_string(bytes.size()) +
                          " bytes); it is cut off or not an STL, export or copy it again",
                      name);
  }
  if (body == kFacetSize * count) return parse_exact(bytes, count, name, std::move(keep));
  return parse_with_extra(bytes, count, name, std::move(keep));
}

}  // namespace gouge::detail
