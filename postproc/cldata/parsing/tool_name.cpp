#include "postproc/cldata/parsing/tool_name.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/parsing/control_list.h"
#include "postproc/cldata/parsing/machine_tokens.h"

namespace gouge {
namespace {

constexpr std::string_view kOfMacros = "#=<>;";

// Kinds of tools and what is said of them, as CAM systems and catalogues write them.
constexpr std::string_view kToolWords =
    "MILL EM CRB CARBIDE HSS HSSE COBALT DRILL CENTERDRILL CENTREDRILL JOBBER SPOT SPOTDRILL REAMER REAM TAP TAPER BALL BALLNOSE "
    "BULL BULLNOSE HOG HOGNOSE FLAT ENDMILL FACEMILL SLOTMILL CHAMFER CSINK COUNTERSINK CBORE COUNTERBORE BORING BORE "
    "THREADMILL KEYSEAT KEYWAY DOVETAIL LOLLIPOP UNDERCUT ENGRAVE ENGRAVER FLUTE FLUTES ROUGHER FINISHER INSERTED "
    "FRESA FRAESER FRAISE BROCA BOHRER FORET PUNTA ESCARIADOR ALESOIR REIBAHLE GEWINDEBOHRER MACHO TARAUD";

// "10MM", "90DEG", "4FL", "3/8IN", or "D10" and "R0.5": a number and at it a unit, or what it is.
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

// Without what stands in square brackets at its beginning: [HOLDER=C40-M12EM50].
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
