#include "cli/terminal/listing_options.h"

#include <CLI/CLI.hpp>

#include "cli/terminal/length_text.h"
#include "cli/terminal/terminal.h"
#include "lib/base/number_text.h"

namespace gouge {

void add_listing_options(CLI::App& command, ListingArguments& arguments) {
  command
      .add_option("--sort", arguments.sort,
                  "Order of the printed findings: by the path, or by depth with the deepest first")
      ->check(CLI::IsMember({"path", "depth"}))
      ->capture_default_str()
      ->group(kTerminalGroup);
  command
      .add_option("--min-depth", arguments.min_depth,
                  "Print only findings whose depth may reach this. Verdict, counts and files include all findings")
      ->type_name("LENGTH")
      ->capture_default_str()
      ->group(kTerminalGroup);
  command
      .add_option("--max-findings", arguments.most,
                  "Print the N deepest findings and the number of the others (auto: 50 on a terminal, otherwise "
                  "all)")
      ->type_name("N|auto|all")
      ->capture_default_str()
      ->group(kTerminalGroup);
}

void add_colour_option(CLI::App& command, std::string& colour) {
  command.add_option("--color", colour, "Colour the output (auto: on a terminal, unless NO_COLOR is set)")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->default_str("auto")
      ->group(kTerminalGroup);
}

Result<FindingsView> understand(const ListingArguments& arguments) {
  FindingsView view;
  view.is_deepest_first = arguments.sort == "depth";
  const Result<double> depth = understand_length("--min-depth", arguments.min_depth, Minimum::zero);
  if (!depth) return depth.error();
  view.min_depth_mm = *depth;
  if (arguments.most == "auto" || arguments.most == "all") return view;
  const auto most = parse_integer(arguments.most);
  if (!most || *most < 0) return usage_error("--max-findings", arguments.most, "a whole number, auto or all");
  view.most = static_cast<std::size_t>(*most);
  return view;
}

FindingsView view_on(std::ostream& out, const ListingArguments& arguments, bool has_statements) {
  constexpr std::size_t kMaxOnTerminal = 50;
  FindingsView view = understand(arguments).value();
  if (arguments.most == "auto" && is_terminal(out)) view.most = kMaxOnTerminal;
  view.has_statements = has_statements;
  view.is_coloured = is_coloured(out);
  view.columns = terminal_columns(out);
  return view;
}

}  // namespace gouge
