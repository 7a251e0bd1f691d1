#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "postproc/report/report_model.h"

namespace CLI {
class App;
}

// Options as rows of tables. The command line, help, manual pages, completions, project files, job lists and the
// `options` of a result follow these rows. To add an option, add a row and the field that it fills.

namespace gouge {

/// The group of options about a machine.
inline constexpr const char* kMachineGroup = "Machine";

/// Places where an option may be set beside the command line and job lists.
enum class Scope {
  command_line,  ///< nowhere: it names an output, overwrites, accepts or silences
  project        ///< in a project file too
};

/// Ways in which a result records an option beside its fixed fields (`options.more`).
enum class Recorded {
  no,
  shown,    ///< for readers of the result
  repeated  ///< `gougecheck verify` reads it back to repeat the check
};

/// One option of `Arguments`, as typed.
template <typename Arguments>
struct OptionRow {
  using Texts = std::vector<std::string>;
  /// Fills several fields of `Arguments` from all values of a repeatable option.
  using TakeTexts = void (*)(Arguments&, const Texts&);
  /// Adds an option whose values need a parser of its own.
  using AddOption = void (*)(CLI::App&, Arguments&);

  const char* name;  ///< "--tolerance", "-o,--output"
  std::variant<std::string Arguments::*, std::uint32_t Arguments::*, bool Arguments::*, Texts Arguments::*, TakeTexts,
               AddOption>
      field;
  const char* type = "";        ///< "FILE"; empty for a flag or a choice
  const char* group = nullptr;  ///< null: that of the row before
  std::string help = {};
  Scope scope = Scope::command_line;
  Recorded recorded = Recorded::no;
  std::vector<std::string> choices = {};
  const char* result_key = nullptr;                                ///< null: the name
  std::string (*result_text)(const std::string& typed) = nullptr;  ///< null: as typed
  bool is_required = false;
  const char* needs = nullptr;  ///< name of an option without which it may not be given

  /// Returns the long name without its dashes.
  [[nodiscard]] std::string key() const {
    const std::string all = name;
    return all.substr(all.rfind("--") + 2);
  }
  [[nodiscard]] std::string recorded_as() const { return result_key != nullptr ? result_key : key(); }
};

template <typename Arguments>
using OptionRows = std::vector<OptionRow<Arguments>>;

/// A row with the field that it fills.
struct BoundOption {
  const char *name, *type, *group, *needs;
  const std::string& help;
  const std::vector<std::string>& choices;
  bool is_required;
  std::variant<std::string*, std::uint32_t*, bool*, std::vector<std::string>*,
               std::function<void(const std::vector<std::string>&)>, std::function<void(CLI::App&)>>
      field;
};

/// Adds an option to a command. The row and the field must outlive it.
void add_option(CLI::App& command, const BoundOption& option);

/// Adds the options of `rows` to a command. Both must outlive it, as must `arguments`.
template <typename Arguments>
void add_options(CLI::App& command, Arguments& arguments, const OptionRows<Arguments>& rows) {
  for (const OptionRow<Arguments>& row : rows) {
    BoundOption bound{row.name, row.type, row.group, row.needs, row.help, row.choices, row.is_required, {}};
    std::visit(
        [&](auto field) {
          if constexpr (std::is_member_object_pointer_v<decltype(field)>) {
            bound.field = &(arguments.*field);
          } else if constexpr (std::is_same_v<decltype(field), typename OptionRow<Arguments>::AddOption>) {
            bound.field = std::function<void(CLI::App&)>([field, &arguments](CLI::App& app) { field(app, arguments); });
          } else {
            bound.field = std::function<void(const std::vector<std::string>&)>(
                [field, &arguments](const std::vector<std::string>& typed) { field(arguments, typed); });
          }
        },
        row.field);
    add_option(command, bound);
  }
}

/// Returns the rows that a project file may set.
template <typename Arguments>
OptionRows<Arguments> rows_of_projects(const OptionRows<Arguments>& rows) {
  OptionRows<Arguments> chosen;
  std::ranges::copy_if(rows, std::back_inserter(chosen),
                       [](const OptionRow<Arguments>& row) { return row.scope == Scope::project; });
  return chosen;
}

/// Returns the options in force of `rows` that a result records, as it names them. A repeatable one has an entry each.
template <typename Arguments>
std::vector<OptionText> recorded_options(const Arguments& arguments, const OptionRows<Arguments>& rows) {
  std::vector<OptionText> recorded;
  const auto add = [&](const OptionRow<Arguments>& row, const std::string& text) {
    if (!text.empty())
      recorded.push_back({row.recorded_as(), row.result_text != nullptr ? row.result_text(text) : text});
  };
  for (const OptionRow<Arguments>& row : rows) {
    if (row.recorded == Recorded::no) continue;
    if (const auto* const text = std::get_if<std::string Arguments::*>(&row.field)) add(row, arguments.**text);
    if (const auto* const flag = std::get_if<bool Arguments::*>(&row.field)) add(row, arguments.**flag ? "yes" : "");
    if (const auto* const texts = std::get_if<std::vector<std::string> Arguments::*>(&row.field)) {
      for (const std::string& one : arguments.**texts) add(row, one);
    }
  }
  return recorded;
}

/// Sets the options of `rows` that a verification repeats. `given(key, is_repeatable)` returns the texts that the
/// result has for a key.
template <typename Arguments, typename Given>
void repeat_options(Arguments& arguments, const OptionRows<Arguments>& rows, const Given& given) {
  for (const OptionRow<Arguments>& row : rows) {
    if (row.recorded != Recorded::repeated) continue;
    const bool is_repeatable = std::holds_alternative<std::vector<std::string> Arguments::*>(row.field);
    const std::vector<std::string> texts = given(row.recorded_as(), is_repeatable);
    if (texts.empty()) continue;
    if (const auto* const text = std::get_if<std::string Arguments::*>(&row.field)) arguments.** text = texts.front();
    if (const auto* const flag = std::get_if<bool Arguments::*>(&row.field)) arguments.** flag = true;
    if (const auto* const all = std::get_if<std::vector<std::string> Arguments::*>(&row.field))
      arguments.** all = texts;
  }
}

/// The values that an option takes, as a project file and a job list hold them.
struct OptionKind {
  std::string key, type;
  bool is_flag = false, is_repeatable = false;
  std::vector<std::string> choices;  ///< empty: any
};

/// Adds the options of `rows` that a project file may set.
template <typename Arguments>
void add_project_options(const OptionRows<Arguments>& rows, std::vector<OptionKind>& kinds) {
  using Row = OptionRow<Arguments>;
  for (const Row& row : rows) {
    if (row.scope != Scope::project) continue;
    const bool is_flag = std::holds_alternative<bool Arguments::*>(row.field);
    const bool is_repeatable = std::holds_alternative<std::vector<std::string> Arguments::*>(row.field) ||
                               std::holds_alternative<typename Row::TakeTexts>(row.field);
    kinds.push_back({row.key(), row.type, is_flag, is_repeatable, row.choices});
  }
}

}  // namespace gouge
