#include "postproc/cldata/parsing/cutter_statement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/control_list.h"
#include "postproc/cldata/parsing/machine_tokens.h"

namespace gouge {

namespace {

// CAM systems write tool sizes with at least 4 decimals: a radius of half of 0.3125 is written as 0.1563.
constexpr double kRadiusRounding = 1e-4;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// Finds the centre of the corner circle, which touches the bottom line and the flank. The bottom line rises by alpha,
// and the flank leans out by beta; they meet at the radius d/2. The centre lies r inside both of them.
void find_corner_centre(CutterStatement& cutter) {
  const double a = radians(cutter.alpha_deg);
  const double b = radians(cutter.beta_deg);
  const double along_flank = cutter.r_mm * (1 - std::sin(a + b)) / std::cos(a + b);
  cutter.e_mm = cutter.d_mm / 2 - cutter.r_mm * std::cos(b) + along_flank * std::sin(b);
  cutter.f_mm = cutter.d_mm / 2 * std::tan(a) + cutter.r_mm * std::sin(b) + along_flank * std::cos(b);
}

bool is_zero(double x) { return !(x < 0) && !(x > 0); }

// Returns whether e and f state another centre. Two zeros are not a centre, because a corner circle about the tip would
// reach below it.
bool is_corner_elsewhere(const CutterStatement& cutter, double r_mm, double z_mm, double mm_per_unit) {
  if (is_zero(r_mm) && is_zero(z_mm)) return false;
  const double allowed = 2 * kRadiusRounding * mm_per_unit;
  return std::abs(r_mm - cutter.e_mm) > allowed || std::abs(z_mm - cutter.f_mm) > allowed;
}

std::string check_numbers(std::span<const Argument> arguments) {
  const Argument* word = find_word_argument(arguments);
  if (word == nullptr) return {};
  return quoted_text(word->text) + " is not a finite number";
}

// Checks the sizes of all forms, in file units. Returns the error, or an empty text.
std::string check_sizes(double d, double r, double h, double alpha_deg, double beta_deg) {
  if (d < 0) return "diameter " + exact_text(d) + " is negative";
  if (r < 0) return "corner radius " + exact_text(r) + " is negative";
  if (h < 0) return "length " + exact_text(h) + " is negative";
  if (alpha_deg < 0 || alpha_deg >= 90) return "tip angle " + exact_text(alpha_deg) + " is not within 0 to 90 degrees";
  if (std::abs(beta_deg) >= 90) return "flank angle " + exact_text(beta_deg) + " is not within -90 to 90 degrees";
  return {};
}

std::string check_radius(double d, double r) {
  if (r <= d / 2 + kRadiusRounding) return {};
  return "corner radius " + exact_text(r) + " is larger than half the diameter " + exact_text(d);
}

// Returns whether a corner circle about `e` would reach farther out than the diameter of the cutter. It is no
// contradiction if e may be the diameter of the tip.
bool reaches_beyond(double d, double r, double e, bool has_tip_diameter) {
  const bool is_tip_diameter = has_tip_diameter && std::abs(e - (d - 2 * r)) <= 2 * kRadiusRounding;
  return !is_tip_diameter && e + r > d / 2 + 2 * kRadiusRounding;
}

CutterOutcome contradictory(double d, double r, double e) {
  return {std::nullopt,
          0,
          {},
          "CUTTER whose third number " + exact_text(e) + " has the corner circle reach beyond half the diameter " +
              exact_text(d) + " (corner radius " + exact_text(r) +
              ") contradicts itself: define the tool in the tool library",
          false};
}

CutterOutcome wrong(std::string error) { return {std::nullopt, 0, std::move(error), {}, false}; }

}  // namespace

CutterOutcome make_cutter(std::span<const Argument> arguments, double mm_per_unit, bool has_tip_diameter) {
  if (std::string error = check_numbers(arguments); !error.empty()) return wrong(std::move(error));
  const std::size_t count = arguments.size();
  if (count != 1 && count != 2 && count != 7) return wrong("found " + std::to_string(count) + " numbers");
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < count; ++i) v[i] = *arguments[i].number;
  if (std::string error = check_sizes(v[0], v[1], v[6], v[4], v[5]); !error.empty()) return wrong(std::move(error));
  const bool is_plain = is_zero(v[4]) && is_zero(v[5]);
  if (is_zero(v[0]) && is_plain) return {std::nullopt, 0, {}, "CUTTER with diameter 0 defines no tool", false};

