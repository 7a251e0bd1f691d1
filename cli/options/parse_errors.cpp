#include "cli/options/parse_errors.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "cli/options/command_doc.h"
#include "cli/options/help_text.h"
#include "cli/values/parse_lengths.h"
#include "lib/base/letters.h"
#include "lib/base/similar_name.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

std::string is_no_command(const std::string& word, const std::string& program,
                          const std::vector<std::string>& commands) {
  return "'" + word + "' is no command of " + program + "; expected " + listed(commands, " or ") +
         meant(nearest_name(in_small_letters(word), commands));
}

// The error of the first word behind the program's name: an option before the command, or no command at all.
std::string explain_beginning(const CLI::App& program, std::span<const char* const> words) {
  if (words.size() < 2) return {};
  const std::vector<std::string> commands = command_names(program);
  const auto is_command = [&](const std::string& word) {
    return std::find(commands.begin(), commands.end(), word) != commands.end();
  };
  const std::string first = words[1];
  const std::string option = first.substr(0, first.find('='));
  if (is_command(first) || (first.starts_with('-') && program.get_option_no_throw(option) != nullptr)) return {};
  if (!first.starts_with('-')) return is_no_command(first, kProgramName, commands);
  const auto command = std::find_if(words.begin() + 2, words.end(), is_command);
  const std::string name = command == words.end() ? "COMMAND" : *command;
  return "'" + option + "' stands before the command; expected the command first: " + kProgramName + " " + name + " " +
         option + " ..." + (command == words.end() ? ", with " + listed(commands, " or ") : "");
}

/// The command that was being read when the parse failed.
class Command {
 public:
  explicit Command(const CLI::App& program) : app_(&program), name_(kProgramName) {
    while (!app_->get_subcommands().empty()) {
      app_ = app_->get_subcommands().back();
      name_ += " " + app_->get_name();
    }
    commands_ = command_names(*app_);
  }

  [[nodiscard]] std::string empty_value(std::span<const char* const> words) const {
    for (const CLI::Option* option : app_->get_options()) {
      const std::vector<std::string>& values = option->results();
      const bool takes_value = option->get_items_expected_max() > 0;
      if (takes_value && std::find(values.begin(), values.end(), "") != values.end()) return unset(*option);
    }
    // The parser gives "--csv=" the word behind it.
    for (const std::string_view word : words) {
      if (word == "--") break;
      if (!word.starts_with("--") || word.find('=') + 1 != word.size()) continue;
      const CLI::Option* option = app_->get_option_no_throw(std::string(word.substr(0, word.size() - 1)));
      if (option != nullptr && option->get_items_expected_max() > 0) return unset(*option);
    }
    return {};
  }

  // The parser reads -q1.apt as -q and the file -1.apt, as if that were a negative number.
  [[nodiscard]] std::string cut_positional(std::span<const char* const> words) const {
    for (const CLI::Option* option : app_->get_options()) {
      if (!option->get_positional()) continue;
      for (const std::string& value : option->results()) {
        const bool is_typed = std::find(words.begin(), words.end(), std::string_view(value)) != words.end();
        if (value.size() > 1 && value.front() == '-' && !is_typed) return unknown_option(value, words);
      }
    }
    return {};
  }

  // The parser takes whatever follows an option for its value.
  [[nodiscard]] std::string option_as_value() const {
    for (const CLI::Option* option : app_->get_options()) {
      if (option->get_items_expected_max() == 0) continue;
      for (const std::string& value : option->results()) {
        const std::string name = value.substr(0, value.find('='));
        if (!name.starts_with("--") || app_->get_option_no_throw(name) == nullptr) continue;
        return option->get_name() + " has no value: '" + name + "' behind it is an option; expected " +
               kind_of_value(*option) + see_help();
      }
    }
    return {};
  }

  [[nodiscard]] std::string explain(const CLI::ParseError& error, std::span<const char* const> words) const {
    const std::vector<std::string> strange = app_->remaining();
    const auto option = std::find_if(strange.begin(), strange.end(),
                                     [](const std::string& word) { return word.size() > 1 && word.front() == '-'; });
    const bool begins_with_word = !strange.empty() && !strange.front().starts_with('-');
    if (!commands_.empty() && begins_with_word) return no_command(strange);
    if (option != strange.end()) return unknown_option(option->substr(0, option->find('=')), words);
    if (!commands_.empty()) return no_command(strange);
    if (const CLI::Option* blamed = blamed_option(error.what())) {
      const std::string said = value_error(*blamed, error);
      if (!said.empty()) return said;
    }
    const std::string missing = missing_options();
    if (!missing.empty()) return name_ + " needs " + missing + see_help();
    if (!strange.empty()) return one_too_many(strange.front());
    return error.what() + see_help();
  }

