#include "postproc/gcode/running/block_structures.h"

#include <algorithm>

namespace gouge {
namespace {

std::string at_line(const std::string& name, std::size_t line) { return name + " in line " + std::to_string(line); }

}  // namespace

void BlockStructures::add(std::size_t line, const StructureWord& word) {
  using enum StructureWord::Kind;
  if (!fault_.empty()) return;
  if (word.kind == begin) return open_.push_back({word, line, 0});
  const std::string shown = at_line(word.name, line);
  if (!is_innermost(word.pair)) {
    const bool is_outer = std::ranges::any_of(open_, [&](const Open& one) { return one.word.pair == word.pair; });
    fault_ = shown + (is_outer ? " stands before the end of " + at_line(open_.back().word.name, open_.back().line)
                               : " has no beginning");
    return;
  }
  Open& innermost = open_.back();
  if (word.kind == end) {
    closed_.push_back({innermost.line, line});
    return open_.pop_back();
  }
  if (innermost.otherwise_line > 0)
    fault_ = shown + " follows the ELSE in line " + std::to_string(innermost.otherwise_line);
  if (word.kind == otherwise) innermost.otherwise_line = line;
}

bool BlockStructures::is_innermost(const std::string& pair) const {
  return !open_.empty() && open_.back().word.pair == pair;
}

void BlockStructures::finish() {
  if (!fault_.empty() || open_.empty()) return;
  fault_ = at_line(open_.back().word.name, open_.back().line) + " has no end";
}

bool BlockStructures::is_entered(std::size_t from_line, std::size_t to_line) const {
  return std::ranges::any_of(closed_, [&](const Closed& one) {
    const bool is_within = from_line >= one.first_line && from_line <= one.last_line;
    return !is_within && to_line > one.first_line && to_line <= one.last_line;
  });
}

}  // namespace gouge
