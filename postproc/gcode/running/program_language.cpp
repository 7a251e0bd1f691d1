#include "postproc/gcode/running/program_language.h"

namespace gouge {

void lose_program(const std::string& reason, std::size_t line, const ProgramInput& input) {
  if (input.motion.is_rest_unknown()) return;
  ++input.path.words_not_understood["line " + std::to_string(line) + ": " + reason];
  input.motion.doubt(ProgramDoubt::rest, "line " + std::to_string(line) + " is not understood: " + reason);
  input.path.notes.push_back(make_warning("gcode-word",
                                          reason +
                                              "; nothing after it is checked: correct the program, or state a word "
                                              "that neither moves nor changes anything with --harmless-word",
                                          input.path.file, line));
  input.motion.go_unchecked(MoveKind::feed, AxisPlace{}, {});
}

}  // namespace gouge