  CutterStatement cutter;
  cutter.d_mm = v[0] * mm_per_unit;
  cutter.r_mm = v[1] * mm_per_unit;
  cutter.e_mm = v[2] * mm_per_unit;
  cutter.f_mm = v[3] * mm_per_unit;
  cutter.alpha_deg = v[4];
  cutter.beta_deg = v[5];
  cutter.h_mm = v[6] * mm_per_unit;
  cutter.given = static_cast<int>(count);
  if (is_plain) {
    if (std::string error = check_radius(v[0], v[1]); !error.empty()) return wrong(std::move(error));
    if (count == 7 && reaches_beyond(v[0], v[1], v[2], has_tip_diameter)) return contradictory(v[0], v[1], v[2]);
    cutter.r_mm = std::min(cutter.r_mm, cutter.d_mm / 2);
    cutter.e_mm = cutter.d_mm / 2 - cutter.r_mm;
    cutter.f_mm = cutter.r_mm;
  } else if (has_tip_diameter) {
    if (v[4] + v[5] >= 90) return wrong("tip angle and flank angle together reach 90 degrees");
    find_corner_centre(cutter);
  }
  const double change_mm =
      std::max(std::abs(cutter.e_mm - v[2] * mm_per_unit), std::abs(cutter.f_mm - v[3] * mm_per_unit));
  return {cutter, 0, {}, {}, count == 7 && change_mm > 2 * kRadiusRounding * mm_per_unit};
}

CutterOutcome make_tldata_cutter(std::span<const Argument> arguments, bool is_drill, double mm_per_unit) {
  if (std::string error = check_numbers(arguments); !error.empty()) return wrong(std::move(error));
  const std::size_t count = arguments.size();
  if (is_drill ? count != 5 : count != 5 && count != 7 && count != 10) {
    return wrong("found " + std::to_string(count) + " numbers");
  }
  std::array<double, 10> v{};
  for (std::size_t i = 0; i < count; ++i) v[i] = *arguments[i].number;
  if (is_drill && (v[3] <= 0 || v[3] > 180)) {
    return wrong("point angle " + exact_text(v[3]) + " is not within 0 to 180 degrees");
  }
  const double taper = is_drill ? 0 : v[3];
  const double tip = is_drill ? (180 - v[3]) / 2 : v[4];
  if (std::string error = check_sizes(v[0], v[1], v[2], tip, taper); !error.empty()) return wrong(std::move(error));
  if (tip + taper >= 90) return wrong("tip angle and taper angle together reach 90 degrees");
  if (is_zero(v[0])) return {std::nullopt, 0, {}, "TLDATA with diameter 0 defines no tool", false};
  if (count == 10 && !is_zero(v[7])) {
    return {std::nullopt,
            0,
            {},
            "TLDATA with an upper corner radius is not understood: define the tool in the tool library",
            false};
  }
  if (is_zero(tip) && is_zero(taper)) {
    if (std::string error = check_radius(v[0], v[1]); !error.empty()) return wrong(std::move(error));
  }

  CutterStatement cutter;
  cutter.d_mm = v[0] * mm_per_unit;
  cutter.r_mm = std::min(v[1] * mm_per_unit, cutter.d_mm / 2);
  cutter.alpha_deg = tip;
  cutter.beta_deg = taper;
  cutter.h_mm = v[2] * mm_per_unit;
  cutter.given = 7;
  find_corner_centre(cutter);
  if (count > 5 && is_corner_elsewhere(cutter, v[5] * mm_per_unit, v[6] * mm_per_unit, mm_per_unit)) {
    return {std::nullopt,
            0,
            {},
            "TLDATA whose corner circle lies at " + exact_text(v[5]) + "," + exact_text(v[6]) +
                ", not where its other numbers have it, is not understood: define the tool in the tool library",
            false};
  }
  return {cutter, is_drill ? v[4] * mm_per_unit : 0, {}, {}, false};
}

