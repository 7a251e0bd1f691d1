#include "postproc/gcode/lexing/variables.h"

#include "lib/base/number_text.h"

namespace gouge {

bool GcodeVariables::is_local(const std::string& name) {
  constexpr long long kLastLocal = 30;
  if (name.starts_with('<')) return !name.starts_with("<_");
  const auto number = parse_integer(name);
  return number && *number >= 1 && *number <= kLastLocal;
}

double GcodeVariables::value(const std::string& name) const {
  const Values& scope = is_local(name) ? locals_.back() : globals_;
  const auto found = scope.find(name);
  return found == scope.end() ? kUnknownValue : found->second;
}

}  // namespace gouge
