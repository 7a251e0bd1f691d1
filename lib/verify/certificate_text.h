#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The bytes of a certificate: docs/formats/certificate.md.

namespace gouge {

inline constexpr std::string_view kCertificateMagic = "gougecheck proof 2\n";
inline constexpr std::size_t kMaxBlockBytes = 1U << 26U, kMaxMovesOfGroup = 256;

/// Moves [first, first + count) and the steps of their proof.
struct ProofGroup {
  std::size_t first = 0, count = 0;
  std::string steps;
};

/// The header before the blocks.
struct CertificateHeader {
  std::string inputs;  ///< 64 hexadecimal digits
  std::uint64_t moves = 0, part_triangles = 0, fixture_triangles = 0;
  double tolerance_mm = 0, resolution_mm = 0;
  std::string law;  ///< the law of motion and the kind of rapids; at most kLawBytes
};

[[nodiscard]] std::string to_bytes(const CertificateHeader& header);
inline constexpr std::size_t kLawBytes = 32;
inline constexpr std::size_t kHeaderBytes = 64 + 5 * 8 + kLawBytes;
/// Reads a header. Requires kHeaderBytes bytes.
[[nodiscard]] CertificateHeader header_of(std::string_view bytes);

/// Returns a block, preceded by its length. A block without groups is the end.
[[nodiscard]] std::string block_bytes(const std::vector<ProofGroup>& groups);
/// Returns the length of a block from the bytes before it. Requires 4 bytes.
[[nodiscard]] std::uint32_t block_length(std::string_view bytes);
/// Returns the groups of a block. Returns nothing if the bytes are not a block, or if a group is empty or ends beyond
/// `moves`. Also returns nothing if a group begins before `min_move` or before the end of the previous group.
[[nodiscard]] std::optional<std::vector<ProofGroup>> groups_of(std::string_view block, std::size_t min_move,
                                                               std::size_t moves);

}  // namespace gouge
