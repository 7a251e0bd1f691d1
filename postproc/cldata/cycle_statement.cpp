#include "postproc/cldata/cycle_statement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr double kFarthest_mm = 1e6;

using Arguments = std::span<const Argument>;

bool is_one_of(std::string_view text, std::span<const std::string_view> words) {
  return std::any_of(words.begin(), words.end(),
                     [text](std::string_view word) { return equals_ignoring_case(text, word); });
}

// Cycles whose tool goes straight down and straight up again.
constexpr std::array<std::string_view, 14> kStraight = {"DRILL", "DEEP",  "DEEP2", "BRKCHP", "CHIPBRK",
                                                        "TAP",   "RTAP",  "LTAP",  "RIGID",  "REAM",
                                                        "BORE",  "CSINK", "FACE",  "CBORE"};
// Words that move the tool sideways, or turn the sense of the heights round.
constexpr std::array<std::string_view, 6> kSideways = {"ORIENT", "NODRAG", "BACK",
                                                       "SHIFT",  "MANUAL", "DIAMETR"};

std::optional<double> after(Arguments arguments, std::string_view word) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (equals_ignoring_case(arguments[i].text, word)) return arguments[i + 1].number;
  }
  return std::nullopt;
}

std::optional<double> after_either(Arguments arguments, std::string_view first, std::string_view second) {
  const std::optional<double> value = after(arguments, first);
  return value ? value : after(arguments, second);
}

DrillCycle make(double clearance, double bottom, std::optional<double> retract) {
  DrillCycle cycle;
  cycle.clearance_mm = clearance;
  cycle.bottom_mm = bottom;
  cycle.is_retract_stated = retract.has_value();
  cycle.retract_mm = std::max(clearance, retract.value_or(clearance));
  return cycle;
}

// FEDTO is a height (negative below the position), RAPTO and RTRCTO are heights above it.
std::optional<DrillCycle> read_nx(Arguments arguments) {
  const std::optional<double> bottom = after(arguments, "FEDTO"), clearance = after(arguments, "RAPTO");
  if (!bottom || !clearance) return std::nullopt;
  return make(*clearance, *bottom, after(arguments, "RTRCTO"));
}

// FEDTO is a depth below the position; CAMplete leaves a RAPTO of 0 out, and its CLEAR is no height above it.
std::optional<DrillCycle> read_depth_words(Arguments arguments, bool is_clearance_optional) {
  const std::optional<double> depth = after(arguments, "FEDTO");
  std::optional<double> clearance = after(arguments, "RAPTO");
  if (!clearance && is_clearance_optional) clearance = 0;
  if (!depth || *depth < 0 || !clearance) return std::nullopt;
  return make(*clearance, -*depth, after(arguments, "RTRCTO"));
}

// DEPTH below the position, CLEAR and RETURN above it.
std::optional<DrillCycle> read_creo(Arguments arguments) {
  const std::optional<double> depth = after(arguments, "DEPTH"), clearance = after(arguments, "CLEAR");
  if (!depth || *depth < 0 || !clearance) return std::nullopt;
  return make(*clearance, -*depth, after(arguments, "RETURN"));
}

// The default post table writes depth and clearance as the first two numbers; others write Creo's words.
std::optional<DrillCycle> read_catia(Arguments arguments) {
  if (has_argument(arguments, "DEPTH")) return read_creo(arguments);
  if (arguments.size() < 3 || !arguments[1].number || !arguments[2].number || *arguments[1].number < 0) {
    return std::nullopt;
  }
  return make(*arguments[2].number, -*arguments[1].number, std::nullopt);
}

// DRILL,G98,depth,...,MMPM,feed,clearance,retract: with G99 the tool stays at the clearance.
std::optional<DrillCycle> read_clt(Arguments arguments) {
  const bool is_g98 = has_argument(arguments, "G98");
  const std::optional<double> depth = after_either(arguments, "G98", "G99");
  for (std::size_t i = 0; i + 3 < arguments.size(); ++i) {
    if (!is_one_of(arguments[i].text, std::array<std::string_view, 4>{"MMPM", "IPM", "MMPR", "IPR"})) continue;
    if (!depth || *depth < 0 || !arguments[i + 2].number || !arguments[i + 3].number) return std::nullopt;
    const double clearance = *arguments[i + 2].number;
    return make(clearance, -*depth, is_g98 ? *arguments[i + 3].number : clearance);
  }
  return std::nullopt;
}

// A file of no known dialect: the words alone. Both senses of FEDTO mean a place below the position.
std::optional<DrillCycle> read_generic(Arguments arguments) {
  const std::optional<double> depth = after_either(arguments, "FEDTO", "DEPTH");
  const std::optional<double> clearance = after_either(arguments, "RAPTO", "CLEAR");
  if (!depth || !clearance) return std::nullopt;
  return make(*clearance, -std::abs(*depth), after_either(arguments, "RTRCTO", "RETURN"));
}

std::optional<DrillCycle> read_heights(DialectKind dialect, Arguments arguments) {
  switch (dialect) {
    case DialectKind::nx_clsf:
      return read_nx(arguments);
    case DialectKind::solidworks_cam:
    case DialectKind::camplete:
      return read_depth_words(arguments, dialect == DialectKind::camplete);
    case DialectKind::creo:
    case DialectKind::mori:
      return read_creo(arguments);
    case DialectKind::catia:
      return read_catia(arguments);
    case DialectKind::clt:
      return read_clt(arguments);
    case DialectKind::autodesk:
    case DialectKind::nci:
      return std::nullopt;
    default:
      return read_generic(arguments);
  }
}

}  // namespace

std::optional<DrillCycle> read_cycle(DialectKind dialect, std::span<const Argument> arguments, double mm_per_unit) {
  if (arguments.empty() || !is_one_of(arguments.front().text, kStraight)) return std::nullopt;
  for (const Argument& argument : arguments) {
    if (is_one_of(argument.text, kSideways)) return std::nullopt;
  }
  std::optional<DrillCycle> cycle = read_heights(dialect, arguments);
  if (!cycle) return std::nullopt;
  for (double* height : {&cycle->clearance_mm, &cycle->bottom_mm, &cycle->retract_mm}) {
    *height *= mm_per_unit;
    if (!(std::abs(*height) <= kFarthest_mm)) return std::nullopt;
  }
  if (cycle->bottom_mm > cycle->clearance_mm) return std::nullopt;
  return cycle;
}

}  // namespace gouge
