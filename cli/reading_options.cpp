#include "cli/reading_options.h"

#include <CLI/CLI.hpp>

#include "cli/length_text.h"

namespace gouge {

void add_reading_options(CLI::App& command, ReadingArguments& arguments) {
  command
      .add_option("--dialect", arguments.dialect,
                  "Read the toolpath as this dialect (default: recognized by its content): " + dialect_names())
      ->type_name("DIALECT");
  command.add_option("--path-units", arguments.units, "Unit of a toolpath that states none")
      ->check(CLI::IsMember({"mm", "inch"}));
  command
      .add_option("--cutcom", arguments.cutcom,
                  "centre: positions under CUTCOM are the cutter centre, with no offset dialled in (default: these "
                  "moves are not checked)")
      ->check(CLI::IsMember({"centre"}));
}

Result<ReadOptions> understand(const ReadingArguments& arguments) {
  ReadOptions options;
  if (!arguments.dialect.empty()) {
    options.dialect = dialect_called(arguments.dialect);
    if (!options.dialect) return usage_error("--dialect", arguments.dialect, "one of " + dialect_names());
  }
  options.unit = unit_called(arguments.units);
  options.is_cutcom_centre = arguments.cutcom == "centre";
  return options;
}

}  // namespace gouge
