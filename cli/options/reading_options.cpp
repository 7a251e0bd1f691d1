#include "cli/options/reading_options.h"

#include <CLI/CLI.hpp>
#include <optional>

#include "cli/terminal/length_text.h"
#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/language/words.h"

namespace gouge {

namespace {

// A word in a project file must not switch off what is read.
std::optional<Diagnostic> why_not_harmless(const std::string& word) {
  const Word known = find_word(word);
  if ((known != Word::unknown && known != Word::harmless) || is_minor_word(word))
    return usage_error("--harmless-word", word, "a word of your own: this one is read, and what it says holds");
  const bool is_word = !word.empty() && word.find_first_of(" \t\r\n/,;$()") == std::string::npos &&
                       !is_digit(word.front()) && std::string("+-.").find(word.front()) == std::string::npos;
  if (!is_word)
    return usage_error("--harmless-word", word, "the word that a statement begins with, such as MYWORD of MYWORD/5");
  return std::nullopt;
}

}  // namespace

const OptionRows<ReadingArguments>& reading_options() {
  using A = ReadingArguments;
  static const OptionRows<A> rows = {
      {.name = "--dialect",
       .field = &A::dialect,
       .type = "DIALECT",
       .help = "Dialect of the toolpath (default: recognized by its content): " + dialect_names(),
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--path-units",
       .field = &A::units,
       .help = "Unit of a toolpath that states no unit",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {"mm", "inch"},
       .result_key = "toolpath-units"},
      {.name = "--cutcom",
       .field = &A::cutcom,
       .help = "Meaning of positions under CUTCOM. centre: they are those of the cutter centre, and the offset "
               "in the control is 0 (default: these moves are not checked)",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {"centre"}},
      {.name = "--retract-plane",
       .field = &A::retract_plane,
       .type = "LENGTH",
       .help = "Z of the plane to which a drilling cycle retracts if it states no height (RTRCTO,AUTO of NX). Z is "
               "in the coordinates of the positions and not below the clearance of the cycle (default: these "
               "retracts are not checked)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--harmless-word",
       .field = &A::harmless_words,
       .type = "WORD",
       .help = "Your own word that causes no motion and no change: statements that begin with it are ignored "
               "(repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::repeated}};
  return rows;
}

Result<ReadOptions> understand(const ReadingArguments& arguments) {
  ReadOptions options;
  if (!arguments.dialect.empty()) {
    options.dialect = dialect_called(arguments.dialect);
    if (!options.dialect) return usage_error("--dialect", arguments.dialect, "one of " + dialect_names());
  }
  options.unit = unit_called(arguments.units);
  options.is_cutcom_centre = arguments.cutcom == "centre";
  if (!arguments.retract_plane.empty()) {
    options.retract_plane_mm = parse_length_mm(arguments.retract_plane);
    if (!options.retract_plane_mm)
      return usage_error("--retract-plane", arguments.retract_plane, "a length in mm, or with a unit (2in)");
  }
  for (const std::string& word : arguments.harmless_words) {
    if (auto error = why_not_harmless(word)) return *error;
    options.harmless_words.push_back(word);
  }
  return options;
}

void add_input_limit(CLI::App& command, InputLimit& limit) {
  command
      .add_option_function<std::string>(
          "--max-input",
          [&limit](const std::string& size) { limit.max_bytes = parse_byte_size(size).value_or(kMaxInputBytes); },
          "Maximum size of an input file or pipe (B, kB, MB, GB, TB, KiB, MiB, GiB, TiB)")
      ->type_name("SIZE")
      ->default_str("8GB")
      ->check([](const std::string& size) {
        return parse_byte_size(size) ? std::string() : "expected a size above 0 with a unit or in bytes, such as 8GB";
      });
}

}  // namespace gouge
