#include "tests/laws/expander_cycles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

#include "tests/laws/expander_words.h"

namespace gouge::laws {
namespace {

constexpr std::array<std::string_view, 8> kPlainKinds{"DRILL", "DEEP", "DEEP2", "BRKCHP",
                                                      "FACE",  "BORE", "REAM",  "PECKING"};
constexpr std::array<std::string_view, 4> kFeedUnits{"MMPM", "IPM", "MMPR", "IPR"};

template <typename Words>
bool holds(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Words with the numbers behind each; a word twice is a contradiction.
using Values = std::map<std::string, std::vector<double>, std::less<>>;

std::optional<Values> values_by_word(const std::vector<LooseArgument>& arguments, std::string& uncertainty) {
  Values values;
  std::string word;
  for (const LooseArgument& argument : arguments) {
    if (argument.number) {
      values[word].push_back(*argument.number);
      continue;
    }
    word = argument.text;
    if (!word.empty() && word.find_first_not_of("+-.0123456789") == std::string::npos) {
      uncertainty = "'" + word + "' in a cycle is no number";
      return std::nullopt;
    }
    if (word.empty() || !values.try_emplace(word).second) {
      uncertainty = "the cycle has an empty argument, or '" + word + "' twice";
      return std::nullopt;
    }
  }
  return values;
}

std::optional<double> one(const Values& values, std::string_view word) {
  const auto found = values.find(word);
  if (found == values.end() || found->second.size() != 1) return std::nullopt;
  return found->second.front();
}

std::optional<StatedCycle> of_clt(const Values& values, std::string& uncertainty) {
  const bool is_g98 = values.contains("G98");
  const std::optional<double> depth = one(values, is_g98 ? "G98" : "G99");
  for (const std::string_view unit : kFeedUnits) {
    const auto feed = values.find(unit);
    if (feed == values.end() || feed->second.size() < 3 || !depth || *depth <= 0) continue;
    for (const auto& [word, numbers] : values) {
      if (word == "OFF" || word == "ON") uncertainty = "'" + word + "' in a cycle";
    }
    if (values.contains("G98") && values.contains("G99")) uncertainty = "G98 and G99";
    if (!uncertainty.empty()) return std::nullopt;
    return StatedCycle{-*depth, feed->second[1], is_g98 ? feed->second[2] : feed->second[1]};
  }
  uncertainty = "a cycle without its numbers";
  return std::nullopt;
}

// CAMWorks writes `CYCLE/ ON CYCLE/ DRILL,..` on one line too (docs/formats/cycles.md).
std::vector<LooseArgument> without_leading_on(const std::vector<LooseArgument>& arguments) {
  const bool is_joined = arguments.size() > 2 && arguments[0].text == "ON" && arguments[1].text == "CYCLE/";
  return {arguments.begin() + (is_joined ? 2 : 0), arguments.end()};
}

struct CycleWords {
  std::vector<std::string_view> depth, clearance, retract;
};

CycleWords words_of(std::string_view dialect) {
  if (dialect == "apt-creo" || dialect == "apt-mori" || dialect == "apt-catia")
    return {{"DEPTH"}, {"CLEAR"}, {"RETURN"}};
  if (dialect == "apt") return {{"FEDTO", "DEPTH"}, {"RAPTO", "CLEAR"}, {"RTRCTO", "RETURN"}};
  return {{"FEDTO"}, {"RAPTO"}, {"RTRCTO"}};
}

// One letter away from a height of this dialect, a depth in another one's words, or the word that ends
// cycles.
bool may_be_height(const CycleWords& words, std::string_view word) {
  if (word == "OFF" || word == "FEDTO" || word == "DEPTH") return true;
  for (const auto* list : {&words.depth, &words.clearance, &words.retract}) {
    for (const std::string_view height : *list) {
      if (is_one_letter_away(word, height)) return true;
    }
  }
  return false;
}

}  // namespace

std::optional<StatedCycle> stated_cycle(const std::vector<LooseArgument>& arguments, std::string_view dialect,
                                        std::string& uncertainty) {
  const bool is_clt = dialect == "camworks-clt";
  const std::optional<Values> values = values_by_word(is_clt ? without_leading_on(arguments) : arguments, uncertainty);
  if (!values) return std::nullopt;
  if (is_clt) return of_clt(*values, uncertainty);
  if (dialect == "apt-catia" && values->size() == 1 && values->contains("DRILL") && values->at("DRILL").size() == 2 &&
      values->at("DRILL")[0] > 0)
    return StatedCycle{-values->at("DRILL")[0], values->at("DRILL")[1], values->at("DRILL")[1]};
  const CycleWords words = words_of(dialect);
  std::optional<double> depth, clearance, retract;
  bool has_kind = false;
  for (const auto& [word, numbers] : *values) {
    std::optional<double>* place = holds(words.depth, word)       ? &depth
                                   : holds(words.clearance, word) ? &clearance
                                   : holds(words.retract, word)   ? &retract
                                                                  : nullptr;
    if (holds(kPlainKinds, word) && numbers.empty())
      has_kind = true;
    else if (place != nullptr && numbers.size() == 1 && !*place)
      *place = numbers.front();
    else if (place != nullptr || may_be_height(words, word))
      uncertainty = "'" + word + "' in a cycle";
  }
  if (!has_kind || !depth) uncertainty = "a cycle without its kind or its depth";
  if (!clearance && dialect != "apt-camplete") uncertainty = "a cycle without its clearance";
  if (dialect != "nx-clsf" && depth && *depth < 0) uncertainty = "a cycle of negative depth";
  if (!uncertainty.empty()) return std::nullopt;
  const double bottom = dialect == "nx-clsf" ? *depth : -*depth;
  return StatedCycle{bottom, clearance.value_or(0), retract.value_or(clearance.value_or(0))};
}

}  // namespace gouge::laws
