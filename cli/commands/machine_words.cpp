#include "cli/commands/machine_words.h"

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {

std::string machine_row(const std::string& name, const std::string& value) {
  constexpr std::size_t kLabel = 34;
  return padded(name, kLabel) + printable(value) + "\n";
}

std::string joints_text(const Machine& machine, const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t k : joints) names.push_back(machine.joints[k].name);
  return (names.size() == 1 ? "joint " : "joints ") + listed(names, " and ");
}

}  // namespace gouge
