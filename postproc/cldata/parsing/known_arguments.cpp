#include "postproc/cldata/parsing/known_arguments.h"

#include <algorithm>
#include <array>

#include "postproc/cldata/language/unit_words.h"
#include "postproc/cldata/parsing/control_list.h"

namespace gouge {
namespace {

struct KnownArguments {
  Word word;
  std::string_view minors;  ///< separated by blanks
  std::size_t most_numbers;
};

// Of words whose reader looks for some arguments and passes over the others. The documents are those of
// docs/formats/harmless_words.md.
constexpr auto kRows = std::to_array<KnownArguments>({
    {Word::cutcom,
     "ON OFF LEFT RIGHT LENGTH ADJUST XYPLAN YZPLAN ZXPLAN XAXIS YAXIS ZAXIS NORMDS NORMAL PLUS MINUS 3DC", 6},
    {Word::end_of_path, "", 0},
    {Word::fedrat,
     "MMPM MMPR IPM IPR FPM FPR PERMIN PERREV INVERS TPI AUTO ON OFF CONST LOCK UNLOCK MAXIPM MAXMPM SCALE MPM UPM UPR "
     "NEXT NOW RPM SFM SMM",
     3},
    {Word::load, "TOOL ADJUST LENGTH MANUAL AUTO HOLDER OSETNO NEXTTL", 5},
    {Word::loadtl,
     "TOOL LENGTH ADJUST OSETNO MANUAL AUTO IN NEXT NOW CLW CCLW SMALL MEDIUM LARGE LOW HIGH MILL DRILL TURN NEXTTL",
     6},
    {Word::opskip, "ON OFF ALL", 1},
    {Word::select, "TOOL NEXT HEAD", 2},
    {Word::toolno,
     "MILL DRILL TURN LENGTH OSETNO MANUAL ADJUST AUTO MMPM MMPR IPM IPR RPM SFM SMM CLW CCLW ON OFF NOTE", 12},
});

}  // namespace

bool are_known_arguments(Word word, std::span<const Argument> arguments) {
  if (word == Word::units)
    return std::ranges::all_of(arguments, [](const Argument& a) { return unit_of_word(a.text).has_value(); });
  const auto* const row = std::ranges::find(kRows, word, &KnownArguments::word);
  if (row == kRows.end()) return true;
  // Whatever else is selected shifts what follows: its reader doubts that.
  if (word == Word::select && !has_argument(arguments.first(std::min(arguments.size(), std::size_t{1})), "TOOL"))
    return true;
  // Its positions are not checked whatever else is said of a turning tool.
  if (word == Word::toolno && has_argument(arguments, "TURN")) return true;
  std::size_t numbers = 0;
  bool is_quoted = false;
  for (const Argument& argument : arguments) {
    const bool begins_quoted = argument.text.starts_with('\'');
    if (argument.number && !is_quoted) {
      if (++numbers > row->most_numbers) return false;
    } else if (!is_quoted && !begins_quoted && !argument.text.empty() && !is_among_words(argument.text, row->minors)) {
      return false;
    }
    is_quoted = is_quoted || begins_quoted;
    if (is_quoted && argument.text.ends_with('\'') && (!begins_quoted || argument.text.size() > 1)) is_quoted = false;
  }
  return !is_quoted;
}

}  // namespace gouge
