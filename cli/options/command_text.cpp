#include "cli/options/command_text.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "postproc/report/report_model.h"

namespace gouge {
namespace {

constexpr std::string_view kOfNoResult[] = {"threads",   "progress",     "quiet",       "verbose",  "report",
                                            "json",      "csv",          "sarif",       "junit",    "export",
                                            "help",      "project",      "reviewer",    "color",    "sort",
                                            "min-depth", "max-findings", "certificate", "no-config"};

bool is_plain(char c) {
  constexpr std::string_view kMore = "%+,-./:=@_^";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         kMore.find(c) != std::string_view::npos;
}

std::string shell_quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string repeatable_command(const CLI::App& command) {
  std::string text = std::string(kProgramName) + " " + command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    if (option->get_lnames().empty()) {
      for (const std::string& value : option->results()) text += " " + shell_quoted(value);
      continue;
    }
    const std::string& name = option->get_lnames().front();
    if (std::ranges::find(kOfNoResult, name) != std::end(kOfNoResult)) continue;
    if (name == "force" && command.get_name() == "check") continue;  // of `check` it is about the report's folder alone
    if (option->get_items_expected_max() == 0) {
      text += " --" + name;
      continue;
    }
    for (const std::string& value : option->results()) text += " --" + name + " " + shell_quoted(value);
  }
  return text;
}

}  // namespace gouge
