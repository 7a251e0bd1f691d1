#pragma once

#include <string>

#include "cli/machine/machine_choice.h"
#include "lib/base/number_text.h"

namespace gougecheck {

/// Returns a text that is equal for equal machines as stated, with their joints, zero and tool length. Empty: no machine.
[[nodiscard]] inline std::string machine_key(const gouge::StatedMachine& stated) {
  if (stated.machine.empty()) return {};
  std::string key = stated.machine + "\n" + stated.zero + "\n";
  for (const std::string& fact : gouge::stated_texts(stated.joints, {})) key += fact + "\n";
  return key + (stated.tool_length_mm ? gouge::exact_text(*stated.tool_length_mm) : "");
}

}  // namespace gougecheck