 private:
  [[nodiscard]] static std::string unset(const CLI::Option& option) {
    return option.get_name() + " '': expected " + kind_of_value(option) + "; is a variable of your script unset?";
  }

  [[nodiscard]] static std::string kind_of_value(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    if (const std::vector<std::string> words = choices_in(type); !words.empty()) return listed(words, " or ");
    constexpr std::pair<std::string_view, const char*> kKinds[] = {{"FILE", "a file"},
                                                                   {"FOLDER", "a folder"},
                                                                   {"NAME", "a name"},
                                                                   {"LENGTH", "a length"},
                                                                   {"SIZE", "a size"},
                                                                   {"TEXT", "a text"},
                                                                   {"UINT", "a whole number of 0 or more"},
                                                                   {"FLOAT", "a number"},
                                                                   {"FLOAT:POSITIVE", "a number above 0"},
                                                                   {"MOVES:POSITIVE", "a whole number above 0"},
                                                                   {"SECONDS", "a number of seconds"},
                                                                   {"DEG", "degrees"},
                                                                   {"DEG/MM", "degrees for each mm"},
                                                                   {"DIALECT", "a dialect"},
                                                                   {"BLOCK", "a block of the program"},
                                                                   {"CODE", "a code"},
                                                                   {"WORD", "a word"},
                                                                   {"FIXTURE", "a fixture"},
                                                                   {"DAY", "a day, such as 2027-03-01"},
                                                                   {"N", "a number"},
                                                                   {"N|auto|all", "a number, auto or all"},
                                                                   {kWritableDialect, "a dialect that can be written"},
                                                                   {"DEG/MIN", "degrees a minute"}};
    for (const auto& [name, kind] : kKinds) {
      if (type == name) return kind;
    }
    return type;
  }

  [[nodiscard]] std::string see_help() const { return "; see " + name_ + " --help"; }

  // The parser takes letters that are options off a word like -vorne.apt.
  [[nodiscard]] static std::string as_typed(const std::string& word, std::span<const char* const> words) {
    if (word.starts_with("--")) return word;
    const auto typed = std::find_if(words.begin(), words.end(), [&](const std::string_view one) {
      return one.size() > 1 && one.front() == '-' && one[1] != '-' && one.ends_with(std::string_view(word).substr(1));
    });
    return typed == words.end() ? word : *typed;
  }

