#include "lib/verify/certificate_text.h"

#include <bit>

namespace gouge {
namespace {

void put_fixed(std::string& out, std::uint64_t value, std::size_t bytes) {
  for (std::size_t k = 0; k < bytes; ++k) out.push_back(static_cast<char>((value >> (8 * k)) & 0xff));
}

std::uint64_t fixed_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < count; ++k) value |= std::uint64_t{static_cast<unsigned char>(bytes[at + k])} << (8 * k);
  return value;
}

}  // namespace

void put_number(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>((value & 0x7f) | 0x80));
  out.push_back(static_cast<char>(value));
}

std::optional<std::uint64_t> take_number(std::string_view& bytes) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 63 && !bytes.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    value |= std::uint64_t{byte & 0x7fU} << shift;
    if (byte < 0x80) return value;
  }
  return std::nullopt;
}

std::string to_bytes(const CertificateHeader& h) {
  std::string out = h.inputs;
  for (const std::uint64_t value :
       {h.moves, h.part_triangles, h.fixture_triangles, std::bit_cast<std::uint64_t>(h.tolerance_mm),
        std::bit_cast<std::uint64_t>(h.resolution_mm)})
    put_fixed(out, value, 8);
  out += h.law;
  out.resize(header_bytes(false), '\0');
  if (h.stock)
    for (const double value : {h.stock->tolerance_mm, h.stock->resolution_mm})
      put_fixed(out, std::bit_cast<std::uint64_t>(value), 8);
  return out;
}

CertificateHeader header_of(std::string_view bytes) {
  const auto word = [&](std::size_t k) { return fixed_at(bytes, 64 + 8 * k, 8); };
  const std::string_view law = bytes.substr(header_bytes(false) - kLawBytes, kLawBytes);
  CertificateHeader header{std::string(bytes.substr(0, 64)),
                           word(0),
                           word(1),
                           word(2),
                           std::bit_cast<double>(word(3)),
                           std::bit_cast<double>(word(4)),
                           std::string(law.substr(0, law.find('\0'))),
                           std::nullopt};
  const auto length = [&](std::size_t k) {
    return std::bit_cast<double>(fixed_at(bytes, header_bytes(false) + 8 * k, 8));
  };
  if (bytes.size() == header_bytes(true)) header.stock = StockLengths{length(0), length(1)};
  return header;
}

std::string block_bytes(const std::vector<ProofGroup>& groups) {
  std::string content;
  for (const ProofGroup& group : groups) {
    put_number(content, group.first);
    put_number(content, group.count);
    put_number(content, group.steps.size());
    content += group.steps;
  }
  std::string out;
  put_fixed(out, content.size(), 4);
  return out + content;
}

std::uint32_t block_length(std::string_view bytes) { return static_cast<std::uint32_t>(fixed_at(bytes, 0, 4)); }

std::optional<std::vector<ProofGroup>> groups_of(std::string_view block, std::size_t min_move, std::size_t moves) {
  std::vector<ProofGroup> groups;
  while (!block.empty()) {
    const auto first = take_number(block), count = take_number(block), length = take_number(block);
    if (!first || !count || !length || *first < min_move || *first >= moves || *count == 0 ||
        *count > kMaxMovesOfGroup || *count > moves - *first || *length > block.size())
      return std::nullopt;
    groups.push_back({*first, *count, std::string(block.substr(0, *length))});
    block.remove_prefix(*length);
    min_move = *first + *count;
  }
  return groups;
}

}  // namespace gouge
