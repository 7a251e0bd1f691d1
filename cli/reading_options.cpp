#include "cli/reading_options.h"

#include <CLI/CLI.hpp>

#include "cli/length_text.h"
#include "lib/base/byte_size.h"

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

void add_input_limit(CLI::App& command, InputLimit& limit) {
  command
      .add_option_function<std::string>(
          "--max-input",
          [&limit](const std::string& size) { limit.most_bytes = parse_byte_size(size).value_or(kMaxInputBytes); },
          "Most that a file or pipe may hold that is read (B, kB, MB, GB, TB, KiB, MiB, GiB, TiB)")
      ->type_name("SIZE")
      ->default_str("8GB")
      ->check([](const std::string& size) {
        return parse_byte_size(size) ? std::string() : "expected a size above 0 with a unit or in bytes, such as 8GB";
      });
}

}  // namespace gouge
