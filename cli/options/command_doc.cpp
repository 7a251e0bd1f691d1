#include "cli/options/command_doc.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/options/help_text.h"
#include "cli/options/length_rule.h"
#include "postproc/cldata/language/dialect.h"

namespace gouge {
namespace {

std::string first_name(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
}

// The parser's names for types of numbers and of choices help users little.
std::string value_of(const std::string& type, const std::vector<std::string>& choices) {
  if (type.starts_with("TEXT") && !choices.empty()) {
    std::string value;
    for (const std::string& choice : choices) value += (value.empty() ? "" : "|") + choice;
    return value;
  }
  if (type == "UINT") return "N";
  if (type == kWritableDialect) return "DIALECT";
  return type.starts_with("FLOAT") ? "NUMBER" : type.substr(0, type.find(':'));
}

}  // namespace

std::vector<std::string> choices_of_type(const std::string& type) {
  if (type != "DIALECT" && type != kWritableDialect) return choices_in(type);
  std::vector<std::string> names =
      CLI::detail::split(type == "DIALECT" ? dialect_names() : writable_dialect_names(), ',');
  for (std::string& name : names) CLI::detail::trim(name);
  return names;
}

std::vector<std::string> choices_in(const std::string& text) {
  const std::size_t open = text.rfind('{'), close = text.rfind('}');
  if (open == std::string::npos || close == std::string::npos || open > close) return {};
  return CLI::detail::split(text.substr(open + 1, close - open - 1), ',');
}

std::string OptionDoc::full_description() const {
  std::string text = description;
  if (!needs.empty()) text += " [with " + listed(needs, " and ") + "]";
  if (!default_value.empty()) text += " [default: " + default_value + "]";
  return text + (is_required ? " [required]" : "");
}

bool OptionDoc::takes_file() const { return value == "FILE" || value == "FIXTURE"; }

OptionDoc document(const CLI::Option& option) {
  OptionDoc doc;
  doc.is_positional = option.get_positional();
  if (doc.is_positional) {
    doc.names = {option.get_name(true, false)};
  } else {
    for (const std::string& name : option.get_snames()) doc.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) doc.names.push_back("--" + name);
  }
  if (option.get_items_expected_max() > 0) {
    const std::string type = option.get_type_name();
    doc.choices = choices_of_type(type);
    doc.value = value_of(type, doc.choices);
    doc.default_value = option.get_default_str();
    if (type == "LENGTH" && !doc.default_value.empty()) doc.default_value = with_units(doc.default_value);
  }
  doc.description = option.get_description();
  doc.group = option.get_group();
  doc.is_required = option.get_required();
  for (const CLI::Option* needed : option.get_needs()) doc.needs.push_back(first_name(*needed));
  doc.is_repeatable = option.get_items_expected_max() > 1;
  return doc;
}

std::string CommandDoc::word() const { return name.substr(name.rfind(' ') + 1); }

CommandDoc document(const CLI::App& app) {
  CommandDoc doc;
  for (const CLI::App* at = &app; at != nullptr; at = at->get_parent())
    doc.name = at->get_name() + (doc.name.empty() ? "" : " " + doc.name);
  doc.description = app.get_description();
  const std::string rule = length_rule(app);
  doc.footer = app.get_footer();
  if (!rule.empty()) doc.footer = rule + (doc.footer.empty() ? "" : "\n\n") + doc.footer;
  for (const CLI::Option* option : app.get_options()) doc.options.push_back(document(*option));
  std::stable_partition(doc.options.begin(), doc.options.end(),
                        [](const OptionDoc& option) { return option.is_positional; });
  for (const CLI::App* command : app.get_subcommands({})) doc.commands.push_back(document(*command));
  return doc;
}

}  // namespace gouge
