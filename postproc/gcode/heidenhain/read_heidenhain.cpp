#include "postproc/gcode/heidenhain/read_heidenhain.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/gcode/heidenhain/klartext_run.h"

namespace gouge {

bool is_heidenhain_program(std::string_view bytes) {
  constexpr std::size_t kLinesOfRecognition = 20;
  for (std::size_t at = 0, lines = 0; at < bytes.size() && lines < kLinesOfRecognition; ++lines) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    const KlartextBlock block = read_klartext_line(trim_blanks(bytes.substr(at, end - at)));
    at = end + 1;
    if (block.text.empty()) continue;
    std::string_view text = block.text;
    return take_keywords(text, "BEGIN PGM") && (text.ends_with(" MM") || text.ends_with(" INCH"));
  }
  return false;
}

ProgramFacts run_heidenhain(const ProgramInput& input) {
  const ProgramText text(input.path.source, input.path.statements);
  QParameters parameters;
  KlartextRunner runner(input, parameters);
  KlartextRun run(input, text, runner, parameters);
  run.run_start(input.options.setup.start);
  run.run();
  return runner.facts();
}

}  // namespace gouge
