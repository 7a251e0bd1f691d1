#pragma once

#include <iosfwd>
#include <string>

#include "lib/base/result.h"
#include "postproc/report/findings.h"

namespace CLI {
class App;
}

namespace gouge {

/// Options of `check` and `correct` for findings on standard output, as typed.
struct ListingArguments {
  std::string sort = "path", min_depth = "0";
  std::string most = "auto";
};

/// The group of options that state what is printed for people. They belong to a command line, never to a job of a
/// batch.
inline constexpr const char* kTerminalGroup = "Terminal";

void add_listing_options(CLI::App& command, ListingArguments& arguments);

/// --color of every command.
void add_colour_option(CLI::App& command, std::string& colour);

/// As into a file: plain, and all findings unless a number is given. Errors: usage.
[[nodiscard]] Result<FindingsView> understand(const ListingArguments& arguments);

/// For what is printed on `out`: coloured where that is, and fifty findings at most where it is a terminal and nothing
/// else is stated. Requires arguments that can be understood.
[[nodiscard]] FindingsView view_on(std::ostream& out, const ListingArguments& arguments, bool has_statements);

}  // namespace gouge
