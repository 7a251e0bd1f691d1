#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The bytes of a certificate: docs/formats/certificate.md.

namespace gouge {

/// Certificates without and with proofs about stock. Both have the same length.
inline constexpr std::string_view kCertificateMagic = "gougecheck proof 2\n",
                                  kStockCertificateMagic = "gougecheck proof 3\n";
inline constexpr std::size_t kMaxBlockBytes = 1U << 26U, kMaxMovesOfGroup = 256;

/// Moves [first, first + count) and the steps of their proof.
struct ProofGroup {
  std::size_t first = 0, count = 0;
  std::string steps;
};

/// Lengths of the claims about stock. mm.
struct StockLengths {
  double tolerance_mm = 0, resolution_mm = 0;
};

/// The header before the blocks.
struct CertificateHeader {
  std::string inputs;  ///< 64 hexadecimal digits
  std::uint64_t moves = 0, part_triangles = 0, fixture_triangles = 0;
  double tolerance_mm = 0, resolution_mm = 0;
  std::string law;                      ///< the law of motion and the kind of rapids; at most kLawBytes
  std::optional<StockLengths> stock{};  ///< nothing: there are no proofs about stock
};

[[nodiscard]] std::string to_bytes(const CertificateHeader& header);
inline constexpr std::size_t kLawBytes = 32;
[[nodiscard]] constexpr std::size_t header_bytes(bool has_stock) {
  return 64 + 5 * 8 + kLawBytes + (has_stock ? 2 * 8 : 0);
}
/// Reads a header. Requires as many bytes as one of both has.
[[nodiscard]] CertificateHeader header_of(std::string_view bytes);

/// A number in LEB128 form.
void put_number(std::string& out, std::uint64_t value);
/// Removes a number from the beginning; nothing: there is none below 2^63.
[[nodiscard]] std::optional<std::uint64_t> take_number(std::string_view& bytes);

/// Returns a block, preceded by its length. A block without groups is the end.
[[nodiscard]] std::string block_bytes(const std::vector<ProofGroup>& groups);
/// Returns the length of a block from the bytes before it. Requires 4 bytes.
[[nodiscard]] std::uint32_t block_length(std::string_view bytes);
/// Returns the groups of a block. Returns nothing if the bytes are not a block, or if a group is empty or ends beyond
/// `moves`. Also returns nothing if a group begins before `min_move` or before the end of the previous group.
[[nodiscard]] std::optional<std::vector<ProofGroup>> groups_of(std::string_view block, std::size_t min_move,
                                                               std::size_t moves);

}  // namespace gouge
