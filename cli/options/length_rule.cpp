#include "cli/options/length_rule.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "cli/options/mesh_limits.h"
#include "cli/terminal/length_text.h"
#include "lib/base/number_text.h"
#include "postproc/report/remedies.h"

namespace gouge {
namespace {

bool is_length(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type == "LENGTH" || type == "X,Y,Z" || type == "JOINT=X,Y,Z" || type == "BODY=LENGTH";
}

// Names a file with limits of its own.
bool may_have_limits(const CLI::Option& option) {
  return option.check_name("--part") || option.check_name("--fixture");
}

// Converts only the lengths of "x,y,z,rx,ry,rz", only the limits of "vise.stl,clearance=1".
std::vector<std::string> lengths_of(const CLI::Option& option, const std::string& typed) {
  std::vector<std::string> files;
  LimitTexts limits;
  if (may_have_limits(option)) split_limits({typed}, files, limits);
  std::string text = typed;
  if (may_have_limits(option)) text = limits.empty() ? "" : limits.begin()->second;
  std::vector<std::string> parts = CLI::detail::split(text, ',');
  if (option.get_type_name() == "X,Y,Z") parts.resize(std::min<std::size_t>(parts.size(), 3));
  for (std::string& part : parts) part.erase(0, part.find('=') + 1);
  return parts;
}

bool is_number_but_0(const std::string& text) {
  const std::optional<double> number = parse_number(text);
  return number && std::abs(*number) > 0;
}

}  // namespace

std::string length_rule(const CLI::App& command) {
  const std::vector<const CLI::Option*> options = command.get_options();
  if (std::none_of(options.begin(), options.end(), [](const CLI::Option* option) { return is_length(*option); }))
    return {};
  return "Lengths in options are in mm, even if a file is in inches. A unit may follow: 0.5mm, 20um, 0.02 in.";
}

std::vector<std::string> lengths_in_mm(const CLI::App& command) {
  std::vector<std::string> found;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || !(is_length(*option) || may_have_limits(*option))) continue;
    for (const std::string& typed : option->results()) {
      const std::vector<std::string> lengths = lengths_of(*option, typed);
      if (std::any_of(lengths.begin(), lengths.end(), is_number_but_0))
        found.push_back(option->get_name() + " " + typed);
    }
  }
  return found;
}

Diagnostic describe_lengths_in_mm(const std::vector<std::string>& lengths, const std::string& what) {
  return make_note(kLengthsInMm, listed(lengths, " and ") + (lengths.size() == 1 ? " is" : " are") +
                                     " taken in mm, although " + what +
                                     " is in inches; write a unit behind each number, as in 0.02in or 0.5mm");
}

std::string with_units(const std::string& typed) {
  std::string text;
  std::size_t count = 0;
  for (const std::string& part : CLI::detail::split(typed, ',')) {
    const bool is_bare = count++ < 3 && parse_number(part).has_value();
    text += (text.empty() ? "" : ",") + part + (is_bare ? "mm" : "");
  }
  return text;
}

}  // namespace gouge