  [[nodiscard]] std::string unknown_option(const std::string& left, std::span<const char* const> words) const {
    const std::string word = as_typed(left, words);
    if (word == "--")
      return name_ + ": only files may stand behind '--'; expected the options before it: " + name_ +
             " OPTIONS -- FILE";
    std::vector<std::string> names;
    for (const CLI::Option* option : app_->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    std::string nearest = other_name(word, names);
    if (nearest.empty()) nearest = nearest_name(word, names);
    const bool is_file = !word.starts_with("--") && word.find('.') != std::string::npos;
    if (is_file) return name_ + " has no option '" + word + "'; a file of this name is written ./" + word;
    return name_ + " has no option '" + word + "'" + (nearest.empty() ? see_help() : meant(nearest));
  }

  /// Returns the name under which this command has an option of another command; empty if there is none.
  [[nodiscard]] static std::string other_name(const std::string& word, const std::vector<std::string>& names) {
    constexpr std::pair<std::string_view, std::string_view> kOtherNames[] = {{"--by", "--reviewer"}};
    for (const auto& [other, name] : kOtherNames) {
      if (word == other && std::ranges::find(names, name) != names.end()) return std::string(name);
    }
    return {};
  }

  [[nodiscard]] std::string no_command(const std::vector<std::string>& strange) const {
    if (strange.empty()) return "no command after " + name_ + "; expected " + listed(commands_, " or ");
    return is_no_command(strange.front(), name_, commands_);
  }

  [[nodiscard]] std::string missing_options() const {
    std::vector<std::string> missing;
    for (const CLI::Option* option : app_->get_options()) {
      if (option->get_required() && option->count() == 0) missing.push_back(option->get_name());
    }
    return listed(missing, " and ");
  }

  [[nodiscard]] std::string one_too_many(const std::string& word) const {
    std::vector<std::string> taken;
    for (const CLI::Option* option : app_->get_options()) {
      if (option->get_positional()) taken.push_back(option->get_name());
    }
    return "'" + word + "' is one argument too many; " + name_ + " takes " +
           (taken.empty() ? "options alone" : "one " + listed(taken, " and ") + " beside its options") +
           (is_check() ? ", and gougecheck batch takes several" : "") + see_help();
  }

  [[nodiscard]] bool is_check() const { return app_->get_name() == "check" || app_->get_name() == "correct"; }

  // The parser names the option in its text alone.
  [[nodiscard]] const CLI::Option* blamed_option(const std::string& text) const {
    const CLI::Option* blamed = nullptr;
    std::size_t first = std::string::npos;
    for (const CLI::Option* option : app_->get_options()) {
      const std::string name = option->get_name();
      const std::size_t at = text.find(name);
      if (at == std::string::npos || at > first) continue;
      const bool is_longer = at == first && blamed != nullptr && name.size() < blamed->get_name().size();
      if (is_longer) continue;
      first = at;
      blamed = option;
    }
    return blamed;
  }

  [[nodiscard]] std::string value_error(const CLI::Option& option, const CLI::ParseError& error) const {
    const std::string name = option.get_name();
    const std::string typed = name + " '" + (option.results().empty() ? "" : option.results().back()) + "': ";
    if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
      const std::string hint = option.results().empty() ? "" : decimal_comma_hint(option.results().back());
      return typed + "expected " + kind_of_value(option) + hint + see_help();
    }
    if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) return typed + wanted(option, error.what());
    if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) return std::string(error.what()) + see_help();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return {};
    if (option.count() > 1)
      return name + " is given " + std::to_string(option.count()) + " times; expected once" + see_help();
    if (option.get_items_expected_max() == 0) return name + " takes no value" + see_help();
    return name + " has no value; expected: " + option.get_description() + see_help();
  }

  // "--rapid: slow not in {straight,dogleg,skip}", or a sentence of our own after the name.
  [[nodiscard]] static std::string wanted(const CLI::Option& option, const std::string& text) {
    if (const std::vector<std::string> words = choices_in(text); !words.empty()) {
      const std::string value = option.results().empty() ? "" : in_small_letters(option.results().back());
      return "expected " + listed(words, " or ") + meant(nearest_name(value, words));
    }
    const std::size_t ours = text.find("expected ");
    if (ours != std::string::npos) return text.substr(ours);
    return option.get_type_name().find("POSITIVE") != std::string::npos ? "expected " + kind_of_value(option) : text;
  }

  const CLI::App* app_;
  std::string name_;
  std::vector<std::string> commands_;
};

}  // namespace

std::optional<Diagnostic> find_misread_value(const CLI::App& app, std::span<const char* const> words) {
  const Command command(app);
  std::string found = command.empty_value(words);
  if (found.empty()) found = command.option_as_value();
  if (found.empty()) found = command.cut_positional(words);
  if (found.empty()) return std::nullopt;
  return make_error("usage", found);
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::string meant(const std::string& name) { return name.empty() ? std::string() : "; did you mean " + name + "?"; }

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t kShortest = 3;
  if (word.size() + 1 < kShortest) return {};
  const auto is_begun = [&](const std::string& name) { return name.starts_with(word); };
  const auto begun = std::find_if(names.begin(), names.end(), is_begun);
  if (begun != names.end() && std::none_of(begun + 1, names.end(), is_begun)) return *begun;
  if (word.size() < kShortest) return {};
  // --units for --path-units.
  const std::string end = "-" + std::string(word.substr(std::min(word.find_first_not_of('-'), word.size())));
  const auto is_ended = [&](const std::string& name) { return word.starts_with("--") && name.ends_with(end); };
  if (const auto ended = std::find_if(names.begin(), names.end(), is_ended); ended != names.end()) return *ended;
  // "solidworks" for apt-solidworks-cam.
  const auto has_part = [&](const std::string& name) { return name.find("-" + std::string(word)) != name.npos; };
  const auto part = std::find_if(names.begin(), names.end(), has_part);
  if (part != names.end() && std::none_of(part + 1, names.end(), has_part)) return *part;
  return find_similar_name(word, names);
}

Diagnostic describe_parse_error(const CLI::App& app, const CLI::ParseError& error, std::span<const char* const> words) {
  const std::string beginning = explain_beginning(app, words);
  return make_error("usage", beginning.empty() ? Command(app).explain(error, words) : beginning);
}

}  // namespace gouge
