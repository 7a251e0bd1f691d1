#pragma once

#include <iosfwd>
#include <string>

#include "lib/base/result.h"
#include "postproc/report/findings.h"

namespace CLI {
class App;
}

namespace gouge {

/// Options of `check` and `correct` for the findings on standard output, as typed.
struct ListingArguments {
  std::string sort = "path", min_depth = "0";
  std::string most = "auto";
};

/// The group of options that control printed text. They belong to a command line, never to a job of a batch.
inline constexpr const char* kTerminalGroup = "Terminal";

void add_listing_options(CLI::App& command, ListingArguments& arguments);

/// Adds --color, which every command has.
void add_colour_option(CLI::App& command, std::string& colour);

/// Returns the view for output to a file: plain, with all findings unless a number is given. Errors: usage.
[[nodiscard]] Result<FindingsView> understand(const ListingArguments& arguments);

/// Returns the view for output to `out`, with colours if `out` has them. It has at most fifty findings if `out` is a
/// terminal and no number is given. Requires arguments that can be understood.
[[nodiscard]] FindingsView view_on(std::ostream& out, const ListingArguments& arguments, bool has_statements);

}  // namespace gouge
