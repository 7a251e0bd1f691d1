#include "postproc/cldata/nci/nci_lines.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kPairsLookedAt = 2000;  // hundreds of parameters may come before the first motion
constexpr std::size_t kMostFields = 100;
constexpr std::size_t kLeastNumbersOfMotion = 5;
constexpr int kLargestCode = 99999;

bool is_motion(const NciPair& pair) {
  if (!pair.code || *pair.code > 11) return false;
  std::vector<Argument> fields;
  split_nci_fields(pair.parameters, fields);
  return fields.size() >= kLeastNumbersOfMotion &&
         std::all_of(fields.begin(), fields.end(), [](const Argument& a) { return a.number.has_value(); });
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

void split_nci_fields(std::string_view parameters, std::vector<Argument>& fields) {
  fields.clear();
  while (!parameters.empty() && fields.size() < kMostFields) {
    std::size_t end = 0;
    while (end < parameters.size() && !is_blank(parameters[end])) ++end;
    fields.push_back({parameters.substr(0, end), parse_number(parameters.substr(0, end))});
    parameters = trim(parameters.substr(end));
  }
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
