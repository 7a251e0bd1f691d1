#include "cli/commands/job_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include "cli/commands/correct_command.h"
#include "cli/machine/machine_choice.h"
#include "cli/options/help_text.h"
#include "cli/options/length_rule.h"
#include "cli/options/parse_errors.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

constexpr std::string_view kOfBatch[] = {"threads", "progress", "quiet", "verbose", "report"};

/// A parser for one command, with the variables for its values.
struct CommandParser {
  explicit CommandParser(const std::string& command) {
    program.name(kProgramName);
    program.require_subcommand(1);
    if (command == "check") {
      add_check_options(*program.add_subcommand("check"), check);
    } else {
      add_correct_options(*program.add_subcommand("correct"), correct);
    }
  }
  [[nodiscard]] const CLI::App& command() const { return *program.get_subcommands({}).front(); }

  CLI::App program;
  CheckArguments check;
  CorrectArguments correct;
};

std::optional<std::string> why_not_in_job(const CLI::Option& option) {
  const std::string& name = option.get_lnames().front();
  if (std::ranges::find(kOfBatch, name) != std::end(kOfBatch))
    return "is an option of the batch, not of a job; say it on the command line";
  if (option.get_group() == kTerminalGroup)
    return "says what is printed on a terminal; expected an option of the check";
  return std::nullopt;
}

std::string kind_of(const nlohmann::json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list";
  if (value.is_null()) return "null";
  return value.is_boolean() ? "true or false" : value.is_string() ? "a text" : "a number";
}

}  // namespace

const WordRules& job_rules() {
  static const WordRules rules{"jobs-option", why_not_in_job, "standard output is the batch's"};
  return rules;
}

// Returns a table that is made once for each command, because making one costs more than reading a small job list.
const CLI::App& option_table(const std::string& command) {
  static const CommandParser check("check"), correct("correct");
  return (command == "check" ? check : correct).command();
}

Diagnostic JobWords::wrong(const std::string& message) const { return make_error(rules_->error_code, message); }

Diagnostic JobWords::unknown(const std::string& key) const {
  std::vector<std::string> names;
  for (const CLI::Option* option : option_table(command_).get_options()) {
    for (const std::string& name : option->get_lnames()) {
      if (name != "help" && !rules_->why_not(*option)) names.push_back(name);
    }
  }
  const std::string nearest = nearest_name(key.substr(std::min(key.find_first_not_of('-'), key.size())), names);
  return wrong("\"" + key + "\" is no option of " + command_ + "; expected the long name of one without its --" +
               (nearest.empty() ? "; see gougecheck " + command_ + " --help" : "; did you mean \"" + nearest + "\"?"));
}

std::string JobWords::located(const std::string& file) const {
  // A preset of --machine is not a file.
  if (folder_.empty() || file.empty() || file.front() == '/' || file.starts_with(kMachinePreset)) return file;
  return (std::filesystem::path(folder_) / file).string();
}

std::string JobWords::located_before(const std::string& typed) const {
  BeforeText before = split_before(typed);
  before.path = located(before.path);
  before.tools = located(before.tools);
  return before.typed();
}

std::string option_of_key(const std::string& key) { return key == "harmless_words" ? "harmless-word" : key; }

std::string key_of_option(const std::string& name) { return name == "harmless-word" ? "harmless_words" : name; }

Outcome JobWords::add(const std::string& given, const nlohmann::json& value) {
  const std::string key = option_of_key(given);
  const CLI::Option* option = option_table(command_).get_option_no_throw("--" + key);
  if (option == nullptr || key == "help") return unknown(key);
  if (const auto reason = rules_->why_not(*option)) return wrong("\"" + key + "\" " + *reason);
  if (value.is_object() && option->get_type_name() == "BODY=LENGTH") return add_by_body(key, value);
  const bool is_flag = option->get_items_expected_max() == 0;
  if (is_flag) {
    if (!value.is_boolean()) return wrong("\"" + key + "\" is " + kind_of(value) + "; expected true or false");
    if (value.get<bool>()) words_.push_back("--" + key);
    return Done{};
  }
  if (value.is_array()) {
    if (option->get_items_expected_max() == 1)
      return wrong("\"" + key + "\" is a list; expected one value, as the option may be given once");
    for (const nlohmann::json& one : value) {
      if (one.is_array()) return wrong("\"" + key + "\" holds a list; expected texts or numbers");
      if (Outcome added = add(key, one); !added) return added;
    }
    return Done{};
  }
  if (!value.is_string() && !value.is_number())
    return wrong("\"" + key + "\" is " + kind_of(value) + "; expected a text or a number");
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (text.empty()) return wrong("\"" + key + "\" is empty; expected a value, or leave it out");
  // The system reads a name only up to this character, so the name would lead to another file than the one examined.
  if (text.find('\0') != std::string::npos)
    return wrong("\"" + key + "\" holds the character U+0000; expected a text without it");
  const std::string type = option->get_type_name();
  const bool is_shape = key == "stock" && !names_stock_file(text);
  const bool is_file = (type == "FILE" || type == "FIXTURE") && !is_shape;
  if (text == "-" && type == "FILE") return wrong("\"" + key + "\" is -; expected a file: " + rules_->why_no_dash);
  words_.push_back("--" + key + "=" + (key == "before" ? located_before(text) : is_file ? located(text) : text));
  return Done{};
}

Outcome JobWords::add_by_body(const std::string& key, const nlohmann::json& value) {
  std::string text;
  for (const auto& [body, length] : value.items()) {
    if (!length.is_string() && !length.is_number())
      return wrong("\"" + key + "\" of \"" + body + "\" is " + kind_of(length) + "; expected a length");
    text += (text.empty() ? "" : ",") + body + "=" + (length.is_string() ? length.get<std::string>() : length.dump());
  }
  if (text.empty()) return wrong("\"" + key + "\" is an empty object; expected {\"holder\": 1}, or leave it out");
  words_.push_back("--" + key + "=" + text);
  return Done{};
}

Result<CommandArguments> parse_command(const std::string& command, const std::vector<std::string>& words) {
  CommandParser parser(command);
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  reversed.push_back(command);
  try {
    parser.program.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    return describe_parse_error(parser.program, error);
  }
  JobArguments& job = command == "check" ? parser.check.job : parser.correct.job;
  job.command = repeatable_command(parser.command());
  job.lengths_in_mm = lengths_in_mm(parser.command());
  const std::optional<Diagnostic> error =
      command == "check" ? find_wrong_value(parser.check) : find_wrong_value(parser.correct);
  if (error) return *error;
  if (command == "check") return CommandArguments(std::move(parser.check));
  return CommandArguments(std::move(parser.correct));
}

}  // namespace gouge
