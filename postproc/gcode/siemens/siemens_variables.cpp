#include "postproc/gcode/siemens/siemens_variables.h"

#include <algorithm>
#include <cmath>

#include "lib/base/letters.h"
#include "postproc/gcode/language/gcode_block.h"

namespace gouge {

bool is_r_parameter(std::string_view name) {
  return name.size() > 1 && name[0] == 'R' && std::ranges::all_of(name.substr(1), is_digit);
}

std::string SiemensVariables::one_spelling(const std::string& name) {
  if (!is_r_parameter(name)) return name;
  return "R" + name.substr(std::min(name.find_first_not_of('0', 1), name.size() - 1));
}

double SiemensVariables::held(SiemensType type, double value) {
  const bool is_whole = std::abs(value - std::round(value)) <= 0;
  if (type == SiemensType::integer && !is_whole) return kUnknownValue;
  if (type == SiemensType::boolean && !(is_whole && (value <= 0 || value >= 1) && value >= 0 && value <= 1))
    return kUnknownValue;
  return value;
}

bool SiemensVariables::has(std::string_view name) const {
  return is_r_parameter(name) || locals_.back().find(name) != locals_.back().end();
}

double SiemensVariables::value(const std::string& name) const {
  if (const auto local = locals_.back().find(name); local != locals_.back().end()) return local->second.value;
  const auto parameter = parameters_.find(one_spelling(name));
  return parameter == parameters_.end() ? kUnknownValue : parameter->second;
}

void SiemensVariables::set(const std::string& name, double value) {
  if (const auto local = locals_.back().find(name); local != locals_.back().end())
    local->second.value = held(local->second.type, value);
  else
    parameters_[one_spelling(name)] = value;
}

bool SiemensVariables::declare(const std::string& name, SiemensType type, double value) {
  if (is_r_parameter(name)) return false;
  return locals_.back().insert({name, {type, held(type, value)}}).second;
}

}  // namespace gouge
