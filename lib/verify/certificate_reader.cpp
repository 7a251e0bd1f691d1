#include "lib/verify/certificate_reader.h"

#include <cmath>

namespace gouge {

namespace {

bool is_alike(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

}  // namespace

Outcome CertificateReader::read_header(const CertificateHeader& expected) {
  const std::size_t size = header_bytes(expected.stock.has_value());
  const std::string bytes = stream_.take(size);
  if (bytes.size() != size) return cut_short();
  const CertificateHeader found = header_of(bytes);
  // The inputs include the turns of joints that the law uses, so a wrong law is named first.
  if (found.law != expected.law)
    return invalid("it proves the motion by the law '" + found.law + "'; expected the law of this result, '" +
                   expected.law + "'");
  if (found.inputs != expected.inputs)
    return invalid(
        "it proves something about other inputs; expected the certificate that was written with this result");
  const bool has_same_stock = !expected.stock || (is_alike(found.stock->tolerance_mm, expected.stock->tolerance_mm) &&
                                                  is_alike(found.stock->resolution_mm, expected.stock->resolution_mm));
  if (found.moves == expected.moves && found.part_triangles == expected.part_triangles &&
      found.fixture_triangles == expected.fixture_triangles && is_alike(found.tolerance_mm, expected.tolerance_mm) &&
      is_alike(found.resolution_mm, expected.resolution_mm) && has_same_stock)
    return Done{};
  return invalid(
      "it has other moves, triangles or tolerances than the result; expected the certificate that was written with "
      "this result");
}

Result<std::vector<ProofGroup>> CertificateReader::next() {
  const std::string length = stream_.take(4);
  if (length.size() != 4) return cut_short();
  const std::uint32_t size = block_length(length);
  if (size > kMaxBlockBytes) return invalid("a block of it is said to have more bytes than any has");
  if (size == 0) return std::vector<ProofGroup>{};
  const std::string block = stream_.take(size);
  if (block.size() != size) return cut_short();
  auto groups = groups_of(block, min_move_, moves_);
  if (!groups) return invalid("a block of it names moves that are not there, or not in order");
  min_move_ = groups->back().first + groups->back().count;
  return std::move(*groups);
}

Outcome CertificateReader::finish() {
  if (!stream_.is_at_end()) return invalid("it goes on after its end, or its check sum is wrong");
  return Done{};
}

Diagnostic CertificateReader::invalid(const std::string& what) const {
  return make_error("certificate-invalid", what, name_);
}

Diagnostic CertificateReader::cut_short() const {
  return invalid(stream_.is_broken() ? "its compressed bytes are broken; expected the file as it was written"
                                     : "it ends too early; expected the file as it was written");
}

}  // namespace gouge
