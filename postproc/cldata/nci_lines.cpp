#include "postproc/cldata/nci_lines.h"

#include "lib/base/number_text.h"
#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr std::size_t kPairsLookedAt = 60;
constexpr std::size_t kLeastNumbersOfMotion = 5;
constexpr int kLargestCode = 99999;

bool is_motion(const NciPair& pair) {
  if (!pair.code || *pair.code > 11) return false;
  std::size_t numbers = 0;
  for (std::string_view rest = pair.parameters; !rest.empty();) {
    const std::string_view token = rest.substr(0, rest.find_first_of(" \t"));
    if (!parse_number(token)) return false;
    ++numbers;
    rest = trim(rest.substr(token.size()));
  }
  return numbers >= kLeastNumbersOfMotion;
}

}  // namespace

bool NciLines::take_line(std::string_view& text) {
  if (at_ >= bytes_.size()) return false;
  const std::size_t end = bytes_.find('\n', at_);
  text = trim(bytes_.substr(at_, end - at_));
  at_ = end == std::string_view::npos ? bytes_.size() : end + 1;
  ++line_;
  return true;
}

bool NciLines::next(NciPair& pair) {
  std::string_view text;
  do {
    pair.first_byte = at_;
    pair.line = line_;
    if (!take_line(text)) return false;
  } while (text.empty());
  pair.code_text = text;
  pair.code.reset();
  const auto code = parse_integer(text);
  if (code && *code >= 0 && *code <= kLargestCode) pair.code = static_cast<int>(*code);
  pair.is_whole = take_line(pair.parameters);
  pair.last_byte = at_;
  return true;
}

bool is_nci(std::string_view bytes) {
  NciLines lines(bytes, 0, 1);
  NciPair pair;
  bool has_motion = false;
  for (std::size_t i = 0; i < kPairsLookedAt && lines.next(pair); ++i) {
    if (!pair.code || !pair.is_whole) return false;
    has_motion = has_motion || is_motion(pair);
  }
  return has_motion;
}

}  // namespace gouge
