#include "postproc/cldata/nccs/nccs_records.h"

#include <algorithm>
#include <array>
#include <bit>

namespace gouge {
namespace {

constexpr std::size_t kWordsOfBlock = 35;
constexpr std::size_t kBlock = 288;
constexpr std::size_t kMinBytes = 8;

unsigned byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

std::uint16_t number16(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint16_t>(byte_at(bytes, at) | (byte_at(bytes, at + 1) << 8U));
}

void append16(std::string& text, std::uint16_t value) {
  text += static_cast<char>(value & 0xffU);
  text += static_cast<char>(value >> 8U);
}

bool is_known_class(std::uint16_t klass) {
  static constexpr std::array<std::uint16_t, 11> kKnown = {
      NccsClass::kSourceLine, NccsClass::kSourceNumber, NccsClass::kPost, NccsClass::kCircle,
      NccsClass::kMotion,     NccsClass::kExpanded,     NccsClass::kTool, NccsClass::kShownTool,
      NccsClass::kHeader,     NccsClass::kMode,         NccsClass::kFini};
  return std::find(kKnown.begin(), kKnown.end(), klass) != kKnown.end();
}

// Tests a file without the header record. Its first records must be of known classes, each with the length that it
// states. They must reach the end of the file, or be more than could occur by chance in another file.
bool is_chain_of_records(std::string_view bytes) {
  constexpr std::size_t kFewest = 3, kEnough = 16;
  const NccsWords words(bytes);
  std::size_t records = 0;
  for (std::size_t word = 0; word < words.words() && records < kEnough; ++records) {
    const NccsHeader header = words.header(word);
    if (header.words == 0 || header.words > words.words() - word || !is_known_class(header.klass)) return false;
    if (header.klass == NccsClass::kFini) return records + 1 >= kFewest;
    word += header.words;
  }
  return records >= kFewest;
}

}  // namespace

bool is_nccs_binary(std::string_view bytes) {
  if (bytes.size() < kMinBytes) return false;
  const NccsHeader header = NccsWords(bytes).header(0);
  return header.klass == NccsClass::kHeader ? header.words > 0 : is_chain_of_records(bytes);
}

std::size_t NccsWords::words() const {
  const std::size_t rest = std::min(bytes_.size() % kBlock / kNccsWordBytes, kWordsOfBlock);
  return bytes_.size() / kBlock * kWordsOfBlock + rest;
}

std::size_t NccsWords::offset(std::size_t word) {
  return word / kWordsOfBlock * kBlock + word % kWordsOfBlock * kNccsWordBytes;
}

std::size_t NccsWords::word_at(std::size_t offset) {
  return offset / kBlock * kWordsOfBlock + offset % kBlock / kNccsWordBytes;
}

std::string_view NccsWords::bytes(std::size_t word) const { return bytes(word, kNccsWordBytes); }

std::string_view NccsWords::bytes(std::size_t word, std::size_t count) const {
  return bytes_.substr(offset(word), count);
}

double NccsWords::number(std::size_t word) const {
  const std::string_view text = bytes(word);
  std::uint64_t bits = 0;
  for (std::size_t i = kNccsWordBytes; i-- > 0;) bits = (bits << 8U) | byte_at(text, i);
  return std::bit_cast<double>(bits);
}

NccsHeader NccsWords::header(std::size_t word) const {
  const std::string_view text = bytes(word);
  return {number16(text, 0), number16(text, 2), number16(text, 4), number16(text, 6)};
}

std::string nccs_word(const NccsHeader& header) {
  std::string text;
  for (const std::uint16_t value : {header.words, header.klass, header.subclass, header.sequence})
    append16(text, value);
  return text;
}

std::string nccs_word(double number) {
  std::string text;
  auto bits = std::bit_cast<std::uint64_t>(number);
  for (std::size_t i = 0; i < kNccsWordBytes; ++i, bits >>= 8U) text += static_cast<char>(bits & 0xffU);
  return text;
}

std::string nccs_blocks(std::string_view words) {
  std::string text;
  constexpr std::size_t kData = kWordsOfBlock * kNccsWordBytes;
  for (std::size_t at = 0; at < words.size(); at += kData) {
    text += words.substr(at, kData);
    text.resize((text.size() + kBlock - 1) / kBlock * kBlock, '\0');
  }
  return text;
}

}  // namespace gouge
