#include "cli/options/reading_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "cli/options/command_doc.h"
#include "cli/options/parse_errors.h"
#include "cli/options/program_options.h"
#include "cli/terminal/length_text.h"
#include "lib/base/letters.h"
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
       .recorded = Recorded::repeated},
      {.name = "--control",
       .field = &A::control,
       .group = kProgramGroup,
       .help = "Control that runs the program (G-code); default: that of --machine",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = control_ids()},
      {.name = "--offset",
       .field = &A::offsets,
       .type = "NAME=X,Y,Z",
       .help =
           "Zero of a work offset in machine coordinates, G54=x,y,z[,a,b,c]: lengths in mm or with a unit, then degrees; "
           "PRESET or PRESET1 for presets of Heidenhain (repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--tool-lengths",
       .field = &A::tool_lengths,
       .type = "FILE",
       .help = "Lengths of tools: CSV with the columns tool and length (mm), or a tool table of LinuxCNC (.tbl, mm) or "
               "Heidenhain (TOOL.T)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--start",
       .field = &A::start,
       .type = "BLOCK",
       .help = "Block in force at the start of the program, such as \"G17 G21 G90\" (repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--tip-control-end",
       .field = &A::tip_control_ends,
       .type = "CODE",
       .help = "Code that ends tool centre point control where no manual states it, such as G255 (repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--block-delete",
       .field = &A::block_delete,
       .help = "Position of the switch for block delete. on: blocks with a slash are left out",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {"on", "off"}},
      {.name = "--home",
       .field = &A::home,
       .type = "X,Y,Z",
       .help = "Home position of the linear joints in machine coordinates (G28)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--plain-numbers",
       .field = &A::plain_numbers,
       .help = "Meaning of numbers without a decimal point. units: X100 is 100 mm or inches. increments: X100 is 100 "
               "times 0.001 mm, 0.0001 inches or 0.001 degrees",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {"units", "increments"}},
      {.name = "--tip-frame",
       .field = &A::tip_frame,
       .help =
           "Coordinates under tool centre point control on a machine whose table turns, where a parameter states it "
           "(Fanuc G43.4). table: they turn with the table, which is at 0 where the control begins. table-at-zero, "
           "table-at-call: they turn with it, and are those with the table at 0, or as it stands at the call",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {"table", "table-at-zero", "table-at-call", "workpiece"}},
      {.name = "--rotary-turns",
       .field = &A::rotary_turns,
       .help = "Way of a rotary joint to an absolute position. as-programmed: it turns by the difference",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {"as-programmed"}}};
  return rows;
}

std::vector<std::string> options_without_effect(const ReadingArguments& arguments, bool is_program) {
  static const std::set<std::string> kOfClData = {"cutcom", "retract-plane"};
  OptionRows<ReadingArguments> others;
  bool is_of_programs = false;  // a row has the group of the one before
  for (const OptionRow<ReadingArguments>& row : reading_options()) {
    is_of_programs = is_of_programs || (row.group != nullptr && std::string_view(row.group) == kProgramGroup);
    if (is_program ? kOfClData.contains(row.key()) : is_of_programs) others.push_back(row);
  }
  std::vector<std::string> names;
  for (const OptionText& option : recorded_options(arguments, others)) {
    const std::string name = "--" + option.name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

Result<ReadOptions> understand(const ReadingArguments& arguments) {
  ReadOptions options;
  Result<ProgramSetup> program = understand_program(arguments);
  if (!program) return program.error();
  options.program = std::make_shared<const ProgramSetup>(std::move(*program));
  if (!arguments.dialect.empty()) {
    options.dialect = dialect_called(arguments.dialect);
    if (!options.dialect) {
      const std::string nearest = nearest_name(in_small_letters(arguments.dialect), choices_of_type("DIALECT"));
      return usage_error("--dialect", arguments.dialect, "one of " + dialect_names() + meant(nearest));
    }
  }
  options.unit = unit_called(arguments.units);
  options.is_cutcom_centre = arguments.cutcom == "centre";
  if (!arguments.retract_plane.empty()) {
    options.retract_plane_mm = parse_length_mm(arguments.retract_plane);
    if (!options.retract_plane_mm)
      return usage_error("--retract-plane", arguments.retract_plane,
                         "a length in mm, or with a unit (2in)" + decimal_comma_hint(arguments.retract_plane));
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
