#include <array>
#include <string_view>

#include "postproc/gcode/siemens/siemens_run.h"

// The structures of a program: conditions and loops, which must be complete and nested.
// Source: Siemens, NC programming, 12/2019, 3.1.6 "Check structures".

namespace gouge {
namespace {

struct Row {
  std::string_view word;
  StructureWord::Kind kind;
  std::string_view pair;
};

using enum StructureWord::Kind;
constexpr auto kRows = std::to_array<Row>({{"IF", begin, "IF"},
                                           {"ELSE", otherwise, "IF"},
                                           {"ENDIF", end, "IF"},
                                           {"WHILE", begin, "WHILE"},
                                           {"ENDWHILE", end, "WHILE"},
                                           {"FOR", begin, "FOR"},
                                           {"ENDFOR", end, "FOR"},
                                           {"LOOP", begin, "LOOP"},
                                           {"ENDLOOP", end, "LOOP"},
                                           {"REPEAT", begin, "REPEAT"},
                                           {"UNTIL", end, "REPEAT"}});

const Row* row_of(std::string_view word) {
  for (const Row& row : kRows)
    if (row.word == word) return &row;
  return nullptr;
}

}  // namespace

// A program is examined once, when the first of these words runs, or a jump.
const BlockStructures& SiemensRun::structures() {
  if (text_->structures) return *text_->structures;
  BlockStructures& made = text_->structures.emplace();
  for (std::size_t i = text_->program->begin(); i < text_->program->end() && made.fault().empty(); ++i) {
    const Row* const row = row_of(flow_at(i));
    if (row == nullptr) continue;
    const std::string name(row->word);
    const std::size_t line = text_->program->number(i);
    made.add(line, {row->kind, std::string(row->pair), name});
    if (is_open_at(i))
      made.refuse(name + " in line " + std::to_string(line) +
                  " may be left out by a switch of the control; expected --block-delete on or off");
  }
  made.finish();
  return made;
}

std::string SiemensRun::structure_fault() { return row_of(flow_at(at_)) == nullptr ? "" : structures().fault(); }

}  // namespace gouge
