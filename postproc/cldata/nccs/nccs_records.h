#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/tolerance.h"

// The container of binary NCCS (NCL, PostWorks) CL files. Physical blocks have 35 words of 8 bytes and 8 bytes of
// padding. The words contain logical records, which are independent of the blocks. A record is a header word and its
// data words. The header is four 16-bit numbers, low byte first: words in the record with its header, class, subclass,
// sequence number.

namespace gouge {

struct NccsHeader {
  std::uint16_t words = 0;  ///< number of words in the record, including this header
  std::uint16_t klass = 0;
  std::uint16_t subclass = 0;
  std::uint16_t sequence = 0;
};

struct NccsClass {
  static constexpr std::uint16_t kSourceLine = 1000, kSourceNumber = 1001, kPost = 2000, kCircle = 3000, kMotion = 5000,
                                 kExpanded = 5200, kTool = 6000, kShownTool = 7100, kHeader = 7400, kMode = 9000,
                                 kFini = 14000;
};

/// Subclasses and codes of records that several files in this folder use.
struct NccsSubclass {
  static constexpr std::uint16_t kPoints = 5, kRapid = 5, kMultaxOn = 0, kMultaxOff = 1;
};

inline constexpr std::size_t kNccsWordBytes = 8;
/// Components of two axes in records count as equal up to this difference.
inline constexpr double kSameNccsAxis = Tolerance::kExactDirection;

/// Number of data words for each point in a record of expanded motion.
inline constexpr std::size_t kNccsExpandedWords = 21;

/// Returns whether the first record is the header of a binary NCCS file. A file without that record must begin with at
/// least three consecutive records of known classes.
[[nodiscard]] bool is_nccs_binary(std::string_view bytes);

/// The words of a file, without its padding. The functions require `word` < words().
class NccsWords {
 public:
  explicit NccsWords(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t words() const;
  /// Returns the offset of the word in the file's bytes.
  [[nodiscard]] static std::size_t offset(std::size_t word);
  /// Returns the word that begins at `offset`.
  [[nodiscard]] static std::size_t word_at(std::size_t offset);
  [[nodiscard]] std::string_view bytes(std::size_t word) const;
  /// Returns `count` bytes from the beginning of the word.
  [[nodiscard]] std::string_view bytes(std::size_t word, std::size_t count) const;
  [[nodiscard]] double number(std::size_t word) const;
  [[nodiscard]] NccsHeader header(std::size_t word) const;

 private:
  std::string_view bytes_;
};

/// Returns the 8 bytes of a header and of a number, low byte first.
[[nodiscard]] std::string nccs_word(const NccsHeader& header);
[[nodiscard]] std::string nccs_word(double number);

/// Returns `words` (8 bytes each) in blocks; the last block is filled with zeros.
[[nodiscard]] std::string nccs_blocks(std::string_view words);

}  // namespace gouge