namespace {

constexpr std::string_view kOfMacros = "#=<>;";

// Kinds of tools and their properties, in the words of CAM systems and catalogues.
constexpr std::string_view kToolWords =
    "MILL EM CRB CARBIDE HSS HSSE COBALT DRILL CENTERDRILL CENTREDRILL JOBBER SPOT SPOTDRILL REAMER REAM TAP TAPER BALL BALLNOSE "
    "BULL BULLNOSE HOG HOGNOSE FLAT ENDMILL FACEMILL SLOTMILL CHAMFER CSINK COUNTERSINK CBORE COUNTERBORE BORING BORE "
    "THREADMILL KEYSEAT KEYWAY DOVETAIL LOLLIPOP UNDERCUT ENGRAVE ENGRAVER FLUTE FLUTES ROUGHER FINISHER INSERTED "
    "FRESA FRAESER FRAISE BROCA BOHRER FORET PUNTA ESCARIADOR ALESOIR REIBAHLE GEWINDEBOHRER MACHO TARAUD";

// Returns whether a text is a number with a unit or a kind: "10MM", "90DEG", "4FL", "3/8IN", "D10", "R0.5".
bool is_dimension(std::string_view token) {
  constexpr std::string_view kBefore = "DRdr";
  if (kBefore.find(token[0]) != std::string_view::npos && parse_number(token.substr(1))) return true;
  constexpr std::string_view kUnitsOfNames = "MM DEG FL IN INCH CM RAD DIA LOC";
  const auto digits = static_cast<std::size_t>(
      std::ranges::find_if_not(token, [](char c) { return is_digit(c) || c == '.' || c == '/' || c == ','; }) -
      token.begin());
  return digits > 0 && is_among_words(token.substr(digits), kUnitsOfNames);
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  while (!(text = trim(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return words;
}

// Returns the text without a part in square brackets at its beginning: [HOLDER=C40-M12EM50].
std::string_view without_holder(std::string_view text) {
  text = trim(text);
  if (!text.starts_with('[')) return text;
  const std::size_t close = text.find(']');
  return close == std::string_view::npos ? text : trim(text.substr(close + 1));
}

}  // namespace

bool is_tool_name(std::string_view text) {
  const std::string_view name = without_holder(text);
  if (name.find_first_of(kOfMacros) != std::string_view::npos || name.find('[') != std::string_view::npos) return false;
  return std::ranges::any_of(
      split(name), [](std::string_view word) { return is_dimension(word) || is_among_words(word, kToolWords); });
}

bool is_setup_text(std::string_view text) {
  const std::vector<std::string_view> words = split(text);
  if (words.size() < 2 || text.find_first_of(kOfMacros) != std::string_view::npos) return false;
  if (equals_ignoring_case(words[0], "STOCK") && equals_ignoring_case(words[1], "SIZE")) {
    return std::ranges::all_of(words.begin() + 2, words.end(), [](std::string_view word) {
      return std::string_view("XYZxyz").find(word[0]) != std::string_view::npos && parse_number(word.substr(1));
    });
  }
  if (!equals_ignoring_case(words[0], "STOP")) return false;
  return std::all_of(words.begin() + 1, words.end(), [](std::string_view word) {
    return std::ranges::all_of(word, [](char c) { return !is_digit(c); });
  });
}

}  // namespace gouge
