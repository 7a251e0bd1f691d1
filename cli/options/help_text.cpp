#include "cli/options/help_text.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "cli/options/command_doc.h"
#include "cli/options/length_rule.h"
#include "lib/base/printable_text.h"
#include "postproc/report/report_model.h"

namespace gouge {

namespace {

class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(const HelpColumns& columns) : columns_(columns) {}

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const OptionDoc doc = document(*option);
    const std::string value = is_positional || doc.value.empty() ? "" : " " + doc.value;
    return columns_.row(listed(doc.names) + value, doc.full_description());
  }
  std::string make_subcommand(const CLI::App* command) const override {
    return columns_.row(command->get_name(), command->get_description());
  }
  std::string make_description(const CLI::App* command) const override {
    return columns_.paragraph(command->get_description());
  }
  std::string make_footer(const CLI::App* command) const override {
    const std::string rule = length_rule(*command);
    return columns_.paragraph(rule + (rule.empty() ? "" : "\n\n") + command->get_footer());
  }

 private:
  HelpColumns columns_;
};

}  // namespace

std::string HelpColumns::row(const std::string& name, const std::string& description, std::size_t names) const {
  constexpr std::size_t kMinBeside = 72, kNarrow = 6;  // below kMinBeside, descriptions stand below the names
  const std::size_t left = all_ < kMinBeside ? kNarrow : names;
  std::string line = "  " + name;
  line += line.size() + 1 < left ? std::string(left - line.size(), ' ') : "\n" + std::string(left, ' ');
  return line + wrapped(description, all_, left) + "\n";
}

std::string HelpColumns::paragraph(const std::string& text) const {
  return text.empty() ? text : wrapped(text, all_, 0) + "\n";
}

std::shared_ptr<CLI::FormatterBase> make_help_formatter(const HelpColumns& columns) {
  return std::make_shared<HelpFormatter>(columns);
}

namespace {

constexpr std::string_view kOfNoResult[] = {"threads",   "progress",     "quiet",       "verbose",     "report",
                                            "json",      "csv",          "sarif",       "junit",       "export",
                                            "help",      "project",      "reviewer",    "color",       "sort",
                                            "min-depth", "max-findings", "certificate", "write-stock", "no-config"};

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

std::string repeatable_words(const std::string& command, const std::vector<std::string>& words) {
  std::string text = std::string(kProgramName) + " " + command;
  for (const std::string& word : words) text += " " + shell_quoted(word);
  return text;
}

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
