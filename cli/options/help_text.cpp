#include "cli/options/help_text.h"

#include <CLI/CLI.hpp>

#include "cli/options/command_doc.h"
#include "cli/options/length_rule.h"

namespace gouge {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kNames = 30;  // columns for what stands left of the descriptions

std::string help_row(const std::string& name, const std::string& text) {
  std::string line = "  " + name;
  line += line.size() + 1 < kNames ? std::string(kNames - line.size(), ' ') : "\n" + std::string(kNames, ' ');
  return line + wrapped(text, kWidth, kNames) + "\n";
}

std::string paragraph(const std::string& text) { return text.empty() ? text : wrapped(text, kWidth, 0) + "\n"; }

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const OptionDoc doc = document(*option);
    const std::string value = is_positional || doc.value.empty() ? "" : " " + doc.value;
    return help_row(listed(doc.names) + value, doc.full_description());
  }
  std::string make_subcommand(const CLI::App* command) const override {
    return help_row(command->get_name(), command->get_description());
  }
  std::string make_description(const CLI::App* command) const override { return paragraph(command->get_description()); }
  std::string make_footer(const CLI::App* command) const override {
    const std::string rule = length_rule(*command);
    return paragraph(rule + (rule.empty() ? "" : "\n\n") + command->get_footer());
  }
};

}  // namespace

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  const std::string new_line = "\n" + std::string(indent, ' ');
  std::string out;
  std::size_t used = indent;
  for (std::size_t at = 0; at < text.size();) {
    const bool is_example = (at == 0 || text[at - 1] == '\n') && text[at] == ' ';
    const std::size_t end = std::min(text.find_first_of(is_example ? "\n" : " \n", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const bool is_first = used == indent;
    if (!is_first && used + 1 + word.size() > width) {
      out += new_line;
      used = indent;
    } else if (!is_first && !word.empty()) {
      out += " ";
      ++used;
    }
    out += word;
    used += word.size();
    at = end + 1;
    if (end < text.size() && text[end] == '\n') {
      out += new_line;
      used = indent;
    }
  }
  return out;
}

std::shared_ptr<CLI::FormatterBase> make_help_formatter() { return std::make_shared<HelpFormatter>(); }

}  // namespace gouge
