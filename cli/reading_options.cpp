#include "cli/reading_options.h"

#include <CLI/CLI.hpp>

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
    if (!options.dialect) {
      return make_error("usage", "--dialect '" + arguments.dialect + "': expected one of " + dialect_names());
    }
  }
  if (!arguments.units.empty()) options.unit = arguments.units == "inch" ? LengthUnit::inch : LengthUnit::mm;
  options.is_cutcom_centre = arguments.cutcom == "centre";
  return options;
}

}  // namespace gouge
