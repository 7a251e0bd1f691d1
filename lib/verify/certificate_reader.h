#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/result.h"
#include "lib/verify/certificate_text.h"
#include "lib/verify/zstd_stream.h"

namespace gouge {

/// Reads the bytes of a certificate, one block after the other.
class CertificateReader {
 public:
  /// `name` is that of the file; `bytes` follow the magic. Both must outlive it.
  CertificateReader(const std::string& name, std::string_view bytes, std::size_t moves)
      : name_(name), stream_(bytes), moves_(moves) {}

  /// Errors: certificate-invalid. The message states what differs from the expected header.
  [[nodiscard]] Outcome read_header(const CertificateHeader& expected);
  /// Returns the groups of the next block; no groups at the end of a section. Errors: certificate-invalid.
  [[nodiscard]] Result<std::vector<ProofGroup>> next();
  /// Begins with the first move again, for the next section.
  void begin_section() { min_move_ = 0; }
  /// Errors: certificate-invalid, if more bytes follow.
  [[nodiscard]] Outcome finish();

 private:
  [[nodiscard]] Diagnostic invalid(const std::string& what) const;
  [[nodiscard]] Diagnostic cut_short() const;

  const std::string& name_;
  ZstdReader stream_;
  std::size_t moves_, min_move_ = 0;
};

}  // namespace gouge
