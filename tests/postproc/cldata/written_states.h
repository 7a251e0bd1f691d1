#pragma once

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "lib/base/units.h"
#include "lib/path/toolpath.h"

// Effect of a written toolpath on a machine, found without the readers of the project: for each motion whether
// it is rapid, its feed and its tool.

namespace gouge {

struct MotionState {
  Feed feed;
  int tool = 0;  // 0: none

  [[nodiscard]] bool is_same(const MotionState& other) const {
    return feed.unit == other.feed.unit && tool == other.tool &&
           std::abs(feed.mm - other.feed.mm) <= 1e-4 * std::abs(other.feed.mm);
  }
  [[nodiscard]] std::string text() const {
    static constexpr const char* kFeedUnits[] = {"not stated", "rapid", "mm/min", "mm/rev", "not understood"};
    std::ostringstream text;
    text << "T" << tool << " " << kFeedUnits[static_cast<std::size_t>(feed.unit)] << " " << feed.mm;
    return text.str();
  }
};

/// States one after another, equal ones once: arcs may be written as one motion or as many.
using MotionStates = std::vector<MotionState>;

inline void add_state(MotionStates& states, const MotionState& state) {
  if (states.empty() || !states.back().is_same(state)) states.push_back(state);
}

inline MotionStates states_of(const Toolpath& path) {
  MotionStates states;
  for (const Move& move : path.moves) {
    MotionState state{move.feed(), 0};
    if (move.tool != kNone) state.tool = path.tools[move.tool].number.value_or(0);
    add_state(states, state);
  }
  return states;
}

inline std::vector<std::string> words_of(std::string line) {
  for (char& c : line) c = c == ',' || c == '/' || c == '(' || c == ')' ? ' ' : static_cast<char>(std::toupper(c));
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// For APT text: RAPID holds for one motion, FEDRAT until the next one, and to the end of its block in NX.
inline MotionStates scan_states(const std::string& text, LengthUnit unit) {
  MotionStates states;
  Feed feed;
  bool is_rapid = false;
  int tool = 0;
  std::istringstream lines(text);
  std::string statement;
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    const bool is_comment = line.starts_with("$$");
    const bool is_continued = !is_comment && !line.empty() && line.back() == '$';
    if (is_continued) line.pop_back();
    statement += is_comment ? "" : line + " ";
    if (is_continued || is_comment) continue;
    const std::vector<std::string> words = words_of(statement);
    statement.clear();
    if (words.empty()) continue;
    const std::string& major = words.front();
    if (major == "RAPID") is_rapid = true;
    if (major == "TOOL" && words.size() > 1 && words[1] == "PATH") feed = {}, tool = 0, is_rapid = false;
    if (major == "LOADTL") tool = std::atoi(words.at(1).c_str());
    if (major == "LOAD" && words.at(1) == "TOOL") tool = std::atoi(words.at(2).c_str());
    if (major == "FEDRAT") {
      is_rapid = false;
      feed = {0, FeedUnit::per_minute};
      double factor = mm_per(unit);
      for (std::size_t i = 1; i < words.size(); ++i) {
        if (words[i] == "MMPM" || words[i] == "MMPR") factor = 1;
        if (words[i] == "IPM" || words[i] == "IPR") factor = 25.4;
        if (words[i] == "MMPR" || words[i] == "IPR" || words[i] == "PERREV") feed.unit = FeedUnit::per_revolution;
        if (std::isdigit(static_cast<unsigned char>(words[i][0])) != 0 || words[i][0] == '.')
          feed.mm = std::atof(words[i].c_str());
      }
      feed.mm *= factor;
    }
    if (major != "GOTO" && major != "TLON") continue;
    add_state(states, {is_rapid ? Feed{0, FeedUnit::rapid} : feed, tool});
    is_rapid = false;
  }
  return states;
}

inline std::string text_of(const MotionStates& states) {
  std::string text;
  for (const MotionState& state : states) text += state.text() + "\n";
  return text;
}

inline bool are_same(const MotionStates& a, const MotionStates& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!a[i].is_same(b[i])) return false;
  }
  return true;
}

}  // namespace gouge
