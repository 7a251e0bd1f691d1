#include "cli/options/option_table.h"

#include <CLI/CLI.hpp>

namespace gouge {
namespace {

using Texts = std::vector<std::string>;
using TakeTexts = std::function<void(const Texts&)>;

CLI::Option* add_value(CLI::App& command, const BoundOption& option) {
  if (auto* const* const text = std::get_if<std::string*>(&option.field)) {
    CLI::Option* const added = command.add_option(option.name, **text, option.help);
    return (*text)->empty() ? added : added->capture_default_str();
  }
  if (auto* const* const number = std::get_if<std::uint32_t*>(&option.field))
    return command.add_option(option.name, **number, option.help)->capture_default_str();
  if (auto* const* const flag = std::get_if<bool*>(&option.field))
    return command.add_flag(option.name, **flag, option.help);
  if (auto* const* const texts = std::get_if<Texts*>(&option.field))
    return command.add_option(option.name, **texts, option.help)->allow_extra_args(false);
  return command.add_option_function<Texts>(option.name, std::get<TakeTexts>(option.field), option.help)
      ->allow_extra_args(false);
}

}  // namespace

void add_option(CLI::App& command, const BoundOption& option) {
  if (option.group != nullptr) command.option_defaults()->group(option.group);
  if (const auto* const add = std::get_if<std::function<void(CLI::App&)>>(&option.field)) return (*add)(command);
  CLI::Option* const added = add_value(command, option);
  if (*option.type != '\0') added->type_name(option.type);
  if (!option.choices.empty()) added->check(CLI::IsMember(option.choices));
  if (option.is_required) added->required();
  if (option.needs != nullptr) added->needs(command.get_option(option.needs));
}

}  // namespace gouge
