#include "cli/terminal/length_text.h"

#include <set>
#include <vector>

#include "lib/base/units.h"
#include "lib/check/check_options.h"
#include "lib/check/reach.h"

namespace gouge {

std::vector<std::string> unit_words() {
  std::vector<std::string> words;
  for (const UnitFacts& unit : kUnits) words.emplace_back(unit.option);
  return words;
}

Diagnostic usage_error(const std::string& option, const std::string& typed, const std::string& expected) {
  return make_error("usage", option + " '" + typed + "': expected " + expected);
}

Result<double> understand_length(const std::string& option, const std::string& typed, Minimum least) {
  const std::optional<double> length_mm = parse_length_mm(typed);
  if (!length_mm || *length_mm < 0 || (least != Minimum::zero && !(*length_mm > 0))) {
    return usage_error(option, typed,
                       std::string("a length ") + (least == Minimum::zero ? "of 0 or more" : "above 0") +
                           " in mm, or with a unit (0.0005in), and at most 100 m" + decimal_comma_hint(typed));
  }
  if (least == Minimum::finest_resolution && *length_mm < kFinestResolution_mm)
    return usage_error(option, typed, "at least 0.000001 mm, what double precision can certify");
  return *length_mm;
}

Result<LengthRange> understand_length_range(const std::string& option, const std::string& typed) {
  const std::optional<LengthRange> range = parse_length_range(typed);
  if (range && range->middle_mm - range->half_mm >= 0) return *range;
  return usage_error(
      option, typed,
      "a length of 0 or more in mm, or with a unit (6in), or an interval such as 120..120.1, and at most 100 m" +
          decimal_comma_hint(typed));
}

Result<RigidTransform> understand_place(const std::string& option, const std::string& typed) {
  const std::optional<RigidTransform> place = parse_place(typed);
  if (place) return *place;
  return usage_error(option, typed,
                     "x,y,z or x,y,z,rx,ry,rz: lengths in mm, or with a unit (0.5in), of at most 100 m, then degrees");
}

std::optional<std::string> parse_clearance(const std::string& text, CheckOptions& options) {
  std::set<std::string> given;
  for (const std::string& part : split_text(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string body = part.substr(0, equals);
    if (!given.insert(body).second) return "'" + body + "' is given twice; expected one clearance for each body";
    const auto length = equals == std::string::npos ? std::nullopt : parse_length_mm(part.substr(equals + 1));
    if (!length || *length < 0) {
      const bool is_behind_comma = equals == std::string::npos && given.size() > 1 && parse_length_mm(part);
      if (is_behind_comma) return "'" + text + "' has a number behind a comma; expected a decimal point: shank=0.5";
      return "'" + part +
             "' is not BODY=LENGTH with a length from 0 to 100 m; expected for example shank=0.5,holder=1 in mm, or "
             "with units (holder=0.04in)";
    }
    if (body == "shank") {
      options.shank_clearance_mm = *length;
    } else if (body == "holder") {
      options.holder_clearance_mm = *length;
    } else {
      return "'" + body + "' has no clearance; expected shank or holder (for the cutter use --stock-to-leave)";
    }
  }
  return std::nullopt;
}

}  // namespace gouge
